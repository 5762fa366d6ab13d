// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Snapshots of a run: writes them, and continues from one.
#pragma once

#include <filesystem>
#include <string>

#include <meniscus/scene.h>

namespace meniscus::cli {

/// The scene with the state of a file that a run of it has saved. The scene's device and threads count.
/// Throws what World::load throws, and Error(invalid_argument) if the file is of a world with other contents.
BuiltScene resume_scene(const Scene& scene, const std::string& file);

/// The number of the frame that a world has reached.
int frame_of(const World& world, const Scene& scene);

/// FOLDER/snapshot_00050.menisnap
std::filesystem::path snapshot_path(const std::filesystem::path& folder, int frame);

}  // namespace meniscus::cli
