// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Loads the meshes of solids.
#include "sdk/world/solids/solid_mesh.h"

#include <algorithm>
#include <utility>

#include "collision/mesh/convex_parts.h"
#include "collision/mesh/defects.h"
#include "collision/mesh/mesh.h"
#include "collision/sdf/repair.h"
#include "pbd/math/vec.h"
#include "sdk/world/solids/tuning.h"

namespace meniscus {

using collision::TriangleMesh;

SolidMesh SolidMeshes::load(const MeshGeometry& def, float cell_size, bool dynamic, const FileReader& files) {
  SolidMesh solid;
  const bool must_be_closed = dynamic && !def.repair;
  const auto source = collision::MeshSource::of(def, files);
  solid.mesh = std::make_shared<const TriangleMesh>(must_be_closed ? collision::load_solid(source)
                                                                   : collision::load_mesh(source));
  if (def.repair) repair(solid, source, cell_size);
  if (dynamic) cut(solid, def.convex_parts);
  return solid;
}

void SolidMeshes::repair(SolidMesh& solid, const collision::MeshSource& from, float cell_size) {
  const Aabb box = collision::bounds(*solid.mesh);
  cell_size = std::min(cell_size, max_component(box.upper - box.lower) / solids_tuning::repair_cells);
  const collision::MeshHash source = collision::hash_of(*solid.mesh);
  std::erase_if(repaired_, [](const Repaired& entry) { return entry.mesh.expired(); });
  for (const Repaired& entry : repaired_) {
    if (entry.source != source || entry.cell_size != cell_size) continue;
    solid.mesh = entry.mesh.lock();
    solid.repair = entry.repair;
    solid.repair->file = from.file;
    return;
  }
  const collision::MeshDefects defects = collision::find_defects(*solid.mesh);
  if (defects.none()) return;
  collision::RepairedMesh made = collision::repair_mesh(*solid.mesh, cell_size, from.name());
  solid.mesh = std::make_shared<const TriangleMesh>(std::move(made.mesh));
  solid.repair = {from.file,
                  made.cell_size,
                  made.deviation,
                  made.volume_before,
                  made.volume,
                  defects.open_edges.size(),
                  defects.non_manifold_edges.size(),
                  defects.self_intersections.size()};
  repaired_.push_back({source, cell_size, solid.mesh, *solid.repair});
}

void SolidMeshes::cut(SolidMesh& solid, int parts) {
  const collision::MeshHash source = collision::hash_of(*solid.mesh);
  const auto is_gone = [](const auto& hull) { return hull.expired(); };
  std::erase_if(made_, [&](const Made& entry) { return std::ranges::any_of(entry.hulls, is_gone); });
  for (const Made& entry : made_) {
    if (entry.source != source || entry.parts != parts) continue;
    for (const auto& hull : entry.hulls) solid.hulls.push_back(hull.lock());
    return;
  }
  if (parts > 1) {
    collision::ConvexParts cut = collision::convex_parts(*solid.mesh, parts);
    for (TriangleMesh& hull : cut.hulls)
      solid.hulls.push_back(std::make_shared<const TriangleMesh>(std::move(hull)));
  }
  if (solid.hulls.size() < 2) solid.hulls = {solid.mesh};
  made_.push_back({source, parts, {solid.hulls.begin(), solid.hulls.end()}});
}

}  // namespace meniscus
