// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A program against the installed SDK: a dam break that prints where its front is.
#include <meniscus/meniscus.h>

#include <algorithm>
#include <cstdio>

int main() try {
  using namespace meniscus;
  World world({.particle_spacing = 0.1f});  // m; on the GPU where there is one, else on the CPU
  world.create_shape({.name = "tank", .geometry = ContainerGeometry{.half_extents = {2, 1, 1}}});
  const FluidId water = world.create_fluid({.name = "water", .rest_density = 1000});
  world.add_fluid({.fluid = water, .region = BoxRegion{.lower = {-2, -1, -1}, .upper = {-1, 0.5f, 1}}});

  while (world.time() < 2) world.step(1.0f / 60);  // s

  float front = -2;
  for (const Vec3& p : world.positions()) front = std::max(front, p.x);
  std::printf("%zu particles on %s: after %.1f s the front is at x = %.2f m\n", world.particle_count(),
              world.device().name.c_str(), world.time(), front);
} catch (const meniscus::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
