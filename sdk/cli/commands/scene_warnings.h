// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Warnings about scenes that are valid but probably not intended.
#pragma once

#include <meniscus/scene.h>

namespace meniscus::cli {

/// Warns of what a scene probably does not intend: a volume without particles, nothing that can move, and
/// what World::warnings() finds. Says which meshes were repaired, and how well.
void warn_of_oddities(const BuiltScene& built);

}  // namespace meniscus::cli
