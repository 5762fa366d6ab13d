// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Kernels that find the pairs of parts whose boxes overlap. Small parts lie in a grid of cells. Large ones,
// and planes, are tested against all others.
#pragma once

#include "collision/rigid_contact/ground_manifolds.h"
#include "collision/rigid_contact/rigid_contacts.h"
#include "collision/rigid_contact/tuning.h"
#include "pbd/device/base/view.h"

namespace meniscus::collision::rigid_contact_kernels {

using pbd::View;

/// A part in the world, with its box.
struct PlacedPart {
  Pose pose;
  Vec3 half;   ///< m, of the box around it
  float near;  ///< m: how far from another small part it is still in contact
  float far;   ///< m: likewise from a large one
  bool moves;  ///< contacts move its body
};

struct Cell {
  int x, y, z;

  friend MENISCUS_HD bool operator==(Cell a, Cell b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
};

/// The grid of small parts, hashed into 2^bits buckets.
struct CellGrid {
  float size;  ///< m; no small part reaches beyond the next cell
  uint32_t bits;

  MENISCUS_HD Cell cell_of(Vec3 p) const {
    // Far away, cells would not fit the integers. They are only a hash, so all there share one.
    const auto along = [this](float x) {
      return static_cast<int>(floorf(pbd::clamp(x / size, -1e9f, 1e9f)));
    };
    return {along(p.x), along(p.y), along(p.z)};
  }
  MENISCUS_HD uint32_t bucket_of(Cell c) const {
    const uint32_t h = static_cast<uint32_t>(c.x) * 73856093u ^ static_cast<uint32_t>(c.y) * 19349663u ^
                       static_cast<uint32_t>(c.z) * 83492791u;
    return (h ^ h >> 15) & ((1u << bits) - 1);
  }
};

/// Half extents of the box around a part.
MENISCUS_HD inline Vec3 extents_of(const Convex& shape, Quat turn) {
  if (shape.kind == ConvexKind::plane) return {1e30f, 1e30f, 1e30f};
  if (shape.kind == ConvexKind::box || shape.kind == ConvexKind::hull || shape.kind == ConvexKind::ground) {
    return shape.size.x * abs(rotate(turn, {1, 0, 0})) + shape.size.y * abs(rotate(turn, {0, 1, 0})) +
           shape.size.z * abs(rotate(turn, {0, 0, 1}));
  }
  const float half = shape.kind == ConvexKind::capsule ? shape.size.y : 0;
  return half * abs(rotate(turn, {0, 1, 0})) + Vec3{shape.size.x, shape.size.x, shape.size.x};
}

/// Places a part, and notes its bucket. Large parts have a bucket behind all others.
struct PlaceParts {
  View<const ContactPart> parts;
  View<const ContactBody> bodies;
  View<const uint32_t> is_large;
  View<PlacedPart> placed;
  View<uint32_t> bucket, number;
  CellGrid grid;
  float dt;

  MENISCUS_HD void operator()(uint32_t i) const {
    const ContactPart part = parts[i];
    PlacedPart p{part.pose, {0, 0, 0}, 0, 0, false};
    float way = 0;
    const float radius = is_unbounded(part.shape) ? 0 : bounding_radius(part.shape);
    const float size = part.shape.kind == ConvexKind::ground ? length(part.shape.size) : radius;
    if (part.body != pbd::no_index) {
      const ContactBody body = bodies[part.body];
      p.pose = body.pose * part.pose;
      p.moves = body.inverse_mass > 0;
      way = dt * (length(body.velocity) + dt * length(body.acceleration) +
                  (size + length(part.pose.position)) * length(body.angular));
    }
    p.half = extents_of(part.shape, p.pose.rotation);
    p.far = rigid_contact_tuning::margin * radius + way;
    p.near = pbd::min(p.far, rigid_contact_tuning::most_reach * radius);  // cells are as wide
    placed[i] = p;
    bucket[i] = is_large[i] ? 1u << grid.bits : grid.bucket_of(grid.cell_of(p.pose.position));
    number[i] = i;
  }
};

/// Finds where each bucket begins. `starts` has one more than all buckets.
struct FindBuckets {
  View<const uint32_t> sorted;
  View<uint32_t> starts;

  MENISCUS_HD void operator()(uint32_t k) const {
    const uint32_t count = sorted.count;
    const uint32_t here = k < count ? sorted[k] : starts.count - 1;
    const uint32_t before = k > 0 ? sorted[k - 1] + 1 : 0;
    for (uint32_t b = before; b <= here && b < starts.count; ++b) starts[b] = k;
  }
};

/// Two parts that may be in contact. A plane is only ever b.
struct PartPair {
  uint32_t a, b;
};

struct PairSearch {
  View<const ContactPart> parts;
  View<const PlacedPart> placed;
  View<const uint32_t> is_large, large, starts, sorted;
  CellGrid grid;

  MENISCUS_HD bool may_touch(uint32_t i, uint32_t j) const {
    const ContactPart &a = parts[i], &b = parts[j];
    const float reach = reach_of(i, j);
    const Vec3 apart = abs(placed[i].pose.position - placed[j].pose.position);
    const Vec3 most = placed[i].half + placed[j].half + Vec3{reach, reach, reach};
    return apart.x <= most.x && apart.y <= most.y && apart.z <= most.z &&
           (placed[i].moves || placed[j].moves) && (a.body != b.body || a.body == pbd::no_index) &&
           (a.groups & b.mask) != 0 && (b.groups & a.mask) != 0;
  }

  /// A ground has several manifolds with a part.
  MENISCUS_HD uint32_t entries(uint32_t i, uint32_t j) const {
    const bool any = parts[i].shape.kind == ConvexKind::ground || parts[j].shape.kind == ConvexKind::ground;
    return any ? most_ground_normals : 1;
  }

  /// m: how far apart two parts may be in contact.
  MENISCUS_HD float reach_of(uint32_t i, uint32_t j) const {
    return is_large[i] || is_large[j] ? placed[i].far + placed[j].far : placed[i].near + placed[j].near;
  }

  /// Calls visit(j) for all partners of i that come after it, in a fixed order.
  template <class Visit>
  MENISCUS_HD void for_each_partner(uint32_t i, const Visit& visit) const {
    for (uint32_t k = 0; k < large.count; ++k) {
      const uint32_t j = large[k];
      if ((j > i || !is_large[i]) && j != i && may_touch(i, j)) visit(j);
    }
    if (is_large[i]) return;
    const Cell c = grid.cell_of(placed[i].pose.position);
    for (int n = 0; n < 27; ++n) {
      const Cell near{c.x + n % 3 - 1, c.y + n / 3 % 3 - 1, c.z + n / 9 - 1};
      const uint32_t bucket = grid.bucket_of(near);
      for (uint32_t k = starts[bucket]; k < starts[bucket + 1]; ++k) {
        const uint32_t j = sorted[k];
        // Cells may share a bucket.
        if (j > i && may_touch(i, j) && grid.cell_of(placed[j].pose.position) == near) visit(j);
      }
    }
  }
};

struct CountPairs {
  PairSearch search;
  View<uint32_t> count;

  MENISCUS_HD void operator()(uint32_t i) const {
    uint32_t found = 0;
    search.for_each_partner(i, [&](uint32_t j) { found += search.entries(i, j); });
    count[i] = found;
  }
};

struct ListPairs {
  PairSearch search;
  View<const uint32_t> starts;
  View<PartPair> pairs;

  MENISCUS_HD void operator()(uint32_t i) const {
    uint32_t at = starts[i];
    search.for_each_partner(i, [&](uint32_t j) {
      for (uint32_t n = search.entries(i, j); n > 0; --n) pairs[at++] = {i, j};
    });
  }
};

}  // namespace meniscus::collision::rigid_contact_kernels
