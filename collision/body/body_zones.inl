// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Functions of BodyZones; its kernels are in body_zones_find.h and body_zones_move.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "collision/body/body_zones.h"
#include "pbd/repeated.h"

namespace meniscus::collision {

/// By piece: the root of the mean area of two faces, which is an edge of a square grid, m.
inline std::vector<float> sizes_of(std::span<const pbd::SurfaceTriangle> triangles,
                                   std::span<const Vec3> rest, size_t pieces) {
  std::vector<float> area(pieces), count(pieces);
  for (const pbd::SurfaceTriangle& t : triangles) {
    area[t.piece] += length(cross(rest[t.b] - rest[t.a], rest[t.c] - rest[t.a]));
    count[t.piece] += 1;
  }
  for (size_t k = 0; k < pieces; ++k) area[k] = std::sqrt(area[k] / std::max(count[k], 1.0f));
  return area;
}

template <class D>
void BodyZones<D>::set_surface(const pbd::SurfaceView& surface,
                               std::span<const pbd::SurfaceTriangle> triangles, std::span<const Vec3> rest,
                               size_t pieces, uint32_t worlds) {
  device_.wait();
  const std::vector<float> sizes = sizes_of(triangles, rest, pieces);
  pbd::write_repeated(sizes_, std::span<const float>(sizes), worlds);
  needed_.resize_discard(worlds);
  worlds_ = worlds;
  surface_ = surface;
  vertices_ = surface.triangles.count ? surface.corner_start.count - 1 : 0;
  pieces_ = worlds * static_cast<uint32_t>(pieces);
  active_ = false;
  found_.host()[0] = 0;
}

template <class D>
std::span<const uint32_t> BodyZones<D>::least_substeps_by_world(float dt, const pbd::ParticleView& start) {
  std::ranges::fill(needed_.host(), 0u);
  device_.parallel_for("body zones/approach", surface_.triangles.count,
                       zone_kernels::Approach{shapes_.shapes(), shapes_.touches(start.phase, start.sorted),
                                              surface_.triangles, start, bodies_.motions(), bodies_.reaches(),
                                              bodies_.accelerations(), sizes_.view(), needed_.view(), dt});
  device_.wait();
  return needed_.host();
}

template <class D>
int BodyZones<D>::least_substeps(float dt, int chosen, const pbd::ParticleView& start) {
  if (!may_need_substeps()) return chosen;
  const std::span<const uint32_t> needed = least_substeps_by_world(dt, start);
  const RigidWorlds& rigid = bodies_.worlds();
  uint32_t most = 0;
  for (uint32_t w = 0; w < worlds_; ++w)
    if (rigid.steps(w * rigid.each())) most = std::max(most, needed[w]);
  return in_range(most, chosen);
}

template <class D>
int BodyZones<D>::in_range(uint32_t needed, int chosen) {
  return std::clamp(static_cast<int>(needed), chosen, std::max(chosen, zone_tuning::most_substeps));
}

/// Zones are disabled after many steps without need. A step that needs one after all is repeated.
template <class D>
void BodyZones<D>::save() {
  idle_ = found_.host()[0] ? 0 : idle_ + 1;
  if (idle_ > face_tuning::longest_idle) active_ = false;
}

template <class D>
void BodyZones<D>::reserve_zones() {
  const uint32_t bodies = bodies_.proxies().count;
  for (pbd::Buffer<uint32_t>* buffer : {&label_, &grown_, &anchor_}) buffer->resize_discard(bodies);
  motion_.resize_discard(bodies);
  pose_.resize_discard(bodies);
  turn_.resize_discard(bodies);
  crossings_.resize_discard(worlds_ * zone_tuning::rounds);
  zone_of_.resize_discard(active_ ? vertices_ : 0);
  piece_zone_.resize_discard(active_ ? pieces_ : 0);
  partial_.resize_discard(active_ ? bodies * zone_tuning::lanes : 0);
}

template <class D>
zone_kernels::Zones BodyZones<D>::zones() {
  return {label_.view(),
          grown_.view(),
          anchor_.view(),
          motion_.view(),
          pose_.view(),
          turn_.view(),
          zone_of_.view(),
          piece_zone_.view(),
          crossings_.view(),
          worlds_,
          label_.view().count / worlds_,
          vertices_ / worlds_};
}

template <class D>
void BodyZones<D>::settle(pbd::Substep<D>& substep) {
  using namespace zone_kernels;
  const pbd::View<const BodyProxy> bodies = bodies_.proxies();
  if (!std::exchange(moves_, false) || !may_need_substeps()) return;
  reserve_zones();
  const pbd::ParticleView& p = substep.particles;
  const BodyState state{bodies, bodies_.motions(), bodies_.sum(substep), bodies_.lanes(), substep.dt};
  const Zones all = zones();
  const uint32_t either = std::max({bodies.count, vertices_, pieces_, worlds_ * zone_tuning::rounds});
  device_.parallel_for("body zones/begin", either, Begin{all, state});
  const uint32_t rounds = active_ ? zone_tuning::rounds : 1;
  for (uint32_t round = 0; round < rounds; ++round) {
    const bool last = round + 1 == rounds;
    device_.parallel_for("body zones/find", surface_.triangles.count,
                         FindPassing{all, shapes_.shapes(), shapes_.touches(p.phase, p.sorted),
                                     surface_.triangles, p, bodies, found_.view(), round, last});
    if (!active_) return;
    device_.parallel_for("body zones/anchors", std::max(bodies.count, vertices_), FindAnchors{all, p, round});
    device_.parallel_for("body zones/sum", bodies.count * zone_tuning::lanes,
                         SumZones{all, p, bodies, partial_.view(), zone_tuning::lanes, round});
    device_.parallel_for("body zones/motion", bodies.count,
                         FindMotion{all, p, state, partial_.view(), zone_tuning::lanes, round});
    device_.parallel_for("body zones/move", std::max(bodies.count, vertices_), Move{all, p, bodies, round});
  }
  device_.parallel_for("body zones/give", bodies.count, Give{all, state, bodies_.zone_impulses()});
  device_.parallel_for("body zones/follow", substep.contacts.contacts.count,
                       zone_kernels::Follow{all, bodies, bodies_.contact_motions(), substep.contacts});
}

}  // namespace meniscus::collision
