// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads a scene file and makes a Scene of it.
#include "sdk/scene/scene_file.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>
#include <vector>

#include "pbd/host_memory.h"
#include "sdk/scene/scene_document.h"
#include "sdk/scene/scene_meshes.h"
#include "sdk/scene/scene_override.h"
#include "sdk/scene/scene_place.h"

namespace meniscus {
namespace {

using Json = nlohmann::json;

constexpr std::size_t most_bytes = std::size_t{256} << 20;  ///< a hundred times the largest sample, and more

std::string read_text(const std::string& path) {
  const ScenePlace place{path, ""};
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    place.fail("is a folder, not a scene file", "", ErrorCode::io);
  std::ifstream file(path, std::ios::binary);
  if (!file) place.fail("cannot be read: " + std::generic_category().message(errno), "", ErrorCode::io);
  // A pipe or a device need not end.
  std::string text;
  for (std::vector<char> block(std::size_t{1} << 16); file;) {
    file.read(block.data(), std::ptrdiff_t(block.size()));
    text.append(block.data(), std::size_t(file.gcount()));
    if (text.size() > most_bytes) {
      place.fail(
          "is longer than " + std::to_string(most_bytes) + " bytes, the most that a scene file may have", "",
          ErrorCode::io);
    }
  }
  if (file.bad()) place.fail("cannot be read to its end", "", ErrorCode::io);
  return text;
}

SceneDocument document_of(const std::string& path, std::span<const std::string> overrides) {
  SceneDocument document = parse_document(read_text(path), path);
  // What is no object is refused when it is read as a scene.
  if (!document.value.is_object()) return document;
  for (const std::string& text : overrides) apply_override(document.value, text);
  return document;
}

}  // namespace

Scene read_scene(const std::string& path, std::span<const std::string> overrides) {
  return pbd::with_host_memory([&] { return scene_of_document(document_of(path, overrides).value, path); });
}

Scene read_scene_text(const std::string& text, const std::string& folder, const std::string& source,
                      const FileReader& read_file) {
  return pbd::with_host_memory([&] {
    const SceneDocument document = parse_document(text, source);
    Scene scene = parse_scene(document.value, source);
    scene.world.read_file = read_file;
    resolve_meshes(scene, document.value, folder, source);
    return scene;
  });
}

Json read_document(const std::string& path, std::span<const std::string> overrides) {
  return pbd::with_host_memory([&] { return std::move(document_of(path, overrides).value); });
}

Scene scene_of_document(const Json& document, const std::string& path) {
  return pbd::with_host_memory([&] {
    Scene scene = parse_scene(document, path);
    resolve_meshes(scene, document, std::filesystem::path(path).parent_path(), path);
    return scene;
  });
}

}  // namespace meniscus
