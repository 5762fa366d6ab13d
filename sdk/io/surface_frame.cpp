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

/// Adds the triangles of solid i.
void place(SurfaceFrame& frame, const collision::TriangleMesh& mesh, const Pose& pose, uint32_t i) {
  const auto first = static_cast<uint32_t>(frame.vertices.size());
  for (const Vec3 p : mesh.vertices) frame.vertices.push_back(to_world(pose, p));
  for (const auto& [a, b, c] : mesh.triangles) {
    frame.triangles.push_back({first + a, first + b, first + c});
    frame.bodies.push_back(i);
  }
}

}  // namespace

BodySurfaces::BodySurfaces(const std::vector<BodyDef>& bodies) {
  for (const BodyDef& body : bodies) {
    meshes_.push_back(solid_mesh(body.geometry));
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
    place(frame, meshes_[i], states[i].pose, static_cast<uint32_t>(i));
    const BodyState& s = states[i];
    for (std::size_t v = frame.velocities.size(); v < frame.vertices.size(); ++v)
      frame.velocities.push_back(s.velocity +
                                 cross(s.angular_velocity, frame.vertices[v] - s.centre_of_mass));
  }
  return frame;
}

collision::TriangleMesh solid_mesh(const Geometry& geometry) {
  return welded(solid_triangles(geometry));
}

SurfaceFrame shape_surfaces(const std::vector<ShapeDef>& shapes) {
  SurfaceFrame frame;
  frame.kind = "shape";
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    frame.names.push_back(shapes[i].name);
    place(frame, solid_mesh(shapes[i].geometry), shapes[i].pose, static_cast<uint32_t>(i));
  }
  frame.velocities.resize(frame.vertices.size(), {0, 0, 0});
  return frame;
}

}  // namespace meniscus::io
