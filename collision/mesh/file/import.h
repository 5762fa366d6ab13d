// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Imports a mesh file of any format that is read.
#pragma once

#include <assimp/Importer.hpp>
#include <memory>
#include <string>

#include "collision/mesh/file/assimp_io.h"

struct aiScene;

namespace meniscus::collision {

/// The contents of a mesh file as assimp's scene, with polygons triangulated. PLY and STL are read by
/// readers of our own, OBJ is checked by us, and assimp reads it and the other formats.
class MeshImport {
 public:
  /// Throws Error(io) if the file cannot be read, Error(out_of_memory), FileDefect, and what `read_file`
  /// throws.
  explicit MeshImport(const std::string& path, const FileReader& read_file = {});

  const aiScene& scene() const;

 private:
  void choose_reader(const std::string& path);
  void import(const std::string& path);
  [[noreturn]] void fail() const;

  ImportBudget budget_;
  FileSource files_;
  std::string bytes_;
  Assimp::Importer importer_;  // owns what it is given: files, progress handler, readers and the scene
};

}  // namespace meniscus::collision
