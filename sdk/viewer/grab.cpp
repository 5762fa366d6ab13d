// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Computes the forces that pull what the mouse holds.
#include "sdk/viewer/grab.h"

#include <algorithm>
#include <numbers>

#include "pbd/math/vec.h"

namespace meniscus::viewer {
namespace {

constexpr float body_rate = 9.0f;     // rad/s, of a critically damped spring
constexpr float follow_time = 0.08f;  // s, in which particles would reach the target
constexpr float top_speed = 6.0f;     // m/s, largest speed at which they follow
constexpr float most_gain = 6.0f;     // factor by which a patch may stand for the sheet's mass

/// Change of velocity in a step.
Vec3 follow(Vec3 target, Vec3 position, Vec3 velocity, Vec3 gravity, float dt) {
  Vec3 wanted = (target - position) / std::max(follow_time, dt);
  wanted = std::min(1.0f, top_speed / std::max(length(wanted), 1e-6f)) * wanted;
  return std::min(1.0f, dt / (0.25f * follow_time)) * (wanted - velocity) - dt * gravity;
}

/// The effective mass against a force at that point: less than the whole mass, as the body turns.
float mass_at(const BodyMass& body, Vec3 arm) {
  const float least = std::min({body.inertia.x, body.inertia.y, body.inertia.z});
  return 1 / (1 / body.mass + dot(arm, arm) / std::max(least, 1e-20f));
}

Vec3 pull_held(const HeldBody& held, Vec3 target, BuiltScene& built, float dt) {
  World& world = built.world;
  const BodyId id = built.bodies[held.index];
  const BodyState now = world.body_state(id);
  const BodyMass mass = world.body_mass(id);
  const Vec3 point = to_world(now.pose, held.point), arm = point - now.centre_of_mass;
  const Vec3 velocity = now.velocity + cross(now.angular_velocity, arm);
  const float rate = std::min(body_rate, 0.5f / dt);
  const Vec3 gain = rate * rate * (target - point) - 2 * rate * velocity;
  world.apply_force(id, mass_at(mass, arm) * gain - mass.mass * world.def().gravity, point);
  // Damps the rotation about the point.
  world.apply_torque(
      id, -0.5f * rate * std::min({mass.inertia.x, mass.inertia.y, mass.inertia.z}) * now.angular_velocity);
  return point;
}

Vec3 pull_held(const HeldParticles& held, Vec3 target, BuiltScene& built, float dt) {
  World& world = built.world;
  const std::span<const ParticleId> all = world.ids();
  const std::span<const Vec3> positions = world.positions(), velocities = world.velocities();
  const std::span<const uint32_t> fluids = world.fluids();
  std::vector<ParticleId> ids;
  std::vector<Vec3> impulses;
  Vec3 middle{0, 0, 0};
  for (std::size_t k = 0; k < held.ids.size(); ++k) {
    const auto found = std::lower_bound(all.begin(), all.end(), held.ids[k]);
    if (found == all.end() || *found != held.ids[k]) continue;
    const auto i = static_cast<std::size_t>(found - all.begin());
    ids.push_back(held.ids[k]);
    impulses.push_back(world.particle_mass(built.fluids[fluids[i]]) *
                       follow(target + held.places[k], positions[i], velocities[i], world.def().gravity, dt));
    middle += positions[i] - held.places[k];
  }
  if (ids.empty()) return target;
  world.apply_impulses(ids, impulses);
  return middle / static_cast<float>(ids.size());
}

/// kg, of all its vertices.
float mass_of(const HeldVertices& held, const BuiltScene& built, const Scene& scene) {
  if (!held.of_rope) return built.world.cloth_state(built.cloths[held.index]).mass;
  const RopeDef& rope = scene.ropes[held.index];
  const std::span<const Vec3> x = built.world.rope_positions(built.ropes[held.index]);
  float way = 0;
  for (std::size_t i = 1; i < x.size(); ++i) way += length(x[i] - x[i - 1]);
  return rope.density * std::numbers::pi_v<float> * rope.radius * rope.radius * way;
}

Vec3 pull_held(const HeldVertices& held, Vec3 target, BuiltScene& built, const Scene& scene, float dt) {
  World& world = built.world;
  const auto x = held.of_rope ? world.rope_positions(built.ropes[held.index])
                              : world.cloth_positions(built.cloths[held.index]);
  const auto v = held.of_rope ? world.rope_velocities(built.ropes[held.index])
                              : world.cloth_velocities(built.cloths[held.index]);
  const float each = mass_of(held, built, scene) / static_cast<float>(x.size());
  const float gain = std::clamp(
      0.25f * static_cast<float>(x.size()) / static_cast<float>(held.vertices.size()), 1.0f, most_gain);
  std::vector<Vec3> impulses;
  Vec3 middle{0, 0, 0};
  for (std::size_t k = 0; k < held.vertices.size(); ++k) {
    const uint32_t i = held.vertices[k];
    impulses.push_back(gain * each * follow(target + held.places[k], x[i], v[i], world.def().gravity, dt));
    middle += x[i] - held.places[k];
  }
  if (held.of_rope)
    world.apply_impulses(built.ropes[held.index], held.vertices, impulses);
  else
    world.apply_impulses(built.cloths[held.index], held.vertices, impulses);
  return middle / static_cast<float>(held.vertices.size());
}

}  // namespace

Vec3 pull(const Grab& grab, BuiltScene& built, const Scene& scene, float dt) {
  if (const auto* body = std::get_if<HeldBody>(&grab.held)) return pull_held(*body, grab.target, built, dt);
  if (const auto* particles = std::get_if<HeldParticles>(&grab.held))
    return pull_held(*particles, grab.target, built, dt);
  return pull_held(std::get<HeldVertices>(grab.held), grab.target, built, scene, dt);
}

}  // namespace meniscus::viewer
