// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The formats of mesh files that are read.
#include "collision/mesh/file/format.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>

#include "collision/mesh/file/defect.h"

namespace meniscus::collision {

namespace {

struct Extension {
  std::string_view text;
  MeshFormat format;
};

constexpr std::array<Extension, 8> extensions{{
    {"obj", MeshFormat::obj},
    {"ply", MeshFormat::ply},
    {"stl", MeshFormat::stl},
    {"gltf", MeshFormat::gltf},
    {"glb", MeshFormat::gltf},
    {"fbx", MeshFormat::fbx},
    {"dae", MeshFormat::dae},
    {"3ds", MeshFormat::three_ds},
}};

}  // namespace

std::string extension_of(const std::string& path) {
  std::string text = std::filesystem::path(path).extension().string();
  if (!text.empty()) text.erase(0, 1);
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

MeshFormat format_of(const std::string& path) {
  const std::string extension = extension_of(path);
  std::string list;
  for (const Extension& known : extensions) {
    if (known.text == extension) return known.format;
    list += (list.empty() ? "." : ", .") + std::string(known.text);
  }
  throw FileDefect("has the extension " + in_quotes(extension) + "; meshes are read from " + list);
}

}  // namespace meniscus::collision
