// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Copies the state of a world into a snapshot.
#include "sdk/viewer/snapshot.h"

namespace meniscus::viewer {
namespace {

template <class T>
std::vector<T> copy_of(std::span<const T> values) {
  return {values.begin(), values.end()};
}

}  // namespace

Snapshot snapshot_of(const BuiltScene& built, const Scene& scene) {
  const World& world = built.world;
  Snapshot s;
  s.device = world.device();
  s.time = world.time();
  s.ellipsoids = copy_of(world.ellipsoids());
  s.positions = copy_of(world.positions());
  s.velocities = copy_of(world.velocities());
  s.ids = copy_of(world.ids());
  s.fluids = copy_of(world.fluids());
  s.diffuse = copy_of(world.diffuse());
  for (const BodyId body : built.bodies) s.bodies.push_back(world.body_state(body));
  s.cloth = io::cloth_frame_of(world, built.cloths, scene.cloths);
  io::add_texture(s.cloth, world, built.cloths);
  s.ropes = io::rope_frame_of(world, built.ropes, scene.ropes);
  return s;
}

}  // namespace meniscus::viewer
