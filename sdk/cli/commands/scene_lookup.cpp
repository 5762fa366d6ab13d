// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds scenes by path or by the name of a sample, and applies the command line's overrides.
#include "sdk/cli/commands/scene_lookup.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "sdk/io/plain_text.h"
#include "sdk/scene/scene_file.h"

namespace meniscus::cli {
namespace {

namespace fs = std::filesystem;

fs::path samples_folder() {
  if (const char* chosen = std::getenv("MENISCUS_SAMPLES_DIR")) return chosen;
  std::error_code unknown;
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
  const fs::path installed = program.parent_path().parent_path() / MENISCUS_INSTALLED_SAMPLES;
  return fs::is_directory(installed, unknown) ? installed : fs::path(MENISCUS_SAMPLES_DIR);
}

std::string list_of_samples() {
  std::string list;
  for (const std::string& name : sample_names()) list += (list.empty() ? "" : ", ") + name;
  return list.empty() ? "none in " + samples_folder().string() : list;
}

}  // namespace

std::vector<std::string> sample_names() {
  std::vector<std::string> names;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(samples_folder(), missing)) {
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string scene_path(const std::string& scene) {
  std::error_code refused;  // for example, a name that is too long is no file
  if (fs::exists(scene, refused) && !fs::is_directory(scene, refused)) return scene;  // a pipe is allowed
  const fs::path sample = samples_folder() / (scene + ".json");
  if (scene.find('/') == std::string::npos && fs::is_regular_file(sample, refused)) return sample.string();
  if (fs::is_directory(scene, refused))
    throw Error(ErrorCode::io, "'" + scene + "' is a folder, not a scene file");
  throw Error(ErrorCode::io,
              "no scene file and no sample is called '" + scene + "'; samples: " + list_of_samples());
}

Scene find_scene(const std::string& scene, std::span<const std::string> overrides) {
  const std::string path = scene_path(scene);
  Scene found = read_scene(path, overrides);
  if (found.name.empty()) found.name = fs::path(path).stem().string();
  return found;
}

namespace {

/// What the choice changes in the file.
std::vector<std::string> changes_of(const SceneChoice& choice) {
  std::vector<std::string> changes = choice.overrides;
  if (!choice.device.empty()) changes.push_back("world.device=" + choice.device);
  if (choice.threads) changes.push_back("world.threads=" + std::to_string(*choice.threads));
  return changes;
}

}  // namespace

nlohmann::json chosen_document(const SceneChoice& choice) {
  return read_document(scene_path(choice.scene), changes_of(choice));
}

Scene chosen_scene(const SceneChoice& choice) {
  return read_scene(scene_path(choice.scene), changes_of(choice));
}

fs::path default_folder(const Scene& scene) {
  // A name is not a path.
  std::string name = io::plain_text(scene.name);
  std::replace(name.begin(), name.end(), '/', '_');
  if (name == "." || name == "..") name = "scene";
  return fs::path("out") / name;
}

}  // namespace meniscus::cli
