// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reports on the mesh files of a scene.
#include "sdk/cli/commands/scene_mesh_report.h"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "collision/mesh/inspect.h"
#include "pbd/math/vec.h"
#include "sdk/io/plain_text.h"

namespace meniscus::cli {

namespace {

/// Spacings: below the first no particle resolves a mesh; beyond the second its field has billions of cells.
constexpr float tiny = 2, huge = 1000;

struct MeshFile {
  std::string file;
  float scale;

  bool operator==(const MeshFile&) const = default;
};

/// The mesh files of a scene, each with each scale once, in the scene's order.
class MeshFiles {
 public:
  std::vector<MeshFile> files;

  void add(const std::string& file, float scale) {
    const MeshFile found{file, scale};
    if (std::ranges::find(files, found) == files.end()) files.push_back(found);
  }
  void operator()(const MeshGeometry& g) { add(g.file, g.scale); }
  void operator()(const MeshRegion& r) { add(r.file, r.scale); }
  void operator()(const MeshOpening& o) { add(o.file, o.scale); }
  void operator()(const ClothFile& c) { add(c.file, c.scale); }
  void operator()(const CompoundGeometry& g) {
    for (const CompoundPart& part : g.parts) std::visit(*this, part.geometry);
  }
  template <class Other>
  void operator()(const Other&) {}
};

std::vector<MeshFile> files_of(const Scene& scene) {
  MeshFiles found;
  for (const ShapeDef& shape : scene.shapes) std::visit(found, shape.geometry);
  for (const SceneBody& body : scene.bodies) std::visit(found, body.def.geometry);
  for (const SceneVolume& volume : scene.volumes) std::visit(found, volume.def.region);
  for (const SceneEmitter& emitter : scene.emitters) std::visit(found, emitter.def.opening);
  for (const ClothDef& cloth : scene.cloths) std::visit(found, cloth.geometry);
  return std::move(found.files);
}

void warn_of_size(const std::string& file, float longest, float spacing) {
  if (longest < tiny * spacing) {
    spdlog::warn(
        "mesh {} is tiny: its longest side, {:.3g} m, is {:.2g} particle spacings; is its scale right?", file,
        longest, longest / spacing);
  } else if (longest > huge * spacing) {
    spdlog::warn(
        "mesh {} is huge: its longest side, {:.3g} m, is {:.2g} particle spacings; is its scale right?", file,
        longest, longest / spacing);
  }
}

}  // namespace

void print_meshes(const Scene& scene) {
  for (const auto& [path, scale] : files_of(scene)) {
    const collision::MeshReport mesh = collision::inspect_mesh(path, scale);
    const std::string file = io::plain_text(path);
    const Vec3 size = mesh.box.upper - mesh.box.lower;
    const float longest = max_component(size);
    fmt::print("  mesh {}\n", file);
    fmt::print(
        "    {:.4g} × {:.4g} × {:.4g} m from ({:.4g}, {:.4g}, {:.4g}), volume {:.4g} m³, unit guess {}, "
        "scale "
        "{:.4g}\n",
        size.x, size.y, size.z, mesh.box.lower.x, mesh.box.lower.y, mesh.box.lower.z, mesh.volume,
        collision::unit_guess(longest / scale), scale);
    fmt::print(
        "    triangles {}, dropped {}, vertices welded {}, holes {} of {} open edges, odd edges {}, "
        "crossings {}\n",
        mesh.triangles, mesh.dropped, mesh.welded, mesh.holes, mesh.open_edges, mesh.odd_edges,
        mesh.crossings);
    warn_of_size(file, longest, scene.world.particle_spacing);
  }
}

}  // namespace meniscus::cli
