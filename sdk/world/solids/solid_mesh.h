// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Meshes of solids: loaded, repaired on request, and cut into convex parts, once for equal meshes.
#pragma once

#include <meniscus/defs.h>
#include <meniscus/outputs.h>

#include <memory>
#include <optional>
#include <vector>

#include "collision/mesh/hash.h"
#include "collision/mesh/source.h"

namespace meniscus {

struct SolidMesh {
  std::shared_ptr<const collision::TriangleMesh> mesh;
  /// Of a dynamic body: the convex parts for Bullet. A single one is the mesh itself, and its hull counts.
  std::vector<std::shared_ptr<const collision::TriangleMesh>> hulls;
  std::optional<MeshRepair> repair;
};

/// What was made of a world's meshes, as long as a solid uses it.
class SolidMeshes {
 public:
  /// Throws what load_mesh, load_solid, repair_mesh and convex_parts throw. A grid of repair has cells of at
  /// most cell_size (m).
  SolidMesh load(const MeshGeometry& def, float cell_size, bool dynamic, const FileReader& files = {});

 private:
  struct Made {
    collision::MeshHash source;
    int parts;
    std::vector<std::weak_ptr<const collision::TriangleMesh>> hulls;
  };
  struct Repaired {
    collision::MeshHash source;
    float cell_size;
    std::weak_ptr<const collision::TriangleMesh> mesh;
    MeshRepair repair;
  };

  void repair(SolidMesh& solid, const collision::MeshSource& from, float cell_size);
  void cut(SolidMesh& solid, int parts);

  std::vector<Made> made_;
  std::vector<Repaired> repaired_;
};

}  // namespace meniscus
