// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The action of a particle on a mesh finer than the particles. Otherwise vertices between the touched
// triangles would stay unloaded.
#pragma once

#include "collision/fluid_cloth/area.h"
#include "collision/fluid_cloth/cloth_surface.h"
#include "collision/fluid_cloth/marks.h"
#include "collision/fluid_cloth/tuning.h"
#include "pbd/device/base/atomics.h"

namespace meniscus::collision::fluid_cloth_kernels {

/// The place from which a contact is distributed.
struct SpreadAround {
  Vec3 point, normal;
  float radius;  // m
  uint32_t piece;
  uint32_t world;
};

/// The vertices near a contact, each with a kernel's weight, as a warp gathers them in the contact. The
/// weights are corrected so that they reproduce constants and the point itself (moving least squares). So
/// forces across the cloth exert no torque.
class Spread {
 public:
  MENISCUS_HD Spread(const Surface& surface, const SpreadAround& around, FluidClothContact& touch)
      : surface_(surface), around_(around), axes_(around.normal), touch_(touch) {}

  /// Whether there were more vertices than fit. The weights of those that fit are corrected all the same.
  MENISCUS_HD bool is_cut() const { return cut_; }
  /// The number of vertices that share the contact; 0 where they are too few, or all on one side.
  MENISCUS_HD uint32_t find() {
    const float r = around_.radius;
    pbd::for_each_place_in_warp(surface_.tree, around_.world,
                                pbd::inflated({around_.point, around_.point}, r),
                                pbd::GroupsInBall{surface_.tree, around_.point, r},
                                [&](uint32_t place, bool overlaps) { add(place, overlaps); });
    SearchTeam::sync();
    return count_ >= 4 && correct() ? count_ : 0;
  }

 private:
  struct Offset {
    float u, v;    // over the radius
    float weight;  // not corrected; 0 or less beyond the radius
  };

  MENISCUS_HD Offset offset(uint32_t vertex) const {
    const float r = around_.radius;
    const Vec3 d = surface_.end(vertex) - around_.point;
    const float left = pbd::max(0, 1 - dot(d, d) / (r * r));
    return {dot(d, axes_.u) / r, dot(d, axes_.v) / r, left * left};
  }

  /// Adds those of a triangle's vertices that it is the first to use.
  MENISCUS_HD void add(uint32_t place, bool overlaps) {
    const pbd::SurfaceTriangle t = load(surface_.tree.triangles, place);
    const uint32_t firsts =
        overlaps && t.piece == around_.piece ? surface_.marks[place] >> first_use_mark : 0;
    const uint32_t corner[3] = {t.a, t.b, t.c};
    uint32_t near = 0;
    for (uint32_t k = 0; k < 3; ++k)
      if ((firsts >> k & 1) && offset(corner[k]).weight > 0) near |= 1u << k;
    const uint32_t many = pbd::bit_count(near);
    uint32_t at = count_ + SearchTeam::sum_before(many);
    for (uint32_t k = 0; k < 3; ++k) {
      if (!(near >> k & 1) || at >= FluidClothContact::most_vertices) continue;
      const Offset o = offset(corner[k]);
      touch_.set(at++, corner[k], o.weight);
      one_ += o.weight, u_ += o.weight * o.u, v_ += o.weight * o.v;
      uu_ += o.weight * o.u * o.u, uv_ += o.weight * o.u * o.v, vv_ += o.weight * o.v * o.v;
    }
    count_ += SearchTeam::sum(many);
    if (count_ <= FluidClothContact::most_vertices) return;
    count_ = FluidClothContact::most_vertices;
    cut_ = true;
  }

  /// Corrects the weights by the first row of the inverse of the moment matrix.
  MENISCUS_HD bool correct() const {
    const float one = SearchTeam::sum(one_), u = SearchTeam::sum(u_), v = SearchTeam::sum(v_);
    const float uu = SearchTeam::sum(uu_), uv = SearchTeam::sum(uv_), vv = SearchTeam::sum(vv_);
    const float a = uu * vv - uv * uv, b = uv * v - u * vv, c = u * uv - uu * v;
    const float determinant = one * a + u * b + v * c;
    bool good = determinant > fluid_cloth_tuning::least_moments * one * one * one;
    for (uint32_t k = SearchTeam::rank(); k < count_ && good; k += SearchTeam::count()) {
      const Offset o = offset(touch_.vertex[k]);
      touch_.weight[k] *= (a + b * o.u + c * o.v) / determinant;
      good = touch_.weight[k] >= 0;
    }
    return !SearchTeam::any(!good);
  }

  const Surface& surface_;
  const SpreadAround& around_;
  const Tangents axes_;
  FluidClothContact& touch_;
  uint32_t count_ = 0;
  bool cut_ = false;
  float one_ = 0, u_ = 0, v_ = 0, uu_ = 0, uv_ = 0, vv_ = 0;
};

/// Distributes a contact among the vertices within the radius, or within a smaller one near a border. Returns
/// their number, or 0 where no radius works. Counts the contact in `cuts` if a radius had more than fit.
MENISCUS_HD inline uint32_t spread_out(const Surface& surface, const SpreadAround& around,
                                       FluidClothContact& touch, uint32_t& cuts) {
  using namespace fluid_cloth_tuning;
  bool is_cut = false;
  uint32_t vertices = 0;
  for (float r = around.radius; r > least_spread * around.radius && vertices == 0; r *= next_spread) {
    const SpreadAround within{around.point, around.normal, r, around.piece, around.world};
    Spread spread(surface, within, touch);
    vertices = spread.find();
    is_cut = is_cut || spread.is_cut();
  }
  if (is_cut && SearchTeam::leads()) pbd::atomic_add(cuts, 1);
  return vertices;
}

}  // namespace meniscus::collision::fluid_cloth_kernels
