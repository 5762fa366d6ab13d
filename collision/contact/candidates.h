// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Lists of candidate shapes for particles. Particles that are neighbours in memory are neighbours in space,
// so 32 of them share one list, with one bit a shape.
#pragma once

#include "collision/contact/find_contact.h"
#include "pbd/device/buffer.h"

namespace meniscus::collision {

inline constexpr uint32_t cluster_size = 32;  ///< particles, as many as a warp has threads

/// The worlds of a batch's particles. Those of fluids come first, then vertices, both world after world; then
/// points of faces, in the order of their triangles.
struct ParticleWorlds {
  uint32_t worlds = 1;
  uint32_t fluid = 0, vertices = 0, faces = 0;  ///< of a world
  pbd::View<const uint32_t> triangle_of{};      ///< by point of a face; no_index where it is not in use

  MENISCUS_HD uint32_t of(uint32_t i) const {
    if (worlds == 1) return 0;
    if (i < worlds * fluid) return i / fluid;
    const uint32_t v = i - worlds * fluid;
    if (v < worlds * vertices) return v / vertices;
    const uint32_t triangle = triangle_of[v - worlds * vertices];
    return triangle == pbd::no_index ? worlds - 1 : triangle / faces;
  }
  /// The first particle after i that may be of another world.
  MENISCUS_HD uint32_t next_after(uint32_t i) const {
    if (i < worlds * fluid) return (i / fluid + 1) * fluid;
    const uint32_t v = i - worlds * fluid;
    return v < worlds * vertices ? worlds * fluid + (v / vertices + 1) * vertices : i + 1;
  }
};

/// The lists as kernels read them. In a batch of worlds a list names shapes by their places in a world, as a
/// cluster may have particles of several.
struct CandidateView {
  pbd::View<const uint32_t> masks;  ///< `words` words for each cluster, one bit a shape of a world
  uint32_t words = 0;
  ParticleWorlds of_worlds{};
  uint32_t fixed = 0, moving = 0;  ///< shapes; moving ones of one world

  /// Calls visit(shape) for each candidate, in the order of the shapes' numbers.
  template <class Visit>
  MENISCUS_HD void for_each(uint32_t particle, const Visit& visit) const {
    Walk walk = walk_from(particle);
    for (uint32_t shape = walk.next(); shape != pbd::no_index; shape = walk.next()) visit(shape);
  }

  /// The same, for planes and for shapes whose bounds are within `reach` (m) of the box of a motion.
  /// Scattered drops share hundreds of candidates, and each particle is near few of them. So bounds are
  /// loaded several at a time, and near shapes are collected first. Then all threads of a warp visit their
  /// shapes at once.
  template <class Visit>
  MENISCUS_HD void for_each_near(const ShapeSet& set, uint32_t particle, const Motion& motion, float reach,
                                 const Visit& visit) const {
    constexpr uint32_t batch = 4, room = 32;
    const Aabb box{min(motion.from, motion.to), max(motion.from, motion.to)};
    uint32_t aside[room], count = 0;
    Walk walk = walk_from(particle);
    for (bool more = true; more;) {
      uint32_t shapes[batch];
      Bounds bounds[batch];
      MENISCUS_UNROLL
      for (uint32_t k = 0; k < batch; ++k) shapes[k] = walk.next();
      more = shapes[batch - 1] != pbd::no_index;
      MENISCUS_UNROLL
      for (uint32_t k = 0; k < batch; ++k) bounds[k] = Bounds::of(set, shapes[k]);
      MENISCUS_UNROLL
      for (uint32_t k = 0; k < batch; ++k) {
        if (bounds[k].are_near(box, reach)) aside[count++] = shapes[k];
      }
      if (more && count <= room - batch) continue;
      for (uint32_t k = 0; k < count; ++k) visit(aside[k]);
      count = 0;
    }
  }

 private:
  /// Iterates over the bits of a cluster's words.
  struct Walk {
    const uint32_t *word, *end;
    uint32_t mask, first;
    uint32_t fixed, skipped;  ///< moving shapes of the worlds before

    MENISCUS_HD uint32_t next() {
      while (mask == 0) {
        if (word == end) return pbd::no_index;
        mask = *word++;
        first += 32;
      }
      const uint32_t bit = pbd::lowest_bit(mask);
      mask &= mask - 1;
      const uint32_t shape = first + bit;
      return shape < fixed ? shape : shape + skipped;
    }
  };

  MENISCUS_HD Walk walk_from(uint32_t particle) const {
    const uint32_t* word = masks.data + particle / cluster_size * words;
    return {word, word + words, 0, 0u - 32, fixed, of_worlds.of(particle) * moving};
  }
  /// All that the test needs of a shape. It is loaded at once, so no load waits for the result of another.
  struct Bounds {
    Aabb box;
    bool everywhere, nowhere;

    MENISCUS_HD static Bounds of(const ShapeSet& set, uint32_t number) {
      const bool nowhere = number == pbd::no_index;
      const Shape& shape = set.shapes[nowhere ? 0 : number];
      return {shape.bounds, shape.kind == ShapeKind::plane, nowhere};
    }
    MENISCUS_HD bool are_near(const Aabb& other, float reach) const {
      return (everywhere | !are_apart(other, box, reach)) & !nowhere;
    }
  };
};

namespace candidate_kernels {

MENISCUS_HD inline Aabb joined(const Aabb* boxes, uint32_t count) {
  Aabb all = boxes[0];
  for (uint32_t k = 1; k < count; ++k) all = {min(all.lower, boxes[k].lower), max(all.upper, boxes[k].upper)};
  return all;
}

/// Scratch memory: boxes of the motions of some clusters while they are joined.
struct BoundScratch {
  static constexpr uint32_t clusters = 4, parts = 8;  // parts: of a cluster

  Aabb motions[cluster_size * clusters], joined[parts * clusters];
};

/// Computes the box of the motions of each of some clusters: first each particle's, then joined by fours,
/// then by eights.
struct BoundClusters {
  using Scratch = BoundScratch;

  pbd::View<const pbd::Vec4> from, to;
  pbd::View<Aabb> bounds;
  uint32_t particles, clusters;

  /// Of a motion that is not finite: it leaves the box of its cluster, which others share, as it is.
  MENISCUS_HD static Aabb nowhere() {
    constexpr Vec3 far{pbd::most_finite, pbd::most_finite, pbd::most_finite};
    return {far, -far};
  }

  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch& scratch, uint32_t n) const {
    constexpr uint32_t each = cluster_size / Scratch::parts;
    const uint32_t begin = n * cluster_size * Scratch::clusters, first = n * Scratch::clusters;
    group.for_each(cluster_size * Scratch::clusters, [&](uint32_t k) {
      const uint32_t i = begin + k < particles ? begin + k : particles - 1;
      const Vec3 a = pbd::load(from, i).xyz(), b = pbd::load(to, i).xyz();
      scratch.motions[k] = is_finite(a) && is_finite(b) ? Aabb{min(a, b), max(a, b)} : nowhere();
    });
    group.for_each(Scratch::parts * Scratch::clusters,
                   [&](uint32_t k) { scratch.joined[k] = joined(scratch.motions + each * k, each); });
    group.for_each(Scratch::clusters, [&](uint32_t k) {
      if (first + k < clusters)
        bounds[first + k] = joined(scratch.joined + Scratch::parts * k, Scratch::parts);
    });
  }
};

/// Scratch memory of MarkCandidates, for some neighbouring clusters and some words of shapes.
struct MarkScratch {
  static constexpr uint32_t clusters = 32, words = 4, shapes = 32 * words, parts = 8;

  Aabb boxes[clusters], joined[parts], all;
  bool near_any[shapes];
  uint32_t near_any_mask[words];
};

/// Marks the candidates of each cluster. Shapes are first tested against one box around all those clusters,
/// so each cluster tests few.
struct MarkCandidates {
  using Scratch = MarkScratch;

  ShapeSet set;
  pbd::View<const Aabb> bounds;
  pbd::View<uint32_t> masks;
  uint32_t particles, clusters, words;
  float reach;
  ParticleWorlds worlds;

  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch& scratch, uint32_t n) const {
    const uint32_t cluster_groups = groups_of(clusters, Scratch::clusters);
    const uint32_t first = n % cluster_groups * Scratch::clusters;
    const uint32_t first_word = n / cluster_groups * Scratch::words;
    find_near_any(group, scratch, first, first_word);
    group.for_each(Scratch::clusters * Scratch::words, [&](uint32_t k) {
      const uint32_t c = k % Scratch::clusters, w = k / Scratch::clusters;
      if (first + c >= clusters || first_word + w >= words) return;
      uint32_t near = 0;
      for (uint32_t mask = scratch.near_any_mask[w]; mask; mask &= mask - 1) {
        const uint32_t bit = pbd::lowest_bit(mask);
        const bool is = is_near_any_of(32 * (first_word + w) + bit, first + c, scratch.boxes[c]);
        near |= static_cast<uint32_t>(is) << bit;
      }
      masks[(first + c) * words + first_word + w] = near;
    });
  }

  template <class Group>
  MENISCUS_HD void find_near_any(const Group& group, Scratch& scratch, uint32_t first,
                                 uint32_t first_word) const {
    constexpr uint32_t each = Scratch::clusters / Scratch::parts;
    group.for_each(Scratch::clusters, [&](uint32_t k) {
      scratch.boxes[k] = bounds[first + k < clusters ? first + k : clusters - 1];
    });
    group.for_each(Scratch::parts,
                   [&](uint32_t k) { scratch.joined[k] = joined(scratch.boxes + each * k, each); });
    group.for_each(1, [&](uint32_t) { scratch.all = joined(scratch.joined, Scratch::parts); });
    group.for_each(Scratch::shapes, [&](uint32_t k) {
      const uint32_t number = 32 * first_word + k;
      scratch.near_any[k] =
          number < set.of_world() && (is_of_each_world(number) || is_near(set.shapes[number], scratch.all));
    });
    group.for_each(Scratch::words, [&](uint32_t w) {
      uint32_t mask = 0;
      for (uint32_t k = 0; k < 32; ++k) mask |= static_cast<uint32_t>(scratch.near_any[32 * w + k]) << k;
      scratch.near_any_mask[w] = mask;
    });
  }

  MENISCUS_HD bool is_of_each_world(uint32_t number) const {
    return worlds.worlds > 1 && number >= set.fixed;
  }
  /// Whether the shape is near the box of a cluster, in any world that the cluster has particles of.
  MENISCUS_HD bool is_near_any_of(uint32_t number, uint32_t cluster, const Aabb& box) const {
    if (!is_of_each_world(number)) return is_near(set.shapes[number], box);
    const uint32_t first = cluster * cluster_size,
                   end = first + cluster_size < particles ? first + cluster_size : particles;
    for (uint32_t i = first; i < end; i = worlds.next_after(i))
      if (is_near(set.shapes[set.number(number, worlds.of(i))], box)) return true;
    return false;
  }
  MENISCUS_HD bool is_near(const Shape& shape, const Aabb& box) const {
    return shape.kind == ShapeKind::plane || !out_of_reach(shape, box.lower, box.upper, reach);
  }
  MENISCUS_HD static uint32_t groups_of(uint32_t count, uint32_t each) { return (count + each - 1) / each; }
  MENISCUS_HD uint32_t groups() const {
    return groups_of(clusters, Scratch::clusters) * groups_of(words, Scratch::words);
  }
};

}  // namespace candidate_kernels

/// Owns the lists of candidates.
class Candidates {
 public:
  explicit Candidates(pbd::Device& device)
      : bounds_(device, "cluster boxes"), masks_(device, "shape candidates") {}

  /// `shapes`: of one world.
  void reserve(uint32_t particles, uint32_t shapes) {
    const uint32_t clusters = (particles + cluster_size - 1) / cluster_size;
    words_ = (shapes + 31) / 32;
    bounds_.resize_discard(clusters);
    masks_.resize_discard(size_t{clusters} * words_);
  }

  /// Finds the shapes within `reach` (m) of any motion of a cluster.
  template <class D>
  void find(D& device, const ShapeSet& set, pbd::View<const pbd::Vec4> from, pbd::View<const pbd::Vec4> to,
            uint32_t particles, float reach, const ParticleWorlds& worlds) {
    using namespace candidate_kernels;
    clusters_ = (particles + cluster_size - 1) / cluster_size;
    worlds_ = worlds;
    fixed_ = set.fixed;
    moving_ = set.moving();
    constexpr uint32_t each = BoundScratch::clusters;
    device.parallel_for_groups("contacts/clusters", (clusters_ + each - 1) / each,
                               BoundClusters{from, to, bounds_.view(), particles, clusters_});
    const MarkCandidates mark{set,       bounds_.view(), masks_.view(), particles,
                              clusters_, words_,         reach,         worlds};
    device.parallel_for_groups("contacts/candidates", mark.groups(), mark);
  }

  CandidateView view() const { return {masks_.view(), words_, worlds_, fixed_, moving_}; }

 private:
  uint32_t words_ = 0, clusters_ = 0;
  ParticleWorlds worlds_;
  uint32_t fixed_ = 0, moving_ = 0;  // see CandidateView
  pbd::Buffer<Aabb> bounds_;
  pbd::Buffer<uint32_t> masks_;
};

}  // namespace meniscus::collision
