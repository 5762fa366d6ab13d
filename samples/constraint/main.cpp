// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Two grains that a constraint of our own ties together, beside a rope of one segment, which Meniscus solves.
// Both have the same masses, stiffness and start, and must move alike. The program ends with 1 if they do
// not. Argument: "cpu", "cuda" or "auto".
#include <meniscus/extend.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>

using namespace meniscus;

/// C = |x₁ − x₀| − rest, with ∇C = ±n along the unit vector between both.
struct Distance {
  static constexpr uint32_t point_count = 2;
  uint32_t points[point_count];
  float rest;        ///< m
  float compliance;  ///< m/N

  MENISCUS_BOTH_DEVICES float value(const Vec3 (&x)[2], Vec3 (&gradient)[2]) const {
    using namespace device;
    const Vec3 apart = difference(x[1], x[0]);
    const float length = norm(apart);
    if (!(length > 0)) return 0;
    gradient[1] = product(1 / length, apart);
    gradient[0] = product(-1, gradient[1]);
    return length - rest;
  }
};

namespace {

constexpr float spacing = 0.1f, density = 1000, length = 0.5f, stiffness = 2000;  // m, kg/m³, m, N
constexpr Vec3 far_end{0.6f * length, 0.8f * length, 0}, push{0.6f, 0.8f, 0};     // m, N·s: along both
constexpr int steps = 60;
constexpr float dt = 1.0f / 60;

World weightless(DeviceChoice device) {
  WorldDef def;
  def.device = device;
  def.gravity = {0, 0, 0};
  def.particle_spacing = spacing;
  return World(def);
}

/// The places of both ends after each step, under a push on the second one.
std::vector<Vec3> tied_grains(DeviceChoice device) {
  World world = weightless(device);
  GranularDef sand;
  sand.density = density;
  const FluidId grains = world.create_granular(sand);
  const std::vector<Vec3> places{{0, 0, 0}, far_end};
  const ParticleId first = world.add_particles(grains, places);
  ConstraintsOf<Distance> tie(world, {{{0, 1}, length, length / stiffness}});
  const std::vector<ParticleId> second{first + 1};
  world.apply_impulses(second, std::vector<Vec3>{push});
  std::vector<Vec3> path;
  for (int k = 0; k < steps; ++k) {
    world.step(dt);
    path.insert(path.end(), world.positions().begin(), world.positions().end());
  }
  return path;
}

std::vector<Vec3> rope(DeviceChoice device) {
  World world = weightless(device);
  RopeDef def;
  def.points = {{0, 0, 0}, far_end};
  def.segments = 1;
  def.radius = 0.05f;
  const float mass = 2 * density * spacing * spacing * spacing, area = 3.14159265f * def.radius * def.radius;
  def.density = mass / (area * length);
  def.youngs_modulus = stiffness / area;
  def.damping = 0;
  const RopeId made = world.create_rope(def);
  const std::vector<uint32_t> second{1};
  world.apply_impulses(made, second, std::vector<Vec3>{push});
  std::vector<Vec3> path;
  for (int k = 0; k < steps; ++k) {
    world.step(dt);
    path.insert(path.end(), world.rope_positions(made).begin(), world.rope_positions(made).end());
  }
  return path;
}

DeviceChoice choice_of(const char* name) {
  if (std::strcmp(name, "cuda") == 0) return DeviceChoice::cuda;
  return std::strcmp(name, "cpu") == 0 ? DeviceChoice::cpu : DeviceChoice::automatic;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    const DeviceChoice device = choice_of(count > 1 ? arguments[1] : "cpu");
    const std::vector<Vec3> ours = tied_grains(device), theirs = rope(device);
    float furthest = 0, stretch = 0;
    for (std::size_t k = 0; k < ours.size(); ++k)
      furthest = std::fmax(furthest, device::norm(device::difference(ours[k], theirs[k])));
    for (std::size_t k = 0; k + 1 < ours.size(); k += 2)
      stretch = std::fmax(stretch, device::norm(device::difference(ours[k + 1], ours[k])) / length);
    std::printf("largest difference %.2g m, largest stretch %.3f\n", double{furthest}, double{stretch});
    return furthest < 1e-4f && stretch > 1.01f ? 0 : 1;
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
