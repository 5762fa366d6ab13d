// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What `meniscus check` says of a scene's mesh files.
#pragma once

#include <meniscus/scene.h>

namespace meniscus::cli {

/// Prints size, unit and defects of each mesh file, once. Warns of a mesh that is tiny or huge beside the
/// particle spacing.
void print_meshes(const Scene& scene);

}  // namespace meniscus::cli
