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
  pbd::View<const uint32_t> masks;  ///< the first 32 shapes of each cluster, then the next of each, …
  uint32_t words = 0, clusters = 0;

  /// Calls visit(shape) for each, in the order of their numbers.
  template <class Visit>
  MENISCUS_HD void for_each(uint32_t particle, const Visit& visit) const {
    const uint32_t cluster = particle / cluster_size;
    for (uint32_t w = 0; w < words; ++w) {
      uint32_t mask = masks[w * clusters + cluster];
      for (; mask; mask &= mask - 1) visit(32 * w + pbd::lowest_bit(mask));
    }
  }
};

namespace candidate_kernels {

/// Boxes of motions while those of some clusters are joined.
struct BoundScratch {
  static constexpr uint32_t clusters = 4, parts = 8;  // of a cluster

  Aabb motions[cluster_size * clusters], joined[parts * clusters];
};

/// The boxes of all motions of some clusters: at first each particle's, then joined by fours, then by eights.
struct BoundClusters {
  using Scratch = BoundScratch;

  pbd::View<const pbd::Vec4> from, to;
  pbd::View<Aabb> bounds;
  uint32_t particles, clusters;

  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch& scratch, uint32_t n) const {
    constexpr uint32_t each = cluster_size / Scratch::parts;
    const uint32_t begin = n * cluster_size * Scratch::clusters, first = n * Scratch::clusters;
    group.for_each(cluster_size * Scratch::clusters, [&](uint32_t k) {
      const uint32_t i = begin + k < particles ? begin + k : particles - 1;
      const Vec3 a = pbd::load(from, i).xyz(), b = pbd::load(to, i).xyz();
      scratch.motions[k] = {min(a, b), max(a, b)};
    });
    group.for_each(Scratch::parts * Scratch::clusters,
                   [&](uint32_t k) { scratch.joined[k] = joined(scratch.motions + each * k, each); });
    group.for_each(Scratch::clusters, [&](uint32_t k) {
      if (first + k < clusters)
        bounds[first + k] = joined(scratch.joined + Scratch::parts * k, Scratch::parts);
    });
  }

  MENISCUS_HD static Aabb joined(const Aabb* boxes, uint32_t count) {
    Aabb all = boxes[0];
    for (uint32_t k = 1; k < count; ++k)
      all = {min(all.lower, boxes[k].lower), max(all.upper, boxes[k].upper)};
    return all;
  }
};

/// Eight shapes for one cluster.
struct MarkCandidates {
  static constexpr uint32_t batch = 8, batches = 32 / batch;

  ShapeSet set;
  pbd::View<const Aabb> bounds;
  pbd::View<uint8_t> masks;  ///< the words' bytes, the lowest first
  uint32_t clusters;
  float reach;

  MENISCUS_HD void operator()(uint32_t n) const {
    const uint32_t part = n / clusters, cluster = n % clusters;
    const Aabb box = bounds[cluster];
    const uint32_t last = set.shapes.count - 1;
    uint32_t mask = 0;
    MENISCUS_UNROLL
    for (uint32_t k = 0; k < batch; ++k) {
      const uint32_t number = part * batch + k;
      const Shape& shape = set.shapes[number < last ? number : last];
      const bool near = shape.kind == ShapeKind::plane || !out_of_reach(shape, box.lower, box.upper, reach);
      mask |= static_cast<uint32_t>(near && number <= last) << k;
    }
    masks[batches * (part / batches * clusters + cluster) + part % batches] = static_cast<uint8_t>(mask);
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
    clusters_ = (particles + cluster_size - 1) / cluster_size;
    constexpr uint32_t each = BoundScratch::clusters;
    device.parallel_for_groups("contacts/clusters", (clusters_ + each - 1) / each,
                               BoundClusters{from, to, bounds_.view(), particles, clusters_});
    const pbd::View<uint8_t> bytes{reinterpret_cast<uint8_t*>(masks_.view().data), 4 * masks_.view().count};
    device.parallel_for("contacts/candidates", clusters_ * words_ * MarkCandidates::batches,
                        MarkCandidates{set, bounds_.view(), bytes, clusters_, reach});
  }

  CandidateView view() const { return {masks_.view(), words_, clusters_}; }

 private:
  uint32_t words_ = 0, clusters_ = 0;
  pbd::Buffer<Aabb> bounds_;
  pbd::Buffer<uint32_t> masks_;
};

}  // namespace meniscus::collision
