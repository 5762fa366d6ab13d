// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The surface of a fluid as triangles, by marching cubes over a scalar field of its ellipsoids (Yu & Turk
// 2013):
//   φ(x) = Σ a (1 − u²)³,   u² = |G (x − c)|² ≤ 1
// where G maps an ellipsoid that is `reach` times as large as the particle's to the unit ball. The field is
// sampled at the nodes of a sparse grid around particles (block_grid.h). It uses integers, whose sum does not
// depend on the order. The iso level is such that fluid whose particles end at a plane, on average, ends
// there. It is the mean over planes that cut the lattice smoothly and roughly, whose surfaces differ by 0.1
// s. The weight a is a power of the ellipsoid's volume, such that the sum inside a fluid is 1, and a single
// drop keeps its volume.
#pragma once

#include <meniscus/outputs.h>

#include <array>

#include "fluid/surface/anisotropy.h"
#include "fluid/surface/block_grid.h"
#include "fluid/surface/tuning.h"
#include "pbd/marching_cubes.h"
#include "pbd/particles.h"

namespace meniscus::fluid {

using pbd::CubeEdge;
using pbd::CubeTriangles;

struct SurfaceField {
  float cell = 0;                       ///< m, between nodes
  float reach = surface_tuning::reach;  ///< of a particle's influence, in radii of its ellipsoid
  float weight = 0;                     ///< a at unit_volume
  float power = 0;                      ///< exponent of unit_volume over an ellipsoid's own volume
  float unit_volume = 0;                ///< m³, the product of the radii inside a fluid
  float iso = 0;                        ///< φ at the surface
};

/// For rest spacing s and support radius h, m; sets all fields but the cell. Takes milliseconds.
SurfaceField calibrate_surface(double spacing, double support_radius);

inline constexpr uint32_t all_fluids = ~0u;

/// Which particles belong to the surface.
struct SurfaceMembers {
  pbd::View<const pbd::Phase> phase;
  uint32_t group = all_fluids;  ///< or the group of one material, which may be grains

  MENISCUS_HD bool count(uint32_t i) const {
    return group == all_fluids ? !pbd::is_grain(phase[i]) : pbd::phase_group(phase[i]) == group;
  }
};

/// Σ a (1 − u²)³ v at a node, in integers, whose sum does not depend on the order.
struct NodeMomentum {
  int64_t x, y, z;
};

template <class D>
class SurfaceMesher {
 public:
  explicit SurfaceMesher(D& device) : device_(device), blocks_(device) {}

  /// Builds the surface of the ellipsoids that belong to it, with the velocities of its vertices.
  /// `velocities` (m/s) are those of the particles. Leaves out ellipsoids that are not finite, or further
  /// than 2²¹ cells from the origin. Throws what BlockGrid throws. Its arrays are kept for the next call.
  void build(pbd::View<const Ellipsoid> ellipsoids, pbd::View<const pbd::Vec4> velocities,
             const SurfaceMembers& members, const SurfaceField& field);
  SurfaceMesh read() const;

 private:
  void sample(pbd::View<const Ellipsoid> ellipsoids, const SurfaceMembers& members,
              const SurfaceField& field);
  void count(uint32_t iso);
  void write(uint32_t iso, float cell);
  void write_velocities(pbd::View<const Ellipsoid> ellipsoids, pbd::View<const pbd::Vec4> velocities,
                        const SurfaceMembers& members, const SurfaceField& field, uint32_t iso);

  template <class T>
  static void grow(pbd::Buffer<T>& buffer, size_t size) {
    if (buffer.size() < size) buffer.resize_or_stay(size + size / 4);
  }

  D& device_;
  BlockGrid<D> blocks_;
  uint32_t vertex_count_ = 0, triangle_count_ = 0;
  pbd::Buffer<CubeTriangles> table_{device_, "marching cubes"};
  pbd::Buffer<uint32_t> values_{device_, "surface field"};
  pbd::Buffer<uint32_t> counts_{device_, "surface counts"};
  pbd::Buffer<uint32_t> vertex_start_{device_, "surface vertices by node"};
  pbd::Buffer<uint32_t> triangle_start_{device_, "surface triangles by node"};
  pbd::Buffer<Vec3> vertices_{device_, "surface vertices"};
  pbd::Buffer<Vec3> normals_{device_, "surface normals"};
  pbd::Buffer<std::array<uint32_t, 3>> triangles_{device_, "surface triangles"};
  pbd::Buffer<uint32_t> end_start_{device_, "surface nodes by node"};
  pbd::Buffer<NodeMomentum> momenta_{device_, "surface momenta"};
  pbd::Buffer<Vec3> velocities_{device_, "surface velocities"};
};

}  // namespace meniscus::fluid
