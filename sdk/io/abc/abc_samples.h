// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Samples of Alembic's objects, made of what the writers take.
#pragma once

#include <Alembic/AbcGeom/All.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "collision/mesh/mesh.h"
#include "pbd/math/vec.h"
#include "sdk/io/mesh_parts.h"
#include "sdk/io/point_sets.h"
#include "sdk/io/scene_units.h"

namespace meniscus::io {

namespace abc = Alembic::Abc;
namespace geom = Alembic::AbcGeom;

/// Values in Alembic's types. Room for one more: Alembic takes an array without an address for none at all.
template <class To, class From, class Convert>
std::vector<To> converted(std::span<const From> values, const Convert& convert) {
  std::vector<To> all;
  all.reserve(values.size() + 1);
  for (const From& value : values) all.push_back(convert(value));
  return all;
}
inline std::vector<abc::V3f> vectors(std::span<const Vec3> values) {
  return converted<abc::V3f>(values, [](Vec3 v) { return abc::V3f(v.x, v.y, v.z); });
}
template <class Sample, class T>
Sample sample_of(const std::vector<T>& values) {
  return Sample(values.data(), values.size());
}

/// Triangles in Alembic's order, as numbers from the part's first vertex on.
struct Topology {
  std::vector<int32_t> corners, counts;

  Topology(std::span<const std::array<uint32_t, 3>> triangles, uint32_t first)
      : counts(triangles.size() + 1, 3) {
    counts.pop_back();
    corners.reserve(3 * triangles.size() + 1);
    for (const auto& [a, b, c] : triangles) {
      for (const uint32_t v : {a, c, b}) corners.push_back(static_cast<int32_t>(v - first));
    }
  }
};

inline void set_y_up(geom::OXform& object, Vec3 gravity) {
  geom::XformSample sample;
  sample.setXRotation(up_axis(gravity) == 'Z' ? -90 : 0);
  object.getSchema().set(sample);
}

inline void set_pose(geom::OXform& object, const Pose& pose) {
  // Imath's vectors are rows: the rows of the matrix are the turned axes.
  const Vec3 x = rotate(pose.rotation, {1, 0, 0}), y = rotate(pose.rotation, {0, 1, 0}),
             z = rotate(pose.rotation, {0, 0, 1}), p = pose.position;
  geom::XformSample sample;
  sample.setMatrix(abc::M44d(x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, p.x, p.y, p.z, 1));
  object.getSchema().set(sample);
}

inline void set_still(geom::OPolyMesh& object, const collision::TriangleMesh& mesh) {
  const std::vector<abc::V3f> points = vectors(mesh.vertices);
  const Topology topology(mesh.triangles, 0);
  object.getSchema().set({sample_of<abc::P3fArraySample>(points),
                          sample_of<abc::Int32ArraySample>(topology.corners),
                          sample_of<abc::Int32ArraySample>(topology.counts)});
}

/// `texture`: one a corner, or none.
template <class Frame>
void set_mesh(geom::OPolyMesh& object, const MeshPart& part, const Frame& frame,
              std::span<const TexturePoint> texture) {
  const std::vector<abc::V3f> points = vectors(part.vertices(frame.vertices)),
                              velocities = vectors(part.vertices(frame.velocities)),
                              normals = vectors(part.vertices(frame.normals));
  const Topology topology(part.triangles(frame.triangles), part.first_vertex);
  std::vector<abc::V2f> uvs;
  for (std::size_t k = 0; k + 2 < texture.size(); k += 3) {
    for (const std::size_t corner : {k, k + 2, k + 1}) uvs.emplace_back(texture[corner].u, texture[corner].v);
  }
  geom::OPolyMeshSchema::Sample sample(
      sample_of<abc::P3fArraySample>(points), sample_of<abc::Int32ArraySample>(topology.corners),
      sample_of<abc::Int32ArraySample>(topology.counts),
      uvs.empty() ? geom::OV2fGeomParam::Sample()
                  : geom::OV2fGeomParam::Sample(sample_of<abc::V2fArraySample>(uvs), geom::kFacevaryingScope),
      geom::ON3fGeomParam::Sample(sample_of<abc::N3fArraySample>(normals), geom::kVertexScope));
  sample.setVelocities(sample_of<abc::V3fArraySample>(velocities));
  object.getSchema().set(sample);
}

inline geom::OFloatGeomParam::Sample constant_width(const float& width) {
  return {abc::FloatArraySample(&width, 1), geom::kConstantScope};
}

inline void set_points(geom::OPoints& object, std::span<const Vec3> positions,
                       std::span<const Vec3> velocities, std::span<const uint64_t> ids, const float& width) {
  const std::vector<abc::V3f> points = vectors(positions), motion = vectors(velocities);
  const auto numbers = converted<uint64_t>(ids, [](uint64_t id) { return id; });
  object.getSchema().set({sample_of<abc::P3fArraySample>(points), sample_of<abc::UInt64ArraySample>(numbers),
                          sample_of<abc::V3fArraySample>(motion), constant_width(width)});
}

inline void set_rope(geom::OCurves& object, const RopeFrame& frame, std::size_t rope) {
  const RopePoints along = points_of_rope(frame, rope);
  const std::vector<abc::V3f> points = vectors(along.positions), velocities = vectors(along.velocities);
  const auto count = static_cast<int32_t>(points.size());
  const float width = 2 * frame.radii[rope];
  geom::OCurvesSchema::Sample sample(sample_of<abc::P3fArraySample>(points), abc::Int32ArraySample(&count, 1),
                                     geom::kLinear, geom::kNonPeriodic, constant_width(width));
  sample.setBasis(geom::kNoBasis);
  sample.setVelocities(sample_of<abc::V3fArraySample>(velocities));
  object.getSchema().set(sample);
}

}  // namespace meniscus::io
