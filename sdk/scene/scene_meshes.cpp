// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/scene/scene_meshes.h"

#include <cstdlib>
#include <fstream>

#include "sdk/scene/scene_place.h"

namespace meniscus {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view alias = "glmark2:";

fs::path alias_folder() {
  const char* chosen = std::getenv("MENISCUS_GLMARK2_DIR");
  return chosen && *chosen ? chosen : "/usr/share/glmark2/models";
}

bool is_readable_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored) && std::ifstream(path).good();
}

void resolve(std::string& file, const fs::path& folder, const ScenePlace& place) {
  if (file.empty()) {
    place.fail("this scene needs a mesh file of yours; pass --set " + place.path + "=PATH", ErrorCode::io);
  }
  const bool aliased = is_mesh_alias(file);
  const fs::path path = aliased ? alias_folder() / file.substr(alias.size()) : folder / file;
  if (!is_readable_file(path)) {
    const std::string remedy =
        aliased ? "; install Debian's package glmark2-data, or set MENISCUS_GLMARK2_DIR to the "
                  "folder that holds the models"
                : "";
    place.fail("cannot read mesh file \"" + path.string() + "\"" + remedy, ErrorCode::io);
  }
  file = path.lexically_normal().string();
}

}  // namespace

bool is_mesh_alias(const std::string& file) {
  return file.starts_with(alias);
}

void resolve_meshes(Scene& scene, const fs::path& folder, const std::string& source) {
  const ScenePlace root{source, ""};
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    auto* mesh = std::get_if<MeshGeometry>(&scene.shapes[i].geometry);
    if (mesh) resolve(mesh->file, folder, root.key("shapes").item(i).key("geometry").key("file"));
  }
  for (std::size_t i = 0; i < scene.volumes.size(); ++i) {
    auto* mesh = std::get_if<MeshRegion>(&scene.volumes[i].def.region);
    if (mesh) resolve(mesh->file, folder, root.key("volumes").item(i).key("region").key("file"));
  }
}

}  // namespace meniscus
