// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Functions of BodySet; its kernels are in body_kernels.h.
#pragma once

#include <algorithm>
#include <bit>
#include <chrono>

#include "collision/body/body_set.h"
#include "collision/body/held_bodies.inl"
#include "collision/body/over_ranks.inl"

namespace meniscus::collision {

template <class D>
void BodySet<D>::set_shapes(std::span<const CarriedShape> carried, pbd::View<Shape> shapes) {
  if (worlds_.are_many() && kept_forces_.empty()) keep_forces();
  bodies_ = worlds_.body_slots();
  shapes_ = shapes;
  reach_.assign(bodies_, 0);
  for (const CarriedShape& c : carried) {
    const Vec3 far = max(abs(c.bounds.lower), abs(c.bounds.upper)) + abs(c.pose.position);
    reach_[c.body] = std::max(reach_[c.body], length(far));
  }
  std::vector<RigidMass> mass(bodies_);
  for (uint32_t b = 0; b < bodies_; ++b) mass[b] = worlds_.mass(b);
  any_moved_ = std::any_of(mass.begin(), mass.end(), [](const RigidMass& m) { return m.inverse_mass > 0; });
  sums_.assign(bodies_, {});
  mean_forces_.resize(bodies_);

  device_.wait();
  motion_.resize_discard(bodies_);
  arrived_.resize_discard(bodies_);
  impulses_.resize_discard(bodies_);
  mass_.resize_discard(bodies_);
  mass_.write(mass);
  acceleration_.resize_discard(bodies_);
  reaches_.resize_discard(bodies_);
  reaches_.write(reach_);
  proxies_.resize_discard(bodies_);
  carried_.resize_discard(carried.size());
  carried_.write(carried);
  partial_.resize_discard(bodies_ * lanes());
  integer_sums_.resize_discard(device_.fixes_sums() ? bodies_ * lanes() : 0);
  zone_impulses_.resize_discard(bodies_);
  held_.resize_discard(world_.is_on_device() ? bodies_ : 0);
  riding_.resize_discard(held_.size() * lanes());
  on_cloth_.resize_discard(riding_.size());
  contact_motion_.reserve(bodies_, 0);
  place();
}

template <class D>
void BodySet<D>::forget_forces(uint32_t body) {
  if (body < mean_forces_.size()) mean_forces_[body] = {};
}

template <class D>
void BodySet<D>::place() {
  ahead_ = -1;
  if (bodies_ == 0) return;
  device_.wait();
  worlds_.predict(0, arrived_.host());
  rest();
}

/// The number of lanes of a body's sums: enough to fill a GPU with few bodies, and few enough for one thread
/// to sum.
template <class D>
uint32_t BodySet<D>::lanes() const {
  return std::clamp(std::bit_floor(2048u / std::max(1u, bodies_)), 2 * body_kernels::lane_batch, 64u);
}

/// m/s², or more, of the outermost point of a body under this force and torque.
inline float acceleration_by(const RigidImpulse& force, const RigidMass& mass, const Pose& pose,
                             float reach) {
  const Vec3 torque = rotate(conjugate(pose.rotation), force.angular), i = mass.inverse_inertia;
  return mass.inverse_mass * length(force.linear) +
         reach * length(Vec3{i.x * torque.x, i.y * torque.y, i.z * torque.z});
}

template <class D>
float BodySet<D>::speed(float dt) {
  if (bodies_ == 0) return 0;
  predict_motions(dt);
  float fastest = 0;
  for (uint32_t b = 0; b < bodies_; ++b) {
    const RigidMotion& m = motion_.host()[b];
    fastest = std::max(fastest, length(m.velocity) + reach_[b] * length(m.angular_velocity));
    acceleration_.host()[b] = acceleration_by(mean_forces_[b], worlds_.mass(b), m.start, reach_[b]);
  }
  return fastest;
}

/// Predicts the motions of the next dt, unless they are predicted already.
template <class D>
void BodySet<D>::predict_motions(float dt) {
  if (ahead_ != dt) worlds_.predict(dt, motion_.host());
  ahead_ = dt;
}

/// Places the bodies and the shapes that they carry.
template <class D>
template <class Place>
void BodySet<D>::place_bodies(const char* name, const Place& place) {
  device_.parallel_for(name, bodies_ + static_cast<uint32_t>(carried_.size()),
                       body_kernels::WithShapes<Place>{place, carried_.view(), shapes_});
}

template <class D>
void BodySet<D>::predict(float dt) {
  step_time_ += dt;
  if (bodies_ == 0) return;
  if (world_.is_on_device())
    predict_among_solids(dt);
  else
    predict_motions(dt);
  place_bodies("bodies/predict", body_kernels::Predict{motion_.view(), mass_.view(), proxies_.view(), dt});
  if (!world_.is_on_device()) begin_rigid_step(dt);
}

/// This thread alone uses the device.
template <class D>
void BodySet<D>::predict_among_solids(float dt) {
  begun_ = true;
  time_rigid([&] { world_.begin_step(dt); });
  world_.predict_among_solids(dt, motion_.host());
  any_held_ = false;
  for (RigidMotion& m : motion_.host()) {
    m.is_held = m.is_held && !device_.fixes_sums();  // the mass that rides on bodies has no fixed sum
    any_held_ |= m.is_held;
  }
  ahead_ = dt;
}

/// Lets Bullet find contacts while the rest of the substep is launched and computed.
template <class D>
void BodySet<D>::begin_rigid_step(float dt) {
  side_.run([this, dt] {
    begun_ = true;
    time_rigid([&] { worlds_.begin_step(dt); });
  });
}

template <class D>
void BodySet<D>::begin(pbd::Substep<D>& substep) {
  if (bodies_ == 0) return;
  using namespace body_kernels;
  const pbd::ContactView& contacts = substep.contacts;
  const uint32_t room = contacts.contacts.count;
  contact_motion_.current.fill(0);
  zone_impulses_.fill(0);
  for (auto* buffer : {&key_, &sorted_key_, &number_, &grouped_}) buffer->resize_discard(room);
  device_.parallel_for(
      "bodies/keys", room,
      NoteBodies{contacts, substep.particles.position, key_.view(), number_.view(), bodies_});
  device_.sort_pairs("bodies/group", key_.view(), sorted_key_.view(), number_.view(), grouped_.view(),
                     static_cast<uint32_t>(std::bit_width(contact_kinds * bodies_)));
  device_.parallel_for("bodies/groups", room, FindGroups{sorted_key_.view(), proxies_.view()});
  if (substep.ghosts.exchange) count_over_ranks(*substep.ghosts.exchange);
  device_.parallel_for(
      "bodies/split", room,
      Split{grouped_.view(), proxies_.view(), substep.particles.position, contacts, counts_.view()});
  if (any_held_) start_held(substep);
}

template <class D>
void BodySet<D>::sum_contacts(pbd::Substep<D>& substep) {
  using namespace body_kernels;
  if (device_.fixes_sums()) {
    device_.parallel_for("bodies/sum", bodies_ * lanes(),
                         SumLanesInIntegers{grouped_.view(), proxies_.view(), reaches_.view(),
                                            substep.contacts.contacts, integer_sums_.view(), lanes()});
    if (substep.ghosts.exchange) return add_over_ranks(*substep.ghosts.exchange);
    device_.parallel_for(
        "bodies/fold", bodies_,
        FoldLanes{proxies_.view(), reaches_.view(), integer_sums_.view(), partial_.view(), lanes(), lanes()});
    return;
  }
  device_.parallel_for(
      "bodies/sum", bodies_ * lanes(),
      SumLanes{grouped_.view(), proxies_.view(), substep.contacts.contacts, partial_.view(), lanes()});
}

template <class D>
void BodySet<D>::project(pbd::Substep<D>& substep, int iteration) {
  if (!any_moved_) return;
  sum_contacts(substep);
  device_.parallel_for(
      "bodies/follow", substep.contacts.contacts.count,
      body_kernels::Follow{grouped_.view(), proxies_.view(), partial_.view(), contact_motion_.current.view(),
                           contact_motion_.next.view(), substep.contacts, lanes()});
  if (any_held_) move_held(substep, iteration + 1 == substep.iterations);
  contact_motion_.flip();
}

template <class D>
void BodySet<D>::end(pbd::Substep<D>& substep) {
  any_held_ = false;
  if (bodies_ == 0) return;
  sum_contacts(substep);
  device_.parallel_for("bodies/impulse", bodies_,
                       body_kernels::TakeImpulse{partial_.view(), loads_, impulses_.view(), lanes(),
                                                 1 / substep.dt, zone_impulses_.view()});
  device_.set_fence();
}

template <class D>
void BodySet<D>::exchange(pbd::Substep<D>& substep) {
  ahead_ = -1;
  side_.wait();
  // Kernels launched after the impulses, which are the velocity passes, run on while Bullet steps.
  device_.wait_for_fence();
  const std::span<RigidImpulse> impulses = impulses_.host();
  for (uint32_t b = 0; b < bodies_; ++b) {
    RigidImpulse& impulse = impulses[b];
    // A solve with non-finite results is detected and rolled back at the step's end. Bullet need not see it.
    if (!is_finite(impulse.linear) || !is_finite(impulse.angular)) impulse = {};
    sums_[b].linear += impulse.linear;
    sums_[b].angular += impulse.angular;
  }
  finish_rigid_step(substep.dt, substep.is_last);
  const bool is_asked_for_touches = !world_.is_on_device() && !worlds_.are_many();
  if (substep.is_last && is_asked_for_touches) side_.run([this] { world_.touches(); });
  place_bodies("bodies/arrive", body_kernels::Arrive{arrived_.view(), proxies_.view()});
  const pbd::ParticleView& p = substep.particles;
  contacts_.limit_beside_moving({p.previous, p.position, {}, p.phase, p.owned, p.sorted}, substep.contacts,
                                *std::ranges::max_element(furthest_));
}

/// Advances the rigid worlds. Then the motions of the next substep are known as well, if the step has one.
template <class D>
void BodySet<D>::finish_rigid_step(float dt, bool is_last) {
  const bool goes_on = !is_last && !world_.is_on_device();
  const uint32_t each = worlds_.each();
  furthest_.resize(worlds_.count());
  time_rigid([&] {
    worlds_.finish_step(dt, impulses_.host(), arrived_.host(), [&](uint32_t first, uint32_t end) {
      furthest_[first / each] = furthest_motion(first, end);
      if (goes_on) worlds_.predict_world(first / each, dt, motion_.host());
    });
  });
  if (goes_on) ahead_ = dt;
}

template <class D>
template <class F>
void BodySet<D>::time_rigid(const F& step) {
  const auto start = std::chrono::steady_clock::now();
  step();
  step_ms_ += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// m: the path length of the outermost point of these bodies in the present substep, or more.
template <class D>
float BodySet<D>::furthest_motion(uint32_t first, uint32_t end) const {
  float furthest = 0;
  for (uint32_t b = first; b < end; ++b) {
    const Pose& from = motion_.host()[b].start;
    const Pose& to = arrived_.host()[b].start;
    const Quat turn = to.rotation * conjugate(from.rotation);
    const float chord = 2 * length(Vec3{turn.x, turn.y, turn.z});  // of a unit circle
    furthest = std::max(furthest, length(to.position - from.position) + reach_[b] * chord);
  }
  return furthest;
}

/// Places the shapes at the bodies' poses, with no motion.
template <class D>
void BodySet<D>::rest() {
  place_bodies("bodies/rest", body_kernels::Rest{arrived_.view(), proxies_.view()});
}

template <class D>
void BodySet<D>::end_step() {
  if (bodies_ == 0) return world_.set_time(start_time_ + double{step_time_});
  rest();
  device_.send_off();
  side_.wait();
  worlds_.end_step();
  mean_forces_before_ = mean_forces_;
  ended_ = true;
  for (uint32_t b = 0; b < bodies_; ++b)
    if (worlds_.steps(b)) mean_forces_[b] = {sums_[b].linear / step_time_, sums_[b].angular / step_time_};
}

template <class D>
void BodySet<D>::start_step() {
  std::fill(sums_.begin(), sums_.end(), RigidImpulse{});
  step_time_ = 0;
  step_ms_ = 0;
  start_time_ = world_.time();
  begun_ = ended_ = any_held_ = false;
  if (bodies_ == 0) return;
  worlds_.start_step();
  if (world_.is_on_device()) {  // this thread alone uses the device
    worlds_.save_bodies();
    return worlds_.keep_contacts();
  }
  side_.run([this] { worlds_.keep_contacts(); });
  worlds_.save_bodies();
}

template <class D>
void BodySet<D>::keep_forces() {
  kept_forces_ = mean_forces_;
  mean_forces_.clear();
  for (uint32_t w = 0; w < worlds_.count(); ++w)
    mean_forces_.insert(mean_forces_.end(), kept_forces_.begin(), kept_forces_.end());
}

/// Calls back(world), and gives its bodies forces from those that start at from(world).
template <class D>
template <class Back, class From>
void BodySet<D>::take_back(std::span<const uint32_t> chosen, const Back& back, const From& from) {
  if (bodies_ == 0) return;
  const uint32_t each = worlds_.each();
  for (uint32_t w = 0; w < chosen.size(); ++w) {
    if (!chosen[w]) continue;
    back(w);
    std::copy_n(from(w), each, mean_forces_.begin() + w * each);
  }
  place();
}

template <class D>
void BodySet<D>::reset_bodies(std::span<const uint32_t> chosen) {
  take_back(
      chosen, [&](uint32_t w) { worlds_.reset(w); }, [&](uint32_t) { return kept_forces_.begin(); });
}

/// Worlds that did not step are as before.
template <class D>
void BodySet<D>::undo_bodies(std::span<const uint32_t> chosen) {
  const uint32_t each = worlds_.each();
  take_back(
      chosen,
      [&](uint32_t w) {
        if (worlds_.steps(w * each)) worlds_.restore(w);
      },
      [&](uint32_t w) { return mean_forces_before_.begin() + w * each; });
}

template <class D>
void BodySet<D>::undo_step() {
  if (bodies_ == 0) return world_.set_time(start_time_);
  try {
    side_.wait();
  } catch (...) {
    // Whoever undoes a step already knows that it failed.
  }
  if (begun_) worlds_.restore();
  if (ended_) mean_forces_ = mean_forces_before_;
  place();
}

}  // namespace meniscus::collision
