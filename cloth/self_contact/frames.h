// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Frames of reference in which cloth moves little, so that pairs are searched for by relative motion.
#pragma once

#include <cstring>

#include "cloth/self_contact/views.h"
#include "pbd/contacts.h"
#include "pbd/math/hash.h"
#include "pbd/math/units.h"

namespace meniscus::cloth::self_contact_kernels {

/// Boxes around vectors that any number of threads add. By row; 0 is the empty box.
struct VectorBoxes {
  View<uint32_t> keys;  // six a row: upper limits, then lower limits

  MENISCUS_HD void clear(uint32_t row) const {
    for (uint32_t k = 0; k < 6; ++k) keys[6 * row + k] = 0;
  }
  MENISCUS_HD void add(uint32_t row, Vec3 a) const {
    if (!(dot(a, a) < pbd::most_finite)) return;
    const float limits[6] = {a.x, a.y, a.z, -a.x, -a.y, -a.z};
    for (uint32_t k = 0; k < 6; ++k) pbd::atomic_max(keys[6 * row + k], key_of(limits[k]));
  }
  /// Also while others add to it.
  MENISCUS_HD bool is_empty(uint32_t row) const { return pbd::atomic_load(keys[6 * row]) == 0; }
  MENISCUS_HD Aabb box(uint32_t row) const {
    const auto limit = [&](uint32_t k) { return value_of(keys[6 * row + k]); };
    return {{-limit(3), -limit(4), -limit(5)}, {limit(0), limit(1), limit(2)}};
  }
  MENISCUS_HD void add_row(uint32_t row, uint32_t other) const {
    for (uint32_t k = 0; k < 6; ++k) pbd::atomic_max(keys[6 * row + k], keys[6 * other + k]);
  }

 private:
  /// Integers above 0 in the order of the numbers.
  MENISCUS_HD static uint32_t key_of(float a) {
    uint32_t bits;
    std::memcpy(&bits, &a, sizeof a);
    return bits >> 31 ? ~bits : bits | 1u << 31;
  }
  MENISCUS_HD static float value_of(uint32_t key) {
    const uint32_t bits = key >> 31 ? key & ~(1u << 31) : ~key;
    float a;
    std::memcpy(&a, &bits, sizeof a);
    return a;
  }
};

/// Sums of displacements over vertices, as integers, which have the same sum in any order. By row: three
/// numbers, and the number of vertices.
struct DisplacementSums {
  static constexpr float unit = 0x1p-32f, most = 0x1p10f;  // m

  View<int64_t> sums;

  MENISCUS_HD void clear(uint32_t row) const {
    for (uint32_t k = 0; k < 4; ++k) sums[4 * row + k] = 0;
  }
  MENISCUS_HD void add(uint32_t row, Vec3 sum, uint32_t vertices) const {
    pbd::atomic_add(sums[4 * row], pbd::whole_units(sum.x / unit));
    pbd::atomic_add(sums[4 * row + 1], pbd::whole_units(sum.y / unit));
    pbd::atomic_add(sums[4 * row + 2], pbd::whole_units(sum.z / unit));
    pbd::atomic_add(sums[4 * row + 3], int64_t{vertices});
  }
  MENISCUS_HD void add_row(uint32_t row, uint32_t other) const {
    for (uint32_t k = 0; k < 4; ++k) pbd::atomic_add(sums[4 * row + k], sums[4 * other + k]);
  }
  MENISCUS_HD Vec3 mean(uint32_t row) const {
    const int64_t* sum = &sums[4 * row];
    if (sum[3] == 0) return {0, 0, 0};
    const double scale = double{unit} / static_cast<double>(sum[3]);
    const auto component = [&](int k) { return static_cast<float>(scale * static_cast<double>(sum[k])); };
    return {component(0), component(1), component(2)};
  }
  /// A displacement that is not finite, or no sensible one, counts as far as the sums reach.
  MENISCUS_HD static Vec3 limited(Vec3 a) {
    const auto limit = [](float x) { return x > -most ? (x < most ? x : most) : -most; };
    return {limit(a.x), limit(a.y), limit(a.z)};
  }
};

/// How pieces move in this substep, and what they touch. Rows: the pieces, then the frames.
struct Surroundings {
  DisplacementSums displacements;
  VectorBoxes immovable, movable;  // m: the motions of what touches cloth

  MENISCUS_HD void clear(uint32_t row) const {
    displacements.clear(row);
    immovable.clear(row);
    movable.clear(row);
  }
  MENISCUS_HD void add_row(uint32_t row, uint32_t other) const {
    displacements.add_row(row, other);
    immovable.add_row(row, other);
    movable.add_row(row, other);
  }
  /// The displacement of the frame in which the cloth of a row stands still most nearly, and in w how far
  /// from that (m) what touches it moves. Cloth that touches something may be stopped by it, so that comes
  /// first, and what does not give way before what does.
  MENISCUS_HD Vec4 frame(uint32_t row) const {
    const bool is_stopped = !immovable.is_empty(row);
    if (!is_stopped && movable.is_empty(row)) return pbd::with_w(displacements.mean(row), 0);
    const Aabb box = (is_stopped ? immovable : movable).box(row);
    return pbd::with_w(0.5f * (box.lower + box.upper),
                       is_stopped ? 0.5f * length(box.upper - box.lower) : 0.0f);
  }
  /// Whether the frame still suits what touches the cloth of a row; `margin` in m.
  MENISCUS_HD bool suits(uint32_t row, const Vec4& frame, float margin) const {
    const auto far = [&](Vec3 a) { return length(a - frame.xyz()); };
    if (!immovable.is_empty(row)) {
      const Aabb box = immovable.box(row);
      const Vec3 m = frame.xyz();
      return length(max(box.upper - m, m - box.lower)) <= frame.w + margin;
    }
    return movable.is_empty(row) || far(this->frame(row).xyz()) <= margin;
  }
};

/// Working memory of a group of threads that sums up the displacements of groups of triangles.
struct MotionScratch {
  static constexpr uint32_t groups = 64;

  Vec3 sum[groups];  // m
  uint32_t vertices[groups], piece[groups];
};

/// Sums up the displacements of each piece. What nothing moves counts as immovable surroundings.
struct SumMotion {
  using Scratch = MotionScratch;

  ClothState cloth;
  Surroundings around;

  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch& scratch, uint32_t n) const {
    const GroupRange range(n, Scratch::groups, cloth.of_world.groups);
    const uint32_t first = range.first, count = range.count;
    group.for_each(count, [&](uint32_t k) { sum(scratch, k, first + k); });
    // The first group of each piece adds up the groups of that piece which follow it.
    group.for_each(count, [&](uint32_t k) {
      const uint32_t piece = scratch.piece[k];
      if (k > 0 && scratch.piece[k - 1] == piece) return;
      Vec3 sum{0, 0, 0};
      uint32_t vertices = 0;
      for (uint32_t other = k; other < count && scratch.piece[other] == piece; ++other) {
        sum += scratch.sum[other];
        vertices += scratch.vertices[other];
      }
      around.displacements.add(piece, sum, vertices);
    });
  }

 private:
  /// Each vertex belongs to one of its triangles.
  MENISCUS_HD void sum(Scratch& scratch, uint32_t k, uint32_t g) const {
    Vec3 sum{0, 0, 0};
    uint32_t vertices = 0;
    const uint32_t piece = cloth.tree.triangles[8 * g].piece;
    for (uint32_t place = 8 * g; place < 8 * g + 8; ++place) {
      const SurfaceTriangle t = load(cloth.tree.triangles, place);
      for (uint32_t corner = 0; corner < 3; ++corner) {
        if (!(cloth.features[place] & owns_vertex << corner)) continue;
        const uint32_t v = corner_of(t, corner);
        const Vec4 x = cloth.position[v];
        const Vec3 displacement = x.xyz() - cloth.previous[v].xyz();
        if (x.w == 0) around.immovable.add(piece, displacement);
        sum += DisplacementSums::limited(displacement);
        ++vertices;
      }
    }
    scratch.sum[k] = sum;
    scratch.vertices[k] = vertices;
    scratch.piece[k] = piece;
  }
};

/// Records the motions of solids and fluid that touch cloth, by contact.
struct FindSurroundings {
  pbd::ContactView contacts;
  View<const Vec4> previous, position;  // by particle
  View<const pbd::Phase> phase;         // likewise
  View<const uint32_t> vertex_piece;
  uint32_t sorted;  // see ParticleView
  Surroundings around;

  MENISCUS_HD void operator()(uint32_t k) const {
    if (k >= contacts.total()) return;
    const uint32_t i = contacts.particle[k];
    const pbd::Contact& c = contacts.contacts[k];
    if (c.solid == pbd::no_index) return;
    if (c.body == pbd::on_cloth) {
      // What is immovable comes first. Then it does not matter whether this one is added.
      if (!around.immovable.is_empty(c.solid)) return;
      return around.movable.add(c.solid, position[i].xyz() - previous[i].xyz());
    }
    const uint32_t piece = piece_of(i);
    if (piece == no_index) return;
    (c.body_inverse_mass == 0 ? around.immovable : around.movable).add(piece, c.surface_motion);
  }

 private:
  MENISCUS_HD uint32_t piece_of(uint32_t i) const {
    if (i < sorted) return no_index;
    if (i - sorted < vertex_piece.count) return vertex_piece[i - sorted];
    return phase[i] & pbd::phase_face ? pbd::phase_group(phase[i]) : no_index;
  }
};

/// Chooses the frame of each piece for new lists of pairs. Pieces of about the same velocity share one:
/// displacements in the same cell of a grid. Cells are numbered by a hash, and two that share a number share
/// a frame, which is as right but may cost more.
struct ChooseFrames {
  View<uint32_t> all_counters;
  Surroundings around;
  View<const PieceProperties> pieces;
  View<uint32_t> frame_of, cell_of;  // by piece
  OfWorld of_world;
  View<const uint8_t> one;  // by world: one frame for all

  MENISCUS_HD void operator()(uint32_t piece) const {
    const uint32_t world = piece / of_world.pieces;
    const View<uint32_t> counters = counters_of(all_counters, world);
    if (counters[expired] == 0 || counters[overflowed] != 0) return;
    const uint32_t cell = cell_at(piece);
    cell_of[piece] = cell;
    frame_of[piece] = frame_at(world, cell);
    around.add_row(pieces.count + frame_of[piece], piece);
    if (frame_of[piece] != frame_at(world, cell_at(world * of_world.pieces)))
      pbd::atomic_max(counters[several_frames], 1);
  }

 private:
  MENISCUS_HD uint32_t frame_at(uint32_t world, uint32_t cell) const {
    return world * of_world.frames + (one[world] ? 0 : cell % of_world.frames);
  }
  MENISCUS_HD uint32_t cell_at(uint32_t piece) const {
    const Vec3 frame = around.frame(piece).xyz();
    const float scale = 1 / (self_contact_tuning::frame_cell * pieces[0].thickness);
    const auto number = [&](float x) {
      return static_cast<uint64_t>(static_cast<int64_t>(llrintf(pbd::clamp(scale * x, -1e6f, 1e6f))));
    };
    return static_cast<uint32_t>(
        pbd::mixed(number(frame.x) + pbd::mixed(number(frame.y) + pbd::mixed(number(frame.z)))));
  }
};

}  // namespace meniscus::cloth::self_contact_kernels
