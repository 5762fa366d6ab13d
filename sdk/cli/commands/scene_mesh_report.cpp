// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reports on the mesh files of a scene.
#include "sdk/cli/commands/scene_mesh_report.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <string>
#include <variant>
#include <vector>

#include "collision/mesh/inspect.h"
#include "collision/mesh/source.h"
#include "pbd/math/vec.h"
#include "sdk/cli/record/json_text.h"
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

  /// Triangles that stand in the scene have no file.
  template <class Def>
  void add(const Def& def) {
    const auto source = collision::MeshSource::of(def);
    const MeshFile found{def.file, def.scale};
    if (source.in_memory()) return;
    if (std::ranges::find(files, found) == files.end()) files.push_back(found);
  }
  void operator()(const MeshGeometry& g) { add(g); }
  void operator()(const MeshRegion& r) { add(r); }
  void operator()(const MeshOpening& o) { add(o); }
  void operator()(const ClothFile& c) { add(c); }
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

/// Null where the size is usual.
nlohmann::ordered_json size_warning(const std::string& file, float longest, float spacing) {
  if (longest >= tiny * spacing && longest <= huge * spacing) return nullptr;
  return fmt::format(
      "mesh {} is {}: its longest side, {:.3g} m, is {:.2g} particle spacings; is its scale right?", file,
      longest < tiny * spacing ? "tiny" : "huge", longest, longest / spacing);
}

nlohmann::ordered_json json_of(Vec3 v) {
  return {without_noise(v.x), without_noise(v.y), without_noise(v.z)};
}

nlohmann::ordered_json report_of(const MeshFile& of, float spacing) {
  const collision::MeshReport mesh = collision::inspect_mesh(of.file, of.scale);
  const std::string file = io::plain_text(of.file);
  const Vec3 size = mesh.box.upper - mesh.box.lower;
  const float longest = max_component(size);
  return {{"file", file},
          {"size_m", json_of(size)},
          {"lower_m", json_of(mesh.box.lower)},
          {"volume_m3", without_noise(mesh.volume)},
          {"unit_guess", collision::unit_guess(longest / of.scale)},
          {"scale", without_noise(of.scale)},
          {"triangles", mesh.triangles},
          {"dropped", mesh.dropped},
          {"welded", mesh.welded},
          {"holes", mesh.holes},
          {"open_edges", mesh.open_edges},
          {"odd_edges", mesh.odd_edges},
          {"crossings", mesh.crossings},
          {"warning", size_warning(file, longest, spacing)}};
}

}  // namespace

nlohmann::ordered_json mesh_reports(const Scene& scene) {
  nlohmann::ordered_json reports = nlohmann::ordered_json::array();
  for (const MeshFile& file : files_of(scene))
    reports.push_back(report_of(file, scene.world.particle_spacing));
  return reports;
}

std::string mesh_text(const nlohmann::ordered_json& report) {
  const auto number = [&](const char* key) { return report.at(key).get<double>(); };
  const auto count = [&](const char* key) { return report.at(key).get<std::size_t>(); };
  const auto size = report.at("size_m").get<std::array<double, 3>>();
  const auto lower = report.at("lower_m").get<std::array<double, 3>>();
  return fmt::format("  mesh {}\n", report.at("file").get<std::string>()) +
         fmt::format(
             "    {:.4g} × {:.4g} × {:.4g} m from ({:.4g}, {:.4g}, {:.4g}), volume {:.4g} m³, "
             "unit guess {}, scale {:.4g}\n",
             size[0], size[1], size[2], lower[0], lower[1], lower[2], number("volume_m3"),
             report.at("unit_guess").get<std::string>(), number("scale")) +
         fmt::format(
             "    triangles {}, dropped {}, vertices welded {}, holes {} of {} open edges, "
             "odd edges {}, crossings {}\n",
             count("triangles"), count("dropped"), count("welded"), count("holes"), count("open_edges"),
             count("odd_edges"), count("crossings"));
}

}  // namespace meniscus::cli
