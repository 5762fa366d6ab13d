// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Signed distance fields in a device's memory, and their construction from a mesh.
#pragma once

#include "collision/mesh/triangle_bvh.h"
#include "collision/sdf/sdf.h"

namespace meniscus::collision {

/// Owns a signed distance field in a device's memory.
class Sdf {
 public:
  /// Allocates a field on these nodes, without values.
  Sdf(pbd::Device& device, const Lattice& nodes)
      : nodes_(nodes), values_(device, "signed distance field"), density_(device, "density map") {
    values_.resize_discard(nodes.count());
  }

  SdfView view() const { return {{nodes_, values_.view()}, density_.view()}; }
  const Lattice& nodes() const { return nodes_; }
  pbd::Buffer<float>& values() { return values_; }
  const pbd::Buffer<float>& values() const { return values_; }
  /// Empty until build_density_map fills it.
  pbd::Buffer<pbd::Vec4>& density() { return density_; }
  const pbd::Buffer<pbd::Vec4>& density() const { return density_; }

 private:
  Lattice nodes_;
  pbd::Buffer<float> values_;
  pbd::Buffer<pbd::Vec4> density_;
};

/// Builds the field of a mesh, on a grid that reaches `margin` (m) beyond the mesh's box. The magnitude at a
/// node is the exact distance to the nearest triangle. The sign is the winding number's. Where the sign
/// changes without a triangle, as in a hole, the surface of the change closes the solid. Distances are to it
/// as well. Throws Error(invalid_argument) when cell_size (m) or margin is out of range, or the grid would be
/// too large.
template <class D>
Sdf build_sdf(D& device, const DeviceTriangleBvh& mesh, float cell_size, float margin);

}  // namespace meniscus::collision
