// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Warnings about scenes that are valid but probably not intended.
#pragma once

#include <meniscus/scene.h>

#include <string>
#include <vector>

namespace meniscus::cli {

/// What a scene probably does not intend: a volume without particles, nothing that can move, substeps that
/// are far too long, and what World::warnings() finds. Also which meshes were repaired, and how well.
std::vector<std::string> oddities_of(const Scene& scene, const BuiltScene& built);

/// Logs them as warnings.
void warn_of_oddities(const Scene& scene, const BuiltScene& built);

}  // namespace meniscus::cli
