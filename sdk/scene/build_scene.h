// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Builds worlds of scenes that are prepared before anything is in them.
#pragma once

#include <meniscus/scene.h>

#include <functional>

namespace meniscus {

/// Like the other build_scene(). Calls prepare(world) first, while the world is empty.
BuiltScene build_scene(const Scene& scene, const std::function<void(World&)>& prepare);

}  // namespace meniscus
