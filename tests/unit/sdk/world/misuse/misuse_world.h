// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A small world with one thing of each kind, and what can be seen of it.
#pragma once

#include "tests/cloth_worlds.h"
#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {

struct MisuseWorld {
  explicit MisuseWorld(pbd::DeviceKind device) : world(small(device)) {
    water = world.create_fluid({});
    sand = world.create_granular({});
    vessel = world.create_shape(tank({-1, 0, -1}, {1, 3, 1}));
    box = world.create_body(body(BoxGeometry{{0.1f, 0.1f, 0.1f}}, {0.5f, 1, 0}));
    other_box = world.create_body(body(BoxGeometry{{0.1f, 0.1f, 0.1f}}, {0.5f, 1.5f, 0}));
    door = world.create_body(kinematic(BoxGeometry{{0.1f, 0.1f, 0.1f}}, {-0.5f, 1, 0}));
    hinge = world.create_joint(joint(HingeJoint{}, box, other_box));
    cloth = world.create_cloth(sheet(0.4f, 0.4f, 4, 4, {0, 1.5f, 0}));
    string = world.create_rope(rope({{0, 2, 0.5f}, {0, 1.5f, 0.5f}}, 4));
    held = world.create_attachment(attach(cloth, {0, 3}));
    world.add_particles(water, lattice(3, 3, 3, 0.1f, {0, 0, 0}));
    EmitterDef jet;
    jet.fluid = water;
    jet.pose.position = {0, 2.5f, -0.5f};
    emitter = world.create_emitter(jet);
    sink = world.create_sink({"sink", BoxRegion{{8, 8, 8}, {9, 9, 9}}, false, {}, {}});
    probe = world.create_probe({});
    field = world.create_force_field({});
    world.step(0.005f);
  }

  World world;
  FluidId water, sand;
  ShapeId vessel;
  BodyId box, other_box, door;
  JointId hinge;
  ClothId cloth;
  RopeId string;
  AttachmentId held;
  EmitterId emitter;
  SinkId sink;
  ProbeId probe;
  ForceFieldId field;

 private:
  static WorldDef small(pbd::DeviceKind device) {
    WorldDef def = world_def(device, 0.1f);
    def.threads = 1;
    def.substeps = 1;
    def.iterations = 2;
    def.diffuse = DiffuseDef{.capacity = 100};
    return def;
  }
};

/// What calls tell of a world: equal where nothing has changed.
struct Sight {
  uint64_t hash;
  std::size_t particles, vertices, bodies, shapes, bytes, repairs;
  double time;

  explicit Sight(const MisuseWorld& w)
      : hash(w.world.state_hash()),
        particles(w.world.particle_count()),
        vertices(w.world.cloth_positions(w.cloth).size() + w.world.rope_positions(w.string).size()),
        repairs(w.world.mesh_repairs().size()),
        time(w.world.time()) {
    const Overlaps all = w.world.overlap_box({}, {100, 100, 100});
    bodies = all.bodies.size();
    shapes = all.shapes.size();
    bytes = w.world.device_bytes();
  }
  friend bool operator==(const Sight&, const Sight&) = default;
};

/// After a step that failed. It may have taken memory.
inline void expect_same_state(const Sight& before, const Sight& after) {
  EXPECT_EQ(before.hash, after.hash);
  EXPECT_EQ(before.particles, after.particles);
  EXPECT_EQ(before.time, after.time);
}

/// Whether all that the world holds is finite.
inline bool is_finite(const MisuseWorld& w) {
  bool finite = w.world.diagnostics().non_finite == 0;
  for (const Vec3 p : w.world.positions()) finite &= is_finite(p);
  for (const Vec3 v : w.world.velocities()) finite &= is_finite(v);
  for (const Vec3 p : w.world.cloth_positions(w.cloth)) finite &= is_finite(p);
  for (const Vec3 p : w.world.rope_positions(w.string)) finite &= is_finite(p);
  for (const BodyId id : {w.box, w.other_box, w.door}) {
    const BodyState state = w.world.body_state(id);
    finite &= is_finite(state.pose.position) && is_finite(state.velocity) &&
              is_finite(state.angular_velocity) && std::isfinite(state.pose.rotation.w);
  }
  return finite;
}

}  // namespace meniscus::tests
