// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Functions of FacePoints; its kernels are in face_points_kernels.h and face_points_ccd_failsafe.h.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "collision/body/face_points.h"
#include "collision/body/face_points_ccd_failsafe.h"
#include "collision/body/tuning.h"

namespace meniscus::collision {

template <class D>
void FacePoints<D>::set_surface(const pbd::SurfaceView& surface, uint32_t worlds) {
  device_.wait();
  worlds_ = worlds;
  surface_ = surface;
  vertices_ = surface.triangles.count ? surface.corner_start.count - 1 : 0;
  wanted_.host()[0] = 0;
  set_room(surface.triangles.count ? room_ : 0);
}

template <class D>
void FacePoints<D>::set_room(uint32_t points) {
  const bool active = std::exchange(active_, false) && points > 0;
  room_ = 0;
  const uint32_t faces = points ? surface_.triangles.count : 0;
  needed_.resize_discard(faces);
  number_.resize_discard(points ? faces + 1 : 0);
  weights_.resize_discard(faces);
  triangle_of_.resize_discard(points);
  pushed_.resize_discard(points);
  demand_.resize_discard(points);
  at_vertex_.resize_discard(points ? vertices_ : 0);
  room_ = points;  // last: if an allocation throws, there is no room
  active_ = active;
}

/// Points are disabled after many steps without need. A step that needs some after all is repeated, with the
/// same result as if they had been enabled.
template <class D>
void FacePoints<D>::save() {
  idle_ = wanted() == 0 ? idle_ + 1 : 0;
  if (idle_ > face_tuning::longest_idle) active_ = false;
}

template <class D>
void FacePoints<D>::visit_state(pbd::StateVisitor& v) {
  uint32_t room = room_;
  bool active = active_;
  v.value("room", room);
  v.value("active", active);
  v.value("idle", idle_);
  v.values("wanted", wanted_.host());
  if (!v.restores()) return;
  if (room > room_) set_room(room);
  active_ = active;
}

template <class D>
void FacePoints<D>::make_room() {
  active_ = true;
  idle_ = 0;
  if (wanted() > room_) set_room(std::max(256u, wanted() + wanted() / 2));
}

template <class D>
face_kernels::Points FacePoints<D>::points(const pbd::Substep<D>& substep) const {
  return {surface_.triangles,
          needed_.view(),
          number_.view(),
          weights_.view(),
          triangle_of_.view(),
          surface_.corner_start,
          surface_.corners,
          substep.particles.owned - room_,
          room_,
          surface_.triangles.count / worlds_,
          vertices_ / worlds_};
}

template <class D>
void FacePoints<D>::arrange(pbd::Substep<D>& substep) {
  using namespace face_kernels;
  if (!may_need_points() || !active_) return;
  decide(substep, needed_.view());
  device_.exclusive_scan("faces/number", needed_.view(), number_.view());
  device_.parallel_for("faces/list", surface_.triangles.count,
                       ListPoints{needed_.view(), number_.view(), triangle_of_.view(), wanted_.view()});
  substep.particles.owned += room_;
  device_.parallel_for("faces/particles", room_,
                       MakeParticles{points(substep), triangle_of_.view(), substep.particles,
                                     particles_.previous.view(), particles_.phase.current.view(),
                                     particles_.slot.current.view(), particles_.number.current.view()});
  shapes_.set_points({surface_.triangles, triangle_of_.view(), substep.particles.owned - room_});
}

/// While points are disabled, the host learns at the step's end whether any were needed.
template <class D>
void FacePoints<D>::prepare(pbd::Substep<D>& substep) {
  if (prepares()) decide(substep, {});
}

template <class D>
bool FacePoints<D>::may_need_points() const {
  return surface_.triangles.count > 0 && shapes_.any_but_fixed_planes();
}

template <class D>
void FacePoints<D>::decide(const pbd::Substep<D>& substep, pbd::View<uint32_t> needed) {
  device_.parallel_for(
      "faces/decide", surface_.triangles.count,
      face_kernels::Decide{shapes_.shapes(),
                           shapes_.touches(substep.particles.phase, substep.particles.sorted),
                           surface_.triangles, substep.particles, needed, weights_.view(), wanted_.view()});
}

template <class D>
void FacePoints<D>::begin(pbd::Substep<D>& substep) {
  using namespace face_kernels;
  contacts_.begin(substep);
  if (!any(substep)) return;
  device_.parallel_for("faces/count", vertices_,
                       CountAtVertices{points(substep), substep.contacts.start, at_vertex_.view(),
                                       particles_.phase.current.view(), substep.particles.sorted});
}

template <class D>
void FacePoints<D>::project(pbd::Substep<D>& substep, int iteration) {
  using namespace face_kernels;
  if (!any(substep)) return contacts_.project(substep, iteration);
  device_.parallel_for("faces/place", room_,
                       Place{points(substep), substep.particles, substep.contacts, pushed_.view()});
  device_.parallel_for("faces/weigh", room_,
                       Weigh{points(substep), substep.particles, substep.contacts, pushed_.view()});
  contacts_.project(substep, iteration);
  device_.parallel_for("faces/transfer", vertices_,
                       TransferDisplacement{points(substep), substep.particles, at_vertex_.view()});
}

template <class D>
void FacePoints<D>::settle(pbd::Substep<D>& substep) {
  using namespace face_kernels;
  if (!any(substep)) return;
  const Points all = points(substep);
  const pbd::ParticleView& p = substep.particles;
  for (int k = 0; k < face_tuning::rounds; ++k) {
    device_.parallel_for(
        "faces/demand", room_,
        Demand{all, p, substep.contacts, shapes_.shapes(), shapes_.touches(p.phase, p.sorted),
               bodies_.proxies(), bodies_.contact_motions(), k ? pushed_.view() : pbd::View<uint32_t>{},
               demand_.view()});
    device_.parallel_for("faces/account", room_,
                         Account{all, p, substep.contacts, demand_.view(), pushed_.view()});
    device_.parallel_for("faces/obey", vertices_, Obey{all, p, at_vertex_.view(), demand_.view()});
  }
}

template <class D>
void FacePoints<D>::end(pbd::Substep<D>& substep) {
  using namespace face_kernels;
  if (!any(substep)) return contacts_.end(substep);
  const Points all = points(substep);
  const pbd::ParticleView& p = substep.particles;
  // Masses are computed again, because vertices have their own masses back.
  device_.parallel_for("faces/velocities", room_,
                       PlaceVelocities{all, p, substep.contacts, pushed_.view(), demand_.view()});
  device_.parallel_for("faces/weigh", room_, Weigh{all, p, substep.contacts, pushed_.view()});
  contacts_.end(substep);
  device_.parallel_for(
      "faces/transfer velocities", vertices_,
      TransferVelocities{all, p, at_vertex_.view(), demand_.view(), withstanding(substep), substep.dt});
}

}  // namespace meniscus::collision
