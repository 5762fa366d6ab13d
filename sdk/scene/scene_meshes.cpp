// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Resolves the mesh files that a scene names, and reads its motion files.
#include "sdk/scene/scene_meshes.h"

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "collision/mesh/sequence.h"
#include "sdk/scene/scene_place.h"

namespace meniscus {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::string_view alias = "glmark2:";

fs::path alias_folder() {
  const char* chosen = std::getenv("MENISCUS_GLMARK2_DIR");
  return chosen && *chosen ? chosen : "/usr/share/glmark2/models";
}

bool is_readable_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored) && std::ifstream(path).good();
}

/// Where the mesh files of a scene are.
class SceneFiles {
 public:
  SceneFiles(const fs::path& folder, const FileReader& reader) : folder_(folder), reader_(reader) {}

  void resolve(std::string& file, const ScenePlace& place) const {
    if (file.empty()) {
      place.fail("this scene needs a mesh file of yours", "pass --set " + place.path + "=PATH",
                 ErrorCode::io);
    }
    const bool aliased = !reader_ && is_mesh_alias(file);
    const fs::path path = aliased ? alias_folder() / file.substr(alias.size()) : folder_ / file;
    const std::string name = path.lexically_normal().string();
    if (reader_ ? !reader_(name) : !is_readable_file(path)) {
      const std::string remedy =
          aliased ? "install Debian's package glmark2-data, or set MENISCUS_GLMARK2_DIR to the "
                    "folder that holds the models"
                  : "";
      place.fail("cannot read mesh file \"" + path.string() + "\"", remedy, ErrorCode::io);
    }
    file = name;
  }
  /// Of a definition that may have vertices instead.
  template <class Def>
  void resolve_in(Def* def, const ScenePlace& place) const {
    if (!def) return;
    if constexpr (requires { def->vertices; }) {
      if (!def->vertices.empty() || !def->triangles.empty()) return;
    }
    resolve(def->file, place.key("file"));
  }

  /// All files of a driven surface must be there before a run starts.
  void resolve_numbered(DrivenFiles& driven, const ScenePlace& place) const {
    try {
      for (int number = driven.first; number <= driven.last; ++number) {
        std::string file = collision::numbered_path(driven.files, number);
        resolve(file, place.key("files"));
      }
    } catch (const SceneError&) {
      throw;
    } catch (const Error& error) {
      place.key("files").fail(error.what(), "", error.code());
    }
    driven.files = (folder_ / driven.files).lexically_normal().string();
  }

  void read_motion(SceneBody& body, const ScenePlace& place) const {
    if (!body.motion_file) return;
    MotionFile motion = *body.motion_file;
    motion.file = (folder_ / motion.file).lexically_normal().string();
    try {
      body.def.keyframes = read_keyframes(motion, reader_);
    } catch (const Error& error) {
      place.fail(error.what(), "", error.code());
    }
    body.def.pose = body.def.keyframes.front().pose;
  }

  void resolve_in(Geometry& geometry, const Json& json, const ScenePlace& place) const {
    std::visit([&](auto& g) { resolve_solid(g, json, place); }, geometry);
  }

 private:
  void resolve_solid(MeshGeometry& mesh, const Json&, const ScenePlace& place) const {
    resolve_in(&mesh, place);
  }

  void resolve_solid(HullGeometry& hull, const Json& json, const ScenePlace& place) const {
    if (!json.contains("file")) return;
    std::string file = json["file"];
    resolve(file, place.key("file"));
    try {
      const collision::TriangleMesh mesh =
          collision::load_mesh(collision::MeshSource(file, json.value("scale", 1.0f), reader_));
      hull.points.insert(hull.points.end(), mesh.vertices.begin(), mesh.vertices.end());
    } catch (const Error& error) {
      place.key("file").fail(error.what(), "", error.code());
    }
  }

  void resolve_solid(CompoundGeometry& compound, const Json& json, const ScenePlace& place) const {
    for (std::size_t i = 0; i < compound.parts.size(); ++i) {
      resolve_in(compound.parts[i].geometry, json["parts"][i]["geometry"],
                 place.key("parts").item(i).key("geometry"));
    }
  }

  template <class Other>
  void resolve_solid(Other&, const Json&, const ScenePlace&) const {}

  const fs::path& folder_;
  const FileReader& reader_;
};

}  // namespace

bool is_mesh_alias(const std::string& file) {
  return file.starts_with(alias);
}

void resolve_meshes(Scene& scene, const Json& document, const fs::path& folder, const std::string& source) {
  const ScenePlace root{source, ""};
  const SceneFiles files(folder, scene.world.read_file);
  const auto resolve_solid = [&](Geometry& geometry, const char* list, std::size_t i) {
    files.resolve_in(geometry, document[list][i]["geometry"], root.key(list).item(i).key("geometry"));
  };
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) resolve_solid(scene.shapes[i].geometry, "shapes", i);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    resolve_solid(scene.bodies[i].def.geometry, "bodies", i);
  const auto resolve = [&](auto* mesh, const char* list, std::size_t i, const char* key) {
    files.resolve_in(mesh, root.key(list).item(i).key(key));
  };
  for (std::size_t i = 0; i < scene.volumes.size(); ++i)
    resolve(std::get_if<MeshRegion>(&scene.volumes[i].def.region), "volumes", i, "region");
  for (std::size_t i = 0; i < scene.emitters.size(); ++i)
    resolve(std::get_if<MeshOpening>(&scene.emitters[i].def.opening), "emitters", i, "opening");
  for (std::size_t i = 0; i < scene.cloths.size(); ++i) {
    resolve(std::get_if<ClothFile>(&scene.cloths[i].geometry), "cloths", i, "geometry");
    if (auto* driven = std::get_if<DrivenFiles>(&scene.cloths[i].geometry))
      files.resolve_numbered(*driven, root.key("cloths").item(i).key("geometry"));
  }
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    files.read_motion(scene.bodies[i], root.key("bodies").item(i).key("motion_file"));
}

}  // namespace meniscus
