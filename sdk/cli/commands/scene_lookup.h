// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How the command line names a scene, and how its file is found and read.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <meniscus/scene.h>

namespace meniscus::cli {

/// Returns the file of a scene that is given by its path or by the name of a sample. A sample is NAME.json in
/// the folder of the environment variable MENISCUS_SAMPLES_DIR. If that is not set, it is in the
/// installation, or else in the source tree's samples/scenes. Throws Error(io), which lists the samples.
std::string scene_path(const std::string& scene);

/// The names of all samples, in alphabetical order.
std::vector<std::string> sample_names();

/// A scene as the command line names it, and the device for it.
struct SceneChoice {
  std::string scene;  ///< a file or the name of a sample
  std::vector<std::string> overrides;
  std::string device;          ///< auto, cpu or cuda; empty: the scene's
  std::optional<int> threads;  ///< likewise
};

/// The contents of its file, with the changes of the command line. Throws what find_scene throws.
nlohmann::json chosen_document(const SceneChoice& choice);
Scene chosen_scene(const SceneChoice& choice);

/// out/<scene name>.
std::filesystem::path default_folder(const Scene& scene);

/// Reads a scene. A scene without a name gets that of its file. Throws what scene_path and read_scene throw.
Scene find_scene(const std::string& scene, std::span<const std::string> overrides);

}  // namespace meniscus::cli
