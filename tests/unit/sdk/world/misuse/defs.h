// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Definitions of each kind that a world takes, with each alternative, and the calls that take them.
#pragma once

#include <vector>

#include "tests/unit/sdk/world/misuse/misuse_world.h"

namespace meniscus::tests {

/// A folder with a closed mesh, for all tests of a program.
inline const std::string& brick_file() {
  static const TemporaryFolder folder;
  static const std::string file = folder.write("brick.obj", brick_obj);
  return file;
}

inline HullGeometry small_hull() {
  return {{{0, 0, 0}, {0.1f, 0, 0}, {0, 0.1f, 0}, {0, 0, 0.1f}}};
}

inline std::vector<Geometry> solids() {
  return {BoxGeometry{},
          SphereGeometry{},
          CapsuleGeometry{},
          CylinderGeometry{},
          small_hull(),
          MeshGeometry{.file = brick_file(), .max_error = 0.5f, .convex_parts = 2},
          CompoundGeometry{{CompoundPart{}}}};
}

inline std::vector<WorldDef> world_defs(const MisuseWorld& w) {
  return {w.world.def()};
}

inline std::vector<FluidVolumeDef> volume_defs(const MisuseWorld& w) {
  std::vector<FluidVolumeDef> defs;
  for (const Region& region : {Region{BoxRegion{{0, 2, 0}, {0.2f, 2.2f, 0.2f}}},
                               {BallRegion{0.2f}},
                               {MeshRegion{brick_file(), 0.1f}}})
    defs.push_back({w.water, region, {{0, 2, 0}, {0, 0, 0, 1}}});
  return defs;
}

inline std::vector<ShapeDef> shape_defs(const MisuseWorld&) {
  std::vector<Geometry> geometries = solids();
  geometries.push_back(PlaneGeometry{});
  geometries.push_back(HeightFieldGeometry{2, 2, 0.1f, {0, 0, 0, 0}});
  geometries.push_back(
      ContainerGeometry{{1, 1, 1}, {{Face::y_high, Aabb{{-0.5f, 0, -0.5f}, {0.5f, 1, 0.5f}}}}});
  std::vector<ShapeDef> defs;
  for (const Geometry& geometry : geometries) defs.push_back(shape(geometry, {0, -2, 0}));
  return defs;
}

inline std::vector<BodyDef> body_defs(const MisuseWorld&) {
  std::vector<BodyDef> defs;
  for (const Geometry& geometry : solids()) defs.push_back(body(geometry, {0, 9, 0}));
  defs.push_back(body(BoxGeometry{}, {0, 9, 0}));
  defs.back().mass = 3.0f;
  defs.push_back(kinematic(BoxGeometry{}));
  defs.back().keyframes = {{0, {}}, {1, {}}};
  return defs;
}

inline std::vector<JointDef> joint_defs(const MisuseWorld& w) {
  HingeJoint hinge;
  hinge.lower = -1.0f, hinge.upper = 1.0f;
  SliderJoint slider;
  slider.lower = -1.0f, slider.upper = 1.0f;
  std::vector<JointDef> defs;
  for (const JointKind& kind : {JointKind{FixedJoint{}}, {hinge}, {slider}, {BallJoint{}}, {SpringJoint{}}})
    defs.push_back(joint(kind, w.other_box, w.door));
  return defs;
}

inline std::vector<ClothDef> cloth_defs(const MisuseWorld&) {
  std::vector<ClothDef> defs;
  for (const ClothGeometry& geometry : {ClothGeometry{SheetGeometry{1, 1, 3, 3}},
                                        {ClothFile{brick_file(), 0.1f}},
                                        {ClothTriangles{{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {0, 1, 2}}},
                                        {ClothSphere{0.2f, 2}},
                                        {ClothTube{.columns = 6, .rows = 3}}}) {
    ClothDef def = sheet(1, 1, 2, 2, {0, 5, 0});
    def.geometry = geometry;
    if (std::holds_alternative<ClothSphere>(geometry)) def.inflation = InflationDef{};
    defs.push_back(def);
  }
  return defs;
}

inline std::vector<RopeDef> rope_defs(const MisuseWorld&) {
  std::vector<RopeDef> defs(2, rope({{0, 5, 0}, {1, 5, 0}}, 3));
  defs[1].bends_and_twists = true;
  return defs;
}

inline std::vector<AttachmentDef> attachment_defs(const MisuseWorld& w) {
  std::vector<AttachmentDef> defs(4, attach(w.cloth, {12}));
  defs[1].body = w.box;
  defs[1].region = Aabb{{-5, -5, -5}, {5, 5, 5}};
  defs[2].other_rope = w.string;
  defs[2].reach = 3;
  defs[3] = attach(w.string, {1});
  defs[3].other_cloth = w.cloth;
  defs[3].reach = 3;
  return defs;
}

inline std::vector<EmitterDef> emitter_defs(const MisuseWorld& w) {
  std::vector<EmitterDef> defs;
  for (const EmitterOpening& opening :
       {EmitterOpening{DiscOpening{}}, {RectangleOpening{}}, {MeshOpening{brick_file(), 0.1f}}}) {
    EmitterDef def;
    def.fluid = w.water;
    def.opening = opening;
    def.body = w.door;
    def.most_particles = 3;
    def.stop = 10;
    defs.push_back(def);
  }
  return defs;
}

inline std::vector<SinkDef> sink_defs(const MisuseWorld& w) {
  std::vector<SinkDef> defs;
  for (const SinkRegion& region : {SinkRegion{BoxRegion{}}, {BallRegion{}}, {HalfSpaceRegion{}}})
    defs.push_back({"sink", region, false, {{0, 9, 0}, {0, 0, 0, 1}}, w.door});
  return defs;
}

inline std::vector<ProbeDef> probe_defs(const MisuseWorld& w) {
  std::vector<ProbeDef> defs(3);
  const ProbeKind kinds[] = {ProbeKind::point_pressure, ProbeKind::wall_pressure, ProbeKind::wall_force};
  for (std::size_t k = 0; k < 3; ++k) {
    defs[k].kind = kinds[k];
    defs[k].shape = w.vessel;
    defs[k].patch = Aabb{{-1, -1, -1}, {1, 1, 1}};
    defs[k].area = 4;
  }
  return defs;
}

inline std::vector<ForceFieldDef> force_field_defs(const MisuseWorld&) {
  const Force forces[] = {UniformForce{}, RadialForce{}, VortexForce{},
                          DragForce{},    NoiseForce{},  GridForce{}};
  const ForceRegion regions[] = {EverywhereRegion{}, BoxRegion{}, BallRegion{}};
  std::vector<ForceFieldDef> defs(6);
  for (std::size_t k = 0; k < 6; ++k) {
    defs[k].force = forces[k];
    defs[k].region = regions[k % 3];
  }
  return defs;
}

inline std::vector<SurfaceMeshDef> surface_defs(const MisuseWorld& w) {
  return {{.fluid = w.water}};
}

template <class Def>
std::vector<Def> one_default(const MisuseWorld&) {
  return {Def{}};
}

/// Calls `visit(name, definitions, call)` for each call that takes a definition.
template <class Visit>
void for_each_def_call(const Visit& visit) {
  using W = MisuseWorld;
  visit("World", world_defs, [](W&, const WorldDef& d) { World world(d); });
  visit("set_def", world_defs, [](W& w, const WorldDef& d) { w.world.set_def(d); });
  visit("create_fluid", one_default<FluidDef>, [](W& w, const FluidDef& d) { w.world.create_fluid(d); });
  visit("set_fluid", one_default<FluidDef>, [](W& w, const FluidDef& d) { w.world.set_fluid(w.water, d); });
  visit("create_granular", one_default<GranularDef>,
        [](W& w, const GranularDef& d) { w.world.create_granular(d); });
  visit("create_shape", shape_defs, [](W& w, const ShapeDef& d) { w.world.create_shape(d); });
  visit("create_emitter", emitter_defs, [](W& w, const EmitterDef& d) { w.world.create_emitter(d); });
  visit("create_sink", sink_defs, [](W& w, const SinkDef& d) { w.world.create_sink(d); });
  visit("create_probe", probe_defs, [](W& w, const ProbeDef& d) { w.world.create_probe(d); });
  visit("create_force_field", force_field_defs,
        [](W& w, const ForceFieldDef& d) { w.world.create_force_field(d); });
  visit("set_force_field", force_field_defs,
        [](W& w, const ForceFieldDef& d) { w.world.set_force_field(w.field, d); });
  visit("create_body", body_defs, [](W& w, const BodyDef& d) { w.world.create_body(d); });
  visit("create_joint", joint_defs, [](W& w, const JointDef& d) { w.world.create_joint(d); });
  visit("create_cloth", cloth_defs, [](W& w, const ClothDef& d) { w.world.create_cloth(d); });
  visit("create_rope", rope_defs, [](W& w, const RopeDef& d) { w.world.create_rope(d); });
  visit("create_attachment", attachment_defs,
        [](W& w, const AttachmentDef& d) { w.world.create_attachment(d); });
  visit("set_wind", one_default<WindDef>, [](W& w, const WindDef& d) { w.world.set_wind(d); });
  visit("add_fluid", volume_defs, [](W& w, const FluidVolumeDef& d) { w.world.add_fluid(d); });
  visit("surface_mesh", surface_defs, [](W& w, const SurfaceMeshDef& d) { w.world.surface_mesh(d); });
}

}  // namespace meniscus::tests
