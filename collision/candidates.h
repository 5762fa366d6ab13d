// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Which shapes a particle may meet. Particles that are neighbours in memory are neighbours in space: 32 of
// them share one list, a bit a shape.
#pragma once

#include "collision/find_contact.h"
#include "pbd/device/buffer.h"

namespace meniscus::collision {

inline constexpr uint32_t cluster_size = 32;  ///< particles; a warp's

/// For kernels.
struct CandidateView {
  pbd::View<const uint32_t> masks;  ///< `words` a cluster
  uint32_t words = 0;

  /// Calls visit(shape) for each, in the order of their numbers.
  template <class Visit>
  MENISCUS_HD void for_each(uint32_t particle, const Visit& visit) const {
    const uint32_t first = particle / cluster_size * words;
    for (uint32_t w = 0; w < words; ++w) {
      for (uint32_t mask = masks[first + w]; mask; mask &= mask - 1) visit(32 * w + pbd::lowest_bit(mask));
    }
  }
};

namespace candidate_kernels {

/// The box of all motions of a cluster.
struct BoundClusters {
  pbd::View<const pbd::Vec4> from, to;
  pbd::View<Aabb> bounds;
  uint32_t particles;

  MENISCUS_HD void operator()(uint32_t c) const {
    const uint32_t begin = c * cluster_size;
    const uint32_t end = begin + cluster_size < particles ? begin + cluster_size : particles;
    Aabb box{from[begin].xyz(), from[begin].xyz()};
    for (uint32_t i = begin; i < end; ++i) {
      const Vec3 a = from[i].xyz(), b = to[i].xyz();
      box = {min(box.lower, min(a, b)), max(box.upper, max(a, b))};
    }
    bounds[c] = box;
  }
};

struct MarkCandidates {
  ShapeSet set;
  pbd::View<const Aabb> bounds;
  pbd::View<uint32_t> masks;
  uint32_t words;
  float reach;

  MENISCUS_HD void operator()(uint32_t n) const {
    const Aabb box = bounds[n / words];
    const uint32_t first = n % words * 32;
    const uint32_t count = set.shapes.count - first < 32 ? set.shapes.count - first : 32;
    uint32_t mask = 0;
    for (uint32_t k = 0; k < count; ++k) {
      const Shape& shape = set.shapes[first + k];
      const bool near = shape.kind == ShapeKind::plane || !out_of_reach(shape, box.lower, box.upper, reach);
      mask |= static_cast<uint32_t>(near) << k;
    }
    masks[n] = mask;
  }
};

}  // namespace candidate_kernels

/// Owns the lists.
class Candidates {
 public:
  explicit Candidates(pbd::Device& device)
      : bounds_(device, "cluster boxes"), masks_(device, "shape candidates") {}

  void reserve(uint32_t particles, uint32_t shapes) {
    const uint32_t clusters = (particles + cluster_size - 1) / cluster_size;
    words_ = (shapes + 31) / 32;
    bounds_.resize_discard(clusters);
    masks_.resize_discard(size_t{clusters} * words_);
  }

  /// Finds the shapes within `reach` (m) of any motion of a cluster.
  template <class D>
  void find(D& device, const ShapeSet& set, pbd::View<const pbd::Vec4> from, pbd::View<const pbd::Vec4> to,
            uint32_t particles, float reach) {
    using namespace candidate_kernels;
    const uint32_t clusters = (particles + cluster_size - 1) / cluster_size;
    device.parallel_for("contacts/clusters", clusters, BoundClusters{from, to, bounds_.view(), particles});
    device.parallel_for("contacts/candidates", clusters * words_,
                        MarkCandidates{set, bounds_.view(), masks_.view(), words_, reach});
  }

  CandidateView view() const { return {masks_.view(), words_}; }

 private:
  uint32_t words_ = 0;
  pbd::Buffer<Aabb> bounds_;
  pbd::Buffer<uint32_t> masks_;
};

}  // namespace meniscus::collision
