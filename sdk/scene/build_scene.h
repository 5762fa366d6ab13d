// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Builds worlds of scenes for ranks that will share them.
#pragma once

#include <meniscus/scene.h>

namespace meniscus {

/// Like build_scene(), but the particles stay on the host until the world is shared: see
/// SharedWorld::hold_back().
BuiltScene build_scene_to_share(const Scene& scene);

}  // namespace meniscus
