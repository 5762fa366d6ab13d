// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Where a mesh comes from: a file, or triangles in memory.
#pragma once

#include <meniscus/defs.h>

#include <span>
#include <string>
#include <utility>

namespace meniscus::collision {

/// Names a mesh. The spans and the reader must outlive it.
struct MeshSource {
  explicit MeshSource(std::string path, float metres = 1.0f, const FileReader& files = {})
      : file(std::move(path)), scale(metres), read_file(files) {}
  /// Of a definition that names a file or has triangles.
  template <class Def>
  static MeshSource of(const Def& def, const FileReader& files = {}) {
    MeshSource source(def.file, def.scale, files);
    if constexpr (requires { def.vertices; }) {
      source.vertices = def.vertices;
      source.triangles = def.triangles;
    }
    return source;
  }

  bool in_memory() const { return !vertices.empty() || !triangles.empty(); }
  /// As errors name it: "mesh file 'PATH'", "mesh 'NAME' in memory" or "mesh in memory".
  std::string name() const {
    if (!in_memory()) return "mesh file '" + file + "'";
    return file.empty() ? "mesh in memory" : "mesh '" + file + "' in memory";
  }

  std::string file;  ///< a path, or what `read_file` takes; of a mesh in memory, its name
  float scale;       ///< metres a unit
  FileReader read_file;
  std::span<const Vec3> vertices{};
  std::span<const uint32_t> triangles{};
};

}  // namespace meniscus::collision
