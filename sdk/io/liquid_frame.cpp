// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Copies the fluid surfaces of a world into a frame.
#include "sdk/io/liquid_frame.h"

namespace meniscus::io {

LiquidFrame liquid_frame_of(const World& world, const std::vector<FluidId>& ids,
                            const std::vector<FluidDef>& defs) {
  LiquidFrame frame;
  frame.time = world.time();
  for (std::size_t i = 0; i < defs.size(); ++i) {
    const SurfaceMesh mesh = world.surface_mesh({.fluid = ids.at(i)});
    const auto first = static_cast<uint32_t>(frame.vertices.size());
    frame.names.push_back(defs[i].name);
    frame.vertices.insert(frame.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    frame.normals.insert(frame.normals.end(), mesh.normals.begin(), mesh.normals.end());
    frame.velocities.insert(frame.velocities.end(), mesh.velocities.begin(), mesh.velocities.end());
    for (const auto& [a, b, c] : mesh.triangles) frame.triangles.push_back({first + a, first + b, first + c});
    frame.fluids.resize(frame.triangles.size(), static_cast<uint32_t>(i));
  }
  return frame;
}

}  // namespace meniscus::io
