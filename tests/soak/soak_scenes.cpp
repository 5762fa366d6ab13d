// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The soak tests' scenes. Each is a tank of about 1,500 to 3,000 particles with what it is about.
#include "tests/soak/soak_scenes.h"

#include <deque>

namespace meniscus::tests {

namespace {

/// A second in steps.
constexpr int second = 60;

constexpr Vec3 tank_lower{-0.5f, 0, -0.5f}, tank_upper{0.5f, 1.6f, 0.5f};

FluidId pool(World& world, float depth) {
  world.create_shape(tank(tank_lower, tank_upper));
  const FluidId water = world.create_fluid({});
  if (depth > 0) world.add_fluid(block(water, tank_lower, {tank_upper.x, depth, tank_upper.z}));
  return water;
}

EmitterDef jet_down(FluidId water, Vec3 from, float radius, float speed) {
  EmitterDef def;
  def.fluid = water;
  def.opening = DiscOpening{radius};
  def.pose = {from, {1, 0, 0, 0}};  // half a turn about x
  def.speed = speed;
  return def;
}

SinkDef drain(Vec3 lower, Vec3 upper) {
  SinkDef def;
  def.region = BoxRegion{lower, upper};
  return def;
}

BodyDef body(const Geometry& geometry, Vec3 position, float density) {
  BodyDef def;
  def.geometry = geometry;
  def.pose.position = position;
  def.density = density;
  return def;
}

/// The same numbers on each run.
Vec3 somewhere(std::mt19937& random, Vec3 centre, float range) {
  return centre + random_vector(random, range);
}

}  // namespace

void fountain(SoakScene& scene) {
  World& world = scene.world;
  const FluidId water = pool(world, 0.3f);
  world.create_emitter(jet_down(water, {0.2f, 1.2f, 0}, 0.12f, 1));
  world.create_sink(drain({-0.5f, 0.35f, -0.5f}, {-0.3f, 1.6f, 0.5f}));
  for (int k = 0; k < 12; ++k) {
    const Vec3 place{-0.3f + 0.2f * float(k % 4), 0.5f + 0.2f * float(k / 4), -0.2f + 0.2f * float(k % 3)};
    const Geometry kinds[] = {BoxGeometry{{0.06f, 0.06f, 0.06f}}, SphereGeometry{0.07f},
                              CapsuleGeometry{0.05f, 0.05f}};
    world.create_body(body(kinds[k % 3], place, k % 2 ? 400.0f : 700.0f));
  }
}

void tearing(SoakScene& scene) {
  constexpr float edge = 0.04f, tear_strain = 0.3f;
  // Torn pieces may be stuck through others, with a corner in the wall (docs/methods/tearing.md).
  scene.tank_of_cloth = SoftTank{{tank_lower, tank_upper}, (1 + tear_strain) * edge};
  World& world = scene.world;
  const FluidId water = pool(world, 0);
  world.create_emitter(jet_down(water, {0, 1.4f, 0}, 0.12f, 3));
  world.create_sink(drain({-0.5f, 0, -0.5f}, {0.5f, 0.15f, 0.5f}));
  scene.act = [cloth = std::optional<ClothId>{}](World& w, int step) mutable {
    if (step % (20 * second) != 0) return;
    if (cloth) w.destroy_cloth(*cloth);
    ClothDef def = sheet(20 * edge, 20 * edge, 21, 21, {0, 0.9f, 0});
    def.fabric.tear_strain = tear_strain;
    def.fabric.warp_stiffness = def.fabric.weft_stiffness = 600;
    cloth = w.create_cloth(def);
    w.create_attachment(attach(*cloth, {0, 20, 420, 440}));
  };
}

void laundry(SoakScene& scene) {
  World& world = scene.world;
  const FluidId water = world.create_fluid({});
  BodyDef drum;
  drum.motion = BodyMotion::kinematic;
  drum.geometry = ContainerGeometry{{0.45f, 0.45f, 0.3f}, {}};
  for (int quarter = 0; quarter <= 4; ++quarter)
    drum.keyframes.push_back({2.0f * float(quarter), {{0, 0, 0}, about_z(90.0f * float(quarter))}});
  drum.loop = true;
  world.create_body(drum);
  world.add_fluid(block(water, {-0.45f, -0.45f, -0.3f}, {0.45f, -0.15f, 0.3f}));
  for (int k = 0; k < 3; ++k) {
    ClothDef def = sheet(0.4f, 0.4f, 15, 15, {0, 0.1f * float(k), 0});
    def.fabric.absorbency = 0.5f;
    def.fabric.retention = 0.5f;
    world.create_cloth(def);
  }
}

void sleepers(SoakScene& scene) {
  World& world = scene.world;
  pool(world, 0.15f);
  const FluidId sand = world.create_granular({});
  world.add_fluid(block(sand, {-0.2f, 0.3f, -0.2f}, {0.2f, 0.5f, 0.2f}));
  std::vector<BodyId> bodies;
  for (int k = 0; k < 16; ++k) {
    const Vec3 place{-0.3f + 0.2f * float(k % 4), 0.7f + 0.2f * float(k / 8),
                     -0.25f + 0.25f * float(k / 4 % 3)};
    bodies.push_back(world.create_body(body(BoxGeometry{{0.08f, 0.05f, 0.06f}}, place, 1500)));
  }
  scene.act = [bodies, random = std::mt19937(7)](World& w, int step) mutable {
    if (step == 0 || step % (20 * second) != 0) return;
    for (const BodyId id : bodies) {
      const float mass = w.body_mass(id).mass;
      const BodyState state = w.body_state(id);
      w.apply_impulse(id, mass * (Vec3{0, 2, 0} + random_vector(random, 1)), state.centre_of_mass);
    }
  };
}

void turnover(SoakScene& scene) {
  const FluidId water = pool(scene.world, 0.3f);
  scene.act = [&scene, water, random = std::mt19937(3), bodies = std::deque<BodyId>{},
               ropes = std::deque<RopeId>{}](World& w, int step) mutable {
    if (step % (2 * second) != 0) return;
    const Vec3 place = somewhere(random, {0, 1, 0}, 0.25f);
    BodyDef def = body(step / (2 * second) % 2 ? Geometry{SphereGeometry{0.08f}}
                                               : Geometry{BoxGeometry{{0.07f, 0.07f, 0.07f}}},
                       place, 600);
    bodies.push_back(w.create_body(def));
    const Vec3 below = place - Vec3{0, 0.1f, 0};
    RopeDef tail = rope({below, below - Vec3{0, 0.2f, 0}}, 7);
    tail.bends_and_twists = step / (2 * second) % 3 == 0;
    ropes.push_back(w.create_rope(tail));
    AttachmentDef tie = attach(ropes.back(), {0});
    tie.body = bodies.back();
    w.create_attachment(tie);
    if (bodies.size() > 8) {
      w.destroy_rope(ropes.front());
      w.destroy_body(bodies.front());
      ropes.pop_front();
      bodies.pop_front();
    }
    // As many particles go as come.
    const std::vector<ParticleId> all(w.ids().begin(), w.ids().end());
    std::vector<ParticleId> gone;
    for (size_t k = random() % 16; k < all.size(); k += 16) gone.push_back(all[k]);
    w.remove_particles(gone);
    const std::vector<Vec3> rain = lattice(10, 1, 10, soak_spacing, {-0.25f, 1.4f, -0.25f});
    const size_t back = std::min(rain.size(), gone.size());
    w.add_particles(water, std::span(rain).first(back));
    scene.added_by_hand += static_cast<int64_t>(back) - static_cast<int64_t>(gone.size());
    const size_t left = gone.size() - back;
    if (left > 0) {
      const std::vector<Vec3> more = lattice(10, 2, 10, soak_spacing, {-0.25f, 1.5f, -0.25f});
      const size_t rest = std::min(left, more.size());
      w.add_particles(water, std::span(more).first(rest));
      scene.added_by_hand += static_cast<int64_t>(rest);
    }
  };
}

void balloons(SoakScene& scene) {
  World& world = scene.world;
  pool(world, 0.3f);
  world.set_wind({.velocity = {0.5f, 0, 0}, .gust_speed = 1});
  for (int k = 0; k < 4; ++k) {
    const Vec3 place{k % 2 ? 0.22f : -0.22f, 0.6f, k / 2 ? 0.22f : -0.22f};
    ClothDef def;
    def.geometry = ClothSphere{0.14f, 5};
    def.pose.position = place;
    def.inflation = InflationDef{500};
    const ClothId balloon = world.create_cloth(def);
    RopeDef string = rope({place - Vec3{0, 0.14f, 0}, place - Vec3{0, 0.45f, 0}}, 8);
    const RopeId id = world.create_rope(string);
    AttachmentDef tie = attach(id, {0});
    tie.other_cloth = balloon;
    world.create_attachment(tie);
    const BodyId weight = world.create_body(body(SphereGeometry{0.04f}, place - Vec3{0, 0.5f, 0}, 2000));
    AttachmentDef hold = attach(id, {8});
    hold.body = weight;
    world.create_attachment(hold);
  }
  const BodyId ball = world.create_body(body(SphereGeometry{0.1f}, {0, 1.2f, 0}, 300));
  scene.act = [ball](World& w, int step) {
    if (step % (5 * second) == 0 && step > 0)
      w.apply_impulse(ball, w.body_mass(ball).mass * Vec3{0.3f, 3, 0.2f}, w.body_state(ball).centre_of_mass);
  };
}

}  // namespace meniscus::tests
