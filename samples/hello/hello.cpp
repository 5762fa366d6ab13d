// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A drop of water falls for a quarter of a second, in C++. Link Meniscus::meniscus.
#include <meniscus/meniscus.h>

#include <cstdio>

int main() try {
  meniscus::World world;
  const meniscus::FluidId water = world.create_fluid({});
  world.add_fluid({.fluid = water, .region = meniscus::BallRegion{}});
  for (int k = 0; k < 15; ++k) world.step(1.0f / 60);
  std::printf("%zu particles, the first at y = %.2f m\n", world.particle_count(), world.positions()[0].y);
} catch (const meniscus::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
