// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sdk/scene/scene.h"

namespace meniscus::cli {

/// The file of a scene that is given by its path, or by the name of a sample: NAME.json in the folder that
/// the environment's MENISCUS_SAMPLES_DIR names, else where the program is installed, else in the source
/// tree's samples/scenes. Throws Error(io), which lists the samples.
std::string scene_path(const std::string& scene);

/// The names of all samples, in the order of the alphabet.
std::vector<std::string> sample_names();

/// A scene as the command line names it, and where it is to run.
struct SceneChoice {
  std::string scene;  ///< a file, or a sample's name
  std::vector<std::string> overrides;
  std::string device;          ///< auto, cpu or cuda; empty: the scene's
  std::optional<int> threads;  ///< likewise
};

/// Its file's contents, with what the command line changes. Throws what find_scene throws.
nlohmann::json chosen_document(const SceneChoice& choice);
Scene chosen_scene(const SceneChoice& choice);

/// out/<scene name>.
std::filesystem::path default_folder(const Scene& scene);

/// Reads it; a scene without a name is called after its file. Throws what scene_path and read_scene throw.
Scene find_scene(const std::string& scene, std::span<const std::string> overrides);

}  // namespace meniscus::cli
