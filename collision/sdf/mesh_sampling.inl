// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Kernels and functions that test points against the inside of a mesh.
#pragma once

#include <algorithm>

#include "collision/mesh/lattice.h"
#include "collision/mesh/triangle_bvh_query.h"
#include "collision/sdf/mesh_sampling.h"

namespace meniscus::collision {

namespace sampling_kernels {

constexpr uint32_t batch = 1u << 22;  // points at a time, to take little memory beside the particles'

struct TestPoints {
  TriangleBvhView mesh;
  pbd::View<const Vec3> points;
  pbd::View<uint8_t> inside;

  MENISCUS_HD void operator()(uint32_t i) const { inside[i] = is_inside(mesh, points[i]); }
};

struct TestLattice {
  TriangleBvhView mesh;
  Lattice lattice;
  uint32_t first;
  pbd::View<uint8_t> inside;

  MENISCUS_HD void operator()(uint32_t i) const { inside[i] = is_inside(mesh, lattice.point(first + i)); }
};

}  // namespace sampling_kernels

template <class D>
std::vector<uint8_t> points_inside(D& device, const DeviceTriangleBvh& mesh, std::span<const Vec3> points) {
  using namespace sampling_kernels;
  const auto room = static_cast<uint32_t>(std::min<size_t>(batch, points.size()));
  pbd::Buffer<Vec3> places(device, "points to test against a mesh");
  pbd::Buffer<uint8_t> flags(device, "points inside a mesh");
  places.resize_discard(room);
  flags.resize_discard(room);
  std::vector<uint8_t> inside(points.size());
  for (size_t first = 0; first < points.size(); first += batch) {
    const auto count = static_cast<uint32_t>(std::min<size_t>(batch, points.size() - first));
    places.write(points.subspan(first, count));
    device.parallel_for("points inside a mesh", count, TestPoints{mesh.view(), places.view(), flags.view()});
    flags.read(std::span(inside).subspan(first, count));
  }
  return inside;
}

template <class D>
std::vector<Vec3> lattice_points_inside(D& device, const DeviceTriangleBvh& mesh, float spacing) {
  using namespace sampling_kernels;
  const Lattice lattice = lattice_within(mesh.bounds(), spacing, "spacing");
  pbd::Buffer<uint8_t> flags(device, "lattice points inside a mesh");
  flags.resize_discard(std::min(batch, lattice.count()));
  std::vector<Vec3> points;
  for (uint32_t first = 0; first < lattice.count(); first += batch) {
    const uint32_t count = std::min(batch, lattice.count() - first);
    device.parallel_for("lattice inside a mesh", count,
                        TestLattice{mesh.view(), lattice, first, flags.view()});
    const std::vector<uint8_t> inside = flags.read(count);
    for (uint32_t i = 0; i < count; ++i) {
      if (inside[i]) points.push_back(lattice.point(first + i));
    }
  }
  return points;
}

}  // namespace meniscus::collision
