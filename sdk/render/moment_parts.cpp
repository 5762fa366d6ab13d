// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Derives what the passes draw from a moment.
#include "sdk/render/moment_parts.h"

#include <meniscus/world.h>

namespace meniscus::render {

Moment with_spans(Moment moment) {
  if (!moment.world) return moment;
  moment.ellipsoids = moment.world->ellipsoids();
  moment.fluids = moment.world->fluids();
  moment.positions = moment.world->positions();
  moment.velocities = moment.world->velocities();
  moment.diffuse = moment.world->diffuse();
  moment.world = nullptr;
  return moment;
}

void check_count(const char* name, std::size_t count, std::size_t ellipsoids) {
  if (count == ellipsoids) return;
  throw Error(ErrorCode::invalid_argument, std::string(name) + " has " + std::to_string(count) +
                                               " elements, but there are " + std::to_string(ellipsoids) +
                                               " ellipsoids");
}

Bounds bounds_of(const Bounds& still, const Moment& moment) {
  Bounds bounds = still;
  for (const Ellipsoid& e : moment.ellipsoids) {
    if (is_finite(e.centre)) bounds.add(e.centre);
  }
  for (const std::vector<Vec3>* points : {&moment.cloth.vertices, &moment.ropes.vertices}) {
    for (const Vec3 p : *points) {
      if (is_finite(p)) bounds.add(p);
    }
  }
  return bounds;
}

std::vector<Ellipsoid> balls_at(const Moment& moment, const io::PreviewScene& scene) {
  std::vector<Ellipsoid> balls(moment.ellipsoids.begin(), moment.ellipsoids.end());
  for (std::size_t i = 0; i < balls.size(); ++i) {
    if (moment.fluids[i] >= scene.first_granular) continue;
    const float r = scene.particle_spacing;
    balls[i] = {moment.positions[i], {r, r, r}, {0, 0, 0, 1}};
  }
  return balls;
}

std::vector<Vec3> strain_colors(const io::ClothFrame& cloth, const ViewData& view) {
  std::vector<Vec3> colors;
  if (!view.choice.strain) return colors;
  for (const float strain : cloth.strains)
    colors.push_back(color_at(view.strain.map, view.strain.place(strain)));
  return colors;
}

std::vector<Needle> contact_needles(std::span<const ParticleContact> contacts, float length) {
  constexpr Vec3 of_shapes{1.0f, 0.55f, 0.05f}, of_bodies{0.9f, 0.05f, 0.05f}, of_cloth{0.1f, 0.8f, 0.15f};
  std::vector<Needle> needles;
  for (const ParticleContact& c : contacts) {
    const Vec3 color = c.body != BodyId{} ? of_bodies : c.cloth != ClothId{} ? of_cloth : of_shapes;
    needles.push_back({c.point, c.point + length * c.normal, color});
  }
  return needles;
}

}  // namespace meniscus::render
