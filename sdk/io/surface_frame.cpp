// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Triangulates bodies once, and moves the triangles with them.
#include "sdk/io/surface_frame.h"

#include <meniscus/error.h>

#include <map>
#include <tuple>

#include "pbd/math/vec.h"
#include "sdk/io/solid_triangles.h"

namespace meniscus::io {
namespace {

/// Corners at the same place become one vertex.
collision::TriangleMesh welded(const std::vector<SolidTriangle>& triangles) {
  collision::TriangleMesh mesh;
  std::map<std::tuple<float, float, float>, uint32_t> numbers;
  for (const SolidTriangle& t : triangles) {
    std::array<uint32_t, 3> corners;
    for (int k = 0; k < 3; ++k) {
      const Vec3 p = t.corners[k];
      const auto [found, is_new] =
          numbers.emplace(std::tuple(p.x, p.y, p.z), static_cast<uint32_t>(mesh.vertices.size()));
      if (is_new) mesh.vertices.push_back(p);
      corners[k] = found->second;
    }
    mesh.triangles.push_back(corners);
  }
  return mesh;
}

}  // namespace

BodySurfaces::BodySurfaces(const std::vector<BodyDef>& bodies) {
  for (const BodyDef& body : bodies) {
    meshes_.push_back(welded(solid_triangles(body.geometry)));
    names_.push_back(body.name);
  }
}

SurfaceFrame BodySurfaces::at(double time, std::span<const BodyState> states) const {
  if (states.size() != meshes_.size()) {
    throw Error(ErrorCode::invalid_argument, "states has " + std::to_string(states.size()) +
                                                 " elements, but there are " +
                                                 std::to_string(meshes_.size()) + " bodies");
  }
  SurfaceFrame frame;
  frame.time = time;
  frame.names = names_;
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    const uint32_t first = static_cast<uint32_t>(frame.vertices.size());
    for (const Vec3 p : meshes_[i].vertices) frame.vertices.push_back(to_world(states[i].pose, p));
    for (const auto& [a, b, c] : meshes_[i].triangles) {
      frame.triangles.push_back({first + a, first + b, first + c});
      frame.bodies.push_back(static_cast<uint32_t>(i));
    }
  }
  return frame;
}

}  // namespace meniscus::io
