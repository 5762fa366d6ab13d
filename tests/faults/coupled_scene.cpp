// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The calls of the coupled scene.
#include "tests/faults/coupled_scene.h"

#include "tests/cloth_worlds.h"
#include "tests/worlds.h"

namespace meniscus::tests {

namespace {

constexpr float s = 0.1f, dt = 0.01f;

HullGeometry wedge() {
  HullGeometry hull;
  for (int i = 0; i < 8; ++i)
    hull.points.push_back({i & 1 ? 0.2f : -0.2f, i & 2 ? 0.15f : -0.15f, i & 4 ? 0.1f : -0.1f});
  return hull;
}

BodyDef box_at(Vec3 position, const Geometry& geometry = BoxGeometry{{0.1f, 0.1f, 0.1f}}) {
  BodyDef def;
  def.geometry = geometry;
  def.pose.position = position;
  def.density = 500;
  def.name = "a name that is too long for the small strings of the library";
  return def;
}

}  // namespace

WorldDef coupled_world(pbd::DeviceKind device) {
  WorldDef def = world_def(device, s);
  def.threads = 2;
  def.diffuse = DiffuseDef{};
  return def;
}

std::vector<SceneCall> coupled_calls(int steps) {
  std::vector<SceneCall> calls;
  const auto add = [&](const char* name, std::function<std::function<void()>(World&, SceneIds&)> prepare) {
    calls.push_back({name, std::move(prepare)});
  };
  // A call of which no definition refers to what the calls before it made.
  const auto add_made = [&]<class Id, class Def>(const char* name, Id SceneIds::*id, const Def& def,
                                                 Id (World::*create)(const Def&)) {
    add(name, [=](World& w, SceneIds& i) { return [=, &w, &i] { i.*id = (w.*create)(def); }; });
  };
  const auto add_destroyed = [&]<class Id>(const char* name, Id SceneIds::*id, void (World::*destroy)(Id)) {
    add(name, [=](World& w, SceneIds& i) { return [=, &w, &i] { (w.*destroy)(i.*id); }; });
  };
  const auto add_step = [&] { add("step", [](World& w, SceneIds&) { return [&w] { w.step(dt); }; }); };

  add_made("create_fluid", &SceneIds::water, FluidDef{.name = "water"}, &World::create_fluid);
  add_made("create_granular", &SceneIds::sand, GranularDef{}, &World::create_granular);
  add_made("create_shape, container", &SceneIds::tank, tank({-0.5f, 0, -0.5f}, {0.5f, 2, 0.5f}),
           &World::create_shape);
  add_made("create_shape, hull", &SceneIds::hull, shape(wedge(), {-0.25f, 0.15f, 0}), &World::create_shape);
  add_made("create_shape, heights", &SceneIds::hills,
           shape(HeightFieldGeometry{8, 8, 0.2f, std::vector<float>(64, -0.1f)}), &World::create_shape);
  add_made("create_body", &SceneIds::box, box_at({0.2f, 0.9f, 0.1f}), &World::create_body);
  CompoundGeometry both;
  both.parts = {{BoxGeometry{{0.05f, 0.05f, 0.05f}}, {}}, {wedge(), {{0, 0.2f, 0}, {0, 0, 0, 1}}}};
  add_made("create_body, compound", &SceneIds::club, box_at({-0.2f, 1.2f, -0.2f}, both), &World::create_body);
  BodyDef door = box_at({0.3f, 0.3f, -0.3f});
  door.motion = BodyMotion::kinematic;
  add_made("create_body, kinematic", &SceneIds::door, door, &World::create_body);
  add("create_joint", [](World& w, SceneIds& i) {
    JointDef def;
    def.a = i.box;
    def.b = i.club;
    def.kind = BallJoint{};
    def.frame.position = {0, 1.1f, 0};
    return [&w, &i, def] { i.joint = w.create_joint(def); };
  });
  ClothDef cloth = sheet(0.6f, 0.6f, 7, 7, {0, 0.7f, 0});
  cloth.fabric.absorbency = 0.5f;
  add_made("create_cloth", &SceneIds::cloth, cloth, &World::create_cloth);
  RopeDef rod = rope({{0.4f, 1.4f, 0}, {0.4f, 0.8f, 0}}, 6);
  rod.bends_and_twists = true;
  add_made("create_rope", &SceneIds::rope, rod, &World::create_rope);
  add("create_attachment", [](World& w, SceneIds& i) {
    return [&w, &i, def = attach(i.cloth, {0, 6, 42, 48})] { i.held = w.create_attachment(def); };
  });
  add("create_attachment, body", [](World& w, SceneIds& i) {
    AttachmentDef def = attach(i.rope, {5});
    def.body = i.box;
    return [&w, &i, def] { i.tied = w.create_attachment(def); };
  });
  add("set_wind", [](World& w, SceneIds&) {
    return [&w] { w.set_wind({.velocity = {1, 0, 0}, .gust_speed = 1}); };
  });
  add("add_fluid", [](World& w, SceneIds& i) {
    return [&w, def = block(i.water, {-0.5f, 0, -0.5f}, {0.5f, 0.3f, 0.5f})] { w.add_fluid(def); };
  });
  add("add_particles", [](World& w, SceneIds& i) {
    return [&w, &i, at = lattice(3, 2, 3, s, {-0.15f, 0.85f, -0.15f})] { w.add_particles(i.sand, at); };
  });
  add("create_emitter", [](World& w, SceneIds& i) {
    EmitterDef def;
    def.fluid = i.water;
    def.opening = DiscOpening{0.15f};
    def.pose.position = {0, 1.7f, 0};
    def.speed = 2;
    return [&w, &i, def] { i.emitter = w.create_emitter(def); };
  });
  add_made("create_sink", &SceneIds::sink,
           SinkDef{"", BoxRegion{{0.3f, -1, 0.3f}, {0.6f, 0.2f, 0.6f}}, false, {}, {}}, &World::create_sink);
  add("create_probe", [](World& w, SceneIds& i) {
    ProbeDef def;
    def.kind = ProbeKind::wall_force;
    def.shape = i.tank;
    return [&w, &i, def] { i.probe = w.create_probe(def); };
  });
  add("relax", [](World& w, SceneIds&) { return [&w] { w.relax(1); }; });
  for (int k = 0; k < steps; ++k) add_step();
  add("read-outs", [](World& w, SceneIds& i) {
    return [&w, &i] {
      w.diagnostics();
      w.positions();
      w.velocities();
      w.pressures();
      w.ellipsoids();
      w.surface_mesh();
      w.diffuse();
      w.cloth_normals(i.cloth);
      w.cloth_strains(i.cloth);
      w.cloth_wetness(i.cloth);
      w.cloth_state(i.cloth);
      w.rope_frames(i.rope);
      w.attachment_force(i.held);
      w.attachment_vertices(i.tied);
      w.particle_contacts();
      w.solid_contacts();
      w.memory_shares();
      w.warnings();
    };
  });
  add("queries", [](World& w, SceneIds&) {
    return [&w, points = std::vector<Vec3>{{0, 1, 0}}] {
      w.cast_ray({0, 3, 0}, {0, -1, 0});
      w.overlap_ball({0, 0.5f, 0}, 0.5f);
      w.overlap_box({{0, 0.5f, 0}, {0, 0, 0, 1}}, {0.5f, 0.5f, 0.5f});
      w.solid_distances(points, 1);
      w.nearest({0, 1, 0}, 1);
      w.sample_fluid(points);
    };
  });
  const std::vector<Vec3> impulses{{0.1f, 0, 0}, {0, 0.1f, 0}}, small{{0, 0.001f, 0}};
  add("apply_impulses", [=](World& w, SceneIds&) {
    return [&w, impulses, who = std::vector<ParticleId>{1, 2}] { w.apply_impulses(who, impulses); };
  });
  add("apply_impulses, cloth", [=](World& w, SceneIds& i) {
    return [&w, &i, small, who = std::vector<uint32_t>{24}] { w.apply_impulses(i.cloth, who, small); };
  });
  add("set_def", [](World& w, SceneIds&) {
    WorldDef def = w.def();
    def.substeps = 3;
    return [&w, def] { w.set_def(def); };
  });
  add("set_fluid", [](World& w, SceneIds& i) {
    return [&w, &i, def = FluidDef{.dynamic_viscosity = 10}] { w.set_fluid(i.water, def); };
  });
  add_step();
  add("remove_particles", [](World& w, SceneIds&) {
    return [&w, who = std::vector<ParticleId>{0, 3, 7}] { w.remove_particles(who); };
  });
  add("set_body_pose", [](World& w, SceneIds& i) {
    return [&w, &i] { w.set_body_pose(i.door, {{0.2f, 0.3f, -0.3f}, {0, 0, 0, 1}}); };
  });
  add("move_body", [](World& w, SceneIds& i) {
    return [&w, &i] { w.move_body(i.door, {{0.3f, 0.3f, -0.3f}, {0, 0, 0, 1}}, 0.05f); };
  });
  add_destroyed("destroy_joint", &SceneIds::joint, &World::destroy_joint);
  add_destroyed("destroy_attachment", &SceneIds::held, &World::destroy_attachment);
  add_destroyed("destroy_shape", &SceneIds::hull, &World::destroy_shape);
  add_step();
  add_destroyed("destroy_body", &SceneIds::box, &World::destroy_body);
  add_destroyed("destroy_rope", &SceneIds::rope, &World::destroy_rope);
  add_destroyed("destroy_cloth", &SceneIds::cloth, &World::destroy_cloth);
  add_destroyed("destroy_emitter", &SceneIds::emitter, &World::destroy_emitter);
  add_destroyed("destroy_sink", &SceneIds::sink, &World::destroy_sink);
  add_destroyed("destroy_probe", &SceneIds::probe, &World::destroy_probe);
  add_step();
  return calls;
}

}  // namespace meniscus::tests
