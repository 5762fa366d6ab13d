// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A tree of boxes over the triangles of a mesh, owned on the host and on a device. Kernels query it through
// triangle_bvh_query.h.
#pragma once

#include <vector>

#include "collision/mesh/mesh.h"
#include "collision/mesh/triangle.h"
#include "pbd/device/buffer.h"

namespace meniscus::collision {

/// Nodes are in preorder. The first child follows its parent, and the second one begins where the first one's
/// subtree ends.
struct BvhNode {
  Vec3 lower, upper;  ///< m
  uint32_t end;       ///< of the subtree
  uint32_t first;     ///< triangle of a leaf
  uint32_t count;     ///< triangles of a leaf, 0 elsewhere
};

/// The triangles of a node from afar: moments of their oriented area a·n about a centre.
struct FarField {
  Vec3 centre;           ///< m, weighted by area
  float radius;          ///< m; no corner lies further from the centre
  Vec3 dipole;           ///< m², Σ a n
  Vec3 diagonal, mixed;  ///< m³, Σ a (c − centre) ⊗ n: xx, yy, zz and the symmetric sums xy, yz, zx
};

struct TriangleBvhView {
  pbd::View<const BvhNode> nodes;
  pbd::View<const FarField> far_fields;  ///< one a node
  pbd::View<const Triangle> triangles;   ///< leaf by leaf
  pbd::View<const uint32_t> sources;     ///< by triangle of the tree: its number in the mesh
};

/// The tree in host memory. The same mesh gives the same tree.
class TriangleBvh {
 public:
  static constexpr uint32_t max_depth =
      32;  ///< levels; enough for any 32-bit number of triangles, because ranges are halved

  /// Throws Error(mesh) when there are no triangles.
  explicit TriangleBvh(const TriangleMesh& mesh);

  TriangleBvhView view() const;
  const std::vector<BvhNode>& nodes() const { return nodes_; }
  const std::vector<FarField>& far_fields() const { return far_fields_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  const std::vector<uint32_t>& sources() const { return sources_; }
  Aabb bounds() const { return {nodes_.front().lower, nodes_.front().upper}; }

 private:
  void build(uint32_t first, uint32_t count);

  std::vector<BvhNode> nodes_;
  std::vector<FarField> far_fields_;
  std::vector<Triangle> triangles_;
  std::vector<uint32_t> sources_;
};

/// A copy of the tree in a device's memory.
class DeviceTriangleBvh {
 public:
  DeviceTriangleBvh(pbd::Device& device, const TriangleBvh& host);

  TriangleBvhView view() const;
  Aabb bounds() const { return bounds_; }

 private:
  Aabb bounds_;
  pbd::Buffer<BvhNode> nodes_;
  pbd::Buffer<FarField> far_fields_;
  pbd::Buffer<Triangle> triangles_;
  pbd::Buffer<uint32_t> sources_;
};

}  // namespace meniscus::collision
