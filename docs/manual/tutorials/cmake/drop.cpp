// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tutorial: linking from CMake. A drop falls into a tank. The program draws the particles from the side, as
// drop.svg.
#include <meniscus/meniscus.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>

using namespace meniscus;

/// A circle for each particle, 400 pixels a metre, y up.
void draw(const World& world, const char* path) {
  std::ofstream out(path);
  out.precision(4);
  out << "<svg xmlns='http://www.w3.org/2000/svg' width='440' height='420' fill='steelblue'>\n";
  const auto errors = world.density_errors();
  const auto positions = world.positions();  // both are valid until the world changes
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const float opacity = errors[i] < -0.3f ? 0.3f : 0.8f;  // spray is pale
    out << "<circle r='8' cx='" << 220 + 400 * positions[i].x << "' cy='" << 400 - 400 * positions[i].y
        << "' opacity='" << opacity << "'/>\n";
  }
  out << "</svg>\n";
  if (!out) throw std::runtime_error("cannot write drop.svg");
}

int main() try {
  World world({.particle_spacing = 0.04f});
  world.create_shape({.name = "tank",
                      .geometry = ContainerGeometry{.half_extents = {0.5f, 0.5f, 0.2f},
                                                    .openings = {{.face = Face::y_high}}},
                      .pose = {.position = {0, 0.5f, 0}}});
  const FluidId water = world.create_fluid({.name = "water", .xsph = 10});
  std::size_t count = world.add_fluid(
      {.fluid = water, .region = BoxRegion{.lower = {-0.5f, 0, -0.2f}, .upper = {0.5f, 0.2f, 0.2f}}});
  count += world.add_fluid(
      {.fluid = water, .region = BallRegion{.radius = 0.15f}, .pose = {.position = {0, 0.6f, 0}}});

  while (world.time() < 0.5) world.step(1.0f / 60);
  draw(world, "drop.svg");

  const Diagnostics measured = world.diagnostics();
  std::printf("%zu particles on %s, density error %.3f %%, %zu outside\n", world.particle_count(),
              world.device().name.c_str(), 100 * measured.density_error_mean, measured.outside);
  if (world.particle_count() != count || measured.outside != 0) throw std::runtime_error("water was lost");
  if (measured.density_error_mean > 0.01) throw std::runtime_error("the water is compressed");
} catch (const std::exception& error) {  // Meniscus throws meniscus::Error, which is one
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
