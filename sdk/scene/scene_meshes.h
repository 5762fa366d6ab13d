// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Resolves the mesh files that a scene names.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include <meniscus/scene.h>

namespace meniscus {

/// Whether a mesh file's name is `glmark2:NAME`, which stands for a model of Debian's glmark2-data.
bool is_mesh_alias(const std::string& file);

/// Replaces the names of mesh files by paths: aliases by what they stand for, relative ones by those from
/// `folder`. Hulls get the vertices of the files that their part of the `document`, which the scene was read
/// from, names. Throws Error(io) for a file name that is empty or not there, and for a hull's file what
/// load_mesh throws. Meshes whose vertices stand in the scene need no file. With WorldDef::read_file of the
/// scene, that is asked in place of the file system, and there are no aliases. Motion files become keyframes;
/// throws what read_keyframes throws.
void resolve_meshes(Scene& scene, const nlohmann::json& document, const std::filesystem::path& folder,
                    const std::string& source);

}  // namespace meniscus
