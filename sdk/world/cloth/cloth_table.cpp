// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Makes the meshes, constraints and rod models of cloth and ropes from their definitions.
#include "sdk/world/cloth/cloth_table.h"

#include <meniscus/error.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cloth/build/tethers.h"
#include "collision/mesh/sequence.h"
#include "sdk/world/check/check.h"
#include "sdk/world/cloth/cloth_shapes.h"
#include "sdk/world/cloth/cloth_texture.h"
#include "sdk/world/cloth/cloth_water.h"
#include "sdk/world/cloth/tuning.h"

namespace meniscus {

namespace {

struct MakeMesh {
  const FileReader& files;
  TexturedCloth& file;  ///< gets what a file has

  cloth::ClothMesh operator()(const SheetGeometry& g) const {
    return cloth::make_sheet(g.width, g.depth, static_cast<uint32_t>(g.columns),
                             static_cast<uint32_t>(g.rows));
  }
  cloth::ClothMesh operator()(const ClothFile& g) const {
    file = read_cloth(g, files);
    return file.mesh;
  }
  cloth::ClothMesh operator()(const ClothTriangles& g) const {
    cloth::ClothMesh mesh{g.vertices, {}, {}};
    for (size_t k = 0; k + 2 < g.triangles.size(); k += 3)
      mesh.triangles.push_back({g.triangles[k], g.triangles[k + 1], g.triangles[k + 2]});
    return mesh;
  }
  cloth::ClothMesh operator()(const ClothSphere& g) const { return sphere_mesh(g); }
  cloth::ClothMesh operator()(const DrivenTriangles& g) const {
    return (*this)(ClothTriangles{g.keyframes.front().vertices, g.triangles});
  }
  cloth::ClothMesh operator()(const DrivenFiles&) const { return {}; }  // read with its track
  cloth::ClothMesh operator()(const ClothTube& g) const { return tube_mesh(g); }
};

/// A vertex of the geometry in the world.
Vec3 placed(const ClothDef& def, Vec3 x) {
  const Vec3 s = def.stretch;
  return to_world(def.pose, {s.x * x.x, s.y * x.y, s.z * x.z});
}

void check_driven(const ClothDef& def) {
  const auto refuse = [&](const char* member, const char* what) {
    throw Error(ErrorCode::invalid_argument, std::string("ClothDef::") + member + ": \"" + def.name +
                                                 "\" is a driven surface, which " + what);
  };
  if (def.velocity != Vec3{0, 0, 0}) refuse("velocity", "moves by its keyframes");
  if (def.fabric.tear_strain > 0) refuse("fabric.tear_strain", "cannot tear");
  if (def.fabric.absorbency > 0) refuse("fabric.absorbency", "absorbs nothing");
  if (def.inflation) refuse("inflation", "holds no gas");
}

VertexTrack track_of(const DrivenTriangles& g) {
  VertexTrack track;
  track.loop = g.loop;
  for (const ClothKeyframe& k : g.keyframes) {
    track.times.push_back(double{k.time});
    track.positions.insert(track.positions.end(), k.vertices.begin(), k.vertices.end());
  }
  return track;
}

/// The first file's mesh comes with it.
VertexTrack track_of(const DrivenFiles& g, const FileReader& files, cloth::ClothMesh& mesh) {
  VertexTrack track;
  track.loop = g.loop;
  const collision::MeshSequence sequence = collision::load_sequence(g.files, g.first, g.last, g.scale, files);
  mesh = {sequence.mesh.vertices, sequence.mesh.triangles, {}};
  for (size_t k = 0; k < sequence.frames.size(); ++k) {
    track.times.push_back(double{g.start} + static_cast<double>(k) / double{g.frames_per_second});
    track.positions.insert(track.positions.end(), sequence.frames[k].begin(), sequence.frames[k].end());
  }
  return track;
}

/// Also fills in the mesh of files.
VertexTrackPtr make_track(const ClothDef& def, const FileReader& files, cloth::ClothMesh& mesh) {
  VertexTrack track;
  if (const auto* triangles = std::get_if<DrivenTriangles>(&def.geometry)) track = track_of(*triangles);
  if (const auto* numbered = std::get_if<DrivenFiles>(&def.geometry))
    track = track_of(*numbered, files, mesh);
  for (Vec3& x : track.positions) x = placed(def, x);
  return std::make_shared<const VertexTrack>(std::move(track));
}

cloth::FabricParameters parameters(const FabricDef& f) {
  return {f.density,
          f.warp_stiffness,
          f.weft_stiffness,
          f.shear_stiffness,
          f.bending_stiffness,
          f.stretch_model == StretchModel::triangles,
          f.bending_model == BendingModel::dihedral};
}

/// The polyline through the corners, divided into equal parts.
std::vector<Vec3> divided(const std::vector<Vec3>& corners, int segments, bool closed) {
  std::vector<Vec3> way = corners;
  if (closed) way.push_back(corners.front());
  std::vector<double> at{0};
  for (size_t k = 1; k < way.size(); ++k) at.push_back(at.back() + double{length(way[k] - way[k - 1])});
  std::vector<Vec3> points;
  size_t k = 1;
  for (int n = 0; n < segments + (closed ? 0 : 1); ++n) {
    const double s = at.back() * n / segments;
    while (k + 1 < way.size() && at[k] < s) ++k;
    const double part = at[k] - at[k - 1];
    const auto fraction = static_cast<float>(part > 0 ? std::clamp((s - at[k - 1]) / part, 0.0, 1.0) : 0.0);
    points.push_back(way[k - 1] + fraction * (way[k] - way[k - 1]));
  }
  return points;
}

/// Turns the triangles of each closed part outwards, each part by itself.
void turn_outwards(cloth::ClothMesh& mesh) {
  const std::vector<uint32_t> part = cloth::connected_parts(mesh);
  std::vector<double> volume(part.size());
  const std::vector<Vec3>& x = mesh.vertices;
  for (const auto& t : mesh.triangles)
    volume[part[t[0]]] += double{dot(x[t[0]] - x[0], cross(x[t[1]] - x[0], x[t[2]] - x[0]))};
  for (auto& t : mesh.triangles) {
    if (volume[part[t[0]]] < 0) std::swap(t[1], t[2]);
  }
}

}  // namespace

bool is_driven(const ClothGeometry& g) {
  return std::holds_alternative<DrivenTriangles>(g) || std::holds_alternative<DrivenFiles>(g);
}

float enclosed_volume(const cloth::ClothMesh& mesh, std::span<const Vec3> positions) {
  double six = 0;
  const Vec3 o = positions[0];
  for (const auto& t : mesh.triangles)
    six += double{dot(positions[t[0]] - o, cross(positions[t[1]] - o, positions[t[2]] - o))};
  return static_cast<float>(six / 6);
}

void build_constraints(ClothEntry& entry) {
  entry.constraints = cloth::build_constraints(entry.mesh, parameters(entry.def.fabric));
  if (entry.track) {  // nothing else moves its vertices
    std::vector<float> masses = std::move(entry.constraints.masses);
    entry.constraints = {};
    entry.constraints.masses = std::move(masses);
  }
  entry.range.masses = entry.constraints.masses;
  if (entry.def.fabric.absorbency > 0) entry.graph = make_graph(entry.mesh);
  entry.closed = cloth::is_closed(entry.mesh);
  entry.tethers.clear();
}

void attach_to_held(ClothEntry& entry, const std::vector<uint32_t>& held) {
  if (entry.held != held || entry.tethers.empty())
    entry.tethers = cloth::build_tethers(entry.mesh, held, parameters(entry.def.fabric));
  entry.held = held;
}

void check_driven_room(const IdTable<ClothId, ClothEntry>& cloths, size_t added) {
  size_t all = added;
  cloths.for_each([&](uint32_t, const ClothEntry& entry) {
    if (entry.track) all += entry.track->positions.size();
  });
  if (all <= std::numeric_limits<uint32_t>::max()) return;
  throw Error(ErrorCode::capacity,
              "driven surfaces have at most 2³² − 1 positions, vertices times keyframes; " +
                  std::to_string(all) + " were asked for");
}

std::vector<DrivenPiece> driven_pieces(const IdTable<ClothId, ClothEntry>& cloths) {
  std::vector<DrivenPiece> pieces;
  cloths.for_each([&](uint32_t, const ClothEntry& entry) {
    if (entry.track) pieces.push_back({entry.range.first, entry.track});
  });
  return pieces;
}

float mean_edge(const cloth::ClothMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) sum += length(mesh.vertices[t[(k + 1) % 3]] - mesh.vertices[t[k]]);
  }
  return static_cast<float>(sum / (3.0 * static_cast<double>(mesh.triangles.size())));
}

void drop_keyframes(ClothDef& def) {
  if (auto* driven = std::get_if<DrivenTriangles>(&def.geometry)) driven->keyframes = {};
}

ClothEntry make_cloth(const ClothDef& def, const FileReader& files, double time) {
  check::def(def);
  ClothEntry entry;
  entry.def = def;
  TexturedCloth file;
  entry.mesh = std::visit(MakeMesh{files, file}, def.geometry);
  if (is_driven(def.geometry)) {
    check_driven(def);
    entry.track = make_track(def, files, entry.mesh);
    drop_keyframes(entry.def);
  }
  entry.welded = file.welded;
  cloth::check_mesh(entry.mesh);
  cloth::orient_triangles(entry.mesh);
  entry.closed = cloth::is_closed(entry.mesh);
  if (entry.closed) {
    turn_outwards(entry.mesh);
    entry.rest_volume = enclosed_volume(entry.mesh, entry.mesh.vertices);
  } else if (def.inflation) {
    throw Error(ErrorCode::mesh,
                "ClothDef::inflation needs a closed mesh; \"" + def.name + "\" has a border");
  }
  if (std::holds_alternative<ClothFile>(def.geometry)) entry.texture = texture_on(entry.mesh, file);
  build_constraints(entry);
  if (def.fabric.absorbency > 0) entry.water.resize(entry.range.masses.size());
  entry.thickness = def.fabric.thickness > 0 ? def.fabric.thickness
                                             : cloth_world_tuning::default_thickness * mean_edge(entry.mesh);
  VertexRange& range = entry.range;
  range.filter = def.filter;
  range.contact_radius = 0.5f * entry.thickness;
  for (Vec3 x : entry.mesh.vertices) range.state.positions.push_back(placed(def, x));
  if (entry.track) range.state.positions = positions_at(*entry.track, time);
  range.state.velocities.assign(range.masses.size(), def.velocity);
  return entry;
}

RopeEntry make_rope(const RopeDef& def) {
  check::def(def);
  RopeEntry entry;
  entry.def = def;
  std::vector<Vec3> points = def.segments > 0 ? divided(def.points, def.segments, def.closed) : def.points;
  for (Vec3& p : points) p = to_world(def.pose, p);
  cloth::RodParameters p;
  p.radius = def.radius;
  p.density = def.density;
  p.youngs_modulus = def.youngs_modulus;
  p.shear_modulus = def.shear_modulus;
  p.damping = def.damping;
  p.bends_and_twists = def.bends_and_twists;
  p.closed = def.closed;
  p.straight_at_rest = def.straight_at_rest;
  entry.model = cloth::build_rod(points, p);
  for (const Quat& frame : entry.model.frames) entry.segments.push_back({frame, {0, 0, 0}, false});
  VertexRange& range = entry.range;
  range.masses = entry.model.masses;
  range.filter = def.filter;
  range.contact_radius = def.radius;
  range.state.positions = std::move(points);
  range.state.velocities.assign(range.masses.size(), def.velocity);
  return entry;
}

}  // namespace meniscus
