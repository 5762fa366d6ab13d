// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "sdk/scene/scene.h"

namespace meniscus {

/// Whether a mesh file's name is `glmark2:NAME`, which stands for a model of Debian's glmark2-data.
bool is_mesh_alias(const std::string& file);

/// Replaces the names of mesh files by paths: aliases by what they stand for, relative ones by those from
/// `folder`. Throws Error(io) for one that is empty or not there.
void resolve_meshes(Scene& scene, const std::filesystem::path& folder, const std::string& source);

}  // namespace meniscus
