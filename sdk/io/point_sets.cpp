// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Gathers the points of frames.
#include "sdk/io/point_sets.h"

namespace meniscus::io {

std::vector<FluidPoints> points_by_fluid(const SceneFrame& frame, std::size_t fluids) {
  std::vector<FluidPoints> points(fluids);
  for (std::size_t i = 0; fluids > 0 && i < frame.positions.size(); ++i) {
    FluidPoints& fluid = points.at(frame.fluids[i]);
    fluid.positions.push_back(frame.positions[i]);
    fluid.velocities.push_back(frame.velocities[i]);
    fluid.ids.push_back(frame.ids[i]);
  }
  return points;
}

DiffusePoints diffuse_points(std::span<const DiffuseParticle> particles) {
  DiffusePoints points;
  for (const DiffuseParticle& p : particles) {
    points.positions.push_back(p.position);
    points.velocities.push_back(p.velocity);
    points.lives.push_back(p.life);
    points.kinds.push_back(static_cast<uint32_t>(p.kind));
  }
  return points;
}

RopePoints points_of_rope(const RopeFrame& frame, std::size_t rope) {
  RopePoints points;
  for (const uint32_t v : frame.lines.at(rope)) {
    points.positions.push_back(frame.vertices[v]);
    points.velocities.push_back(frame.velocities[v]);
  }
  return points;
}

}  // namespace meniscus::io
