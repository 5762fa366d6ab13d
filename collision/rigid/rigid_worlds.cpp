// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Functions of RigidWorlds.
#include "collision/rigid/rigid_worlds.h"

#include <meniscus/error.h>

#include <algorithm>
#include <utility>

namespace meniscus::collision {

RigidWorlds::RigidWorlds(RigidWorld& only)
    : only_(only), before_(RigidWorld::make_snapshot()), start_(RigidWorld::make_snapshot()) {}

void RigidWorlds::make_many(uint32_t worlds, std::unique_ptr<pbd::HostThreads> threads,
                            const std::function<std::unique_ptr<RigidWorld>()>& make) {
  only_.save(*start_);
  std::vector<std::unique_ptr<RigidWorld>> made(worlds);
  std::vector<RigidWorld::SnapshotPtr> before(worlds);
  for (auto& snapshot : before) snapshot = RigidWorld::make_snapshot();
  threads->for_each(worlds, [&](uint32_t w) {
    made[w] = make();
    made[w]->restore(*start_);
  });
  steps_.assign(worlds, 1);
  failed_.assign(worlds, 0);
  threads_ = std::move(threads);
  many_ = std::move(made);
  many_before_ = std::move(before);
}

void RigidWorlds::set_stepping(std::span<const uint8_t> steps) {
  if (are_many()) std::copy(steps.begin(), steps.end(), steps_.begin());
}

/// Calls work(w, world) for the worlds that step.
template <class Work>
void RigidWorlds::for_each(const Work& work) const {
  if (!are_many()) return work(0u, only_);
  threads_->for_each(count(), [&](uint32_t w) {
    if (takes_part(w)) work(w, *many_[w]);
  });
}

/// The others rest.
void RigidWorlds::predict(float dt, std::span<RigidMotion> out) const {
  if (!are_many()) return only_.predict(dt, out);
  threads_->for_each(count(), [&](uint32_t w) {
    many_[w]->predict(takes_part(w) ? dt : 0, out.subspan(size_t{w} * each(), each()));
  });
}

void RigidWorlds::begin_step(float dt) {
  for_each([&](uint32_t, RigidWorld& world) { world.begin_step(dt); });
}

void RigidWorlds::finish_step(float dt, std::span<const RigidImpulse> impulses) {
  for_each([&](uint32_t w, RigidWorld& world) {
    world.finish_step(dt, impulses.subspan(size_t{w} * each(), each()));
  });
}

void RigidWorlds::check_finite() {
  if (!are_many()) return only_.check_finite();
  for_each([&](uint32_t w, const RigidWorld&) { fail_unless_finite(w); });
}

void RigidWorlds::fail_unless_finite(uint32_t w) {
  try {
    many_[w]->check_finite();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::non_finite) throw;
    restore(w);
    failed_[w] = 1;
  }
}

void RigidWorlds::end_step() {
  for_each([](uint32_t, RigidWorld& world) { world.end_step(); });
}

void RigidWorlds::save_bodies() {
  for_each(
      [&](uint32_t w, RigidWorld& world) { world.save_bodies(are_many() ? *many_before_[w] : *before_); });
}

void RigidWorlds::keep_contacts() {
  for_each(
      [&](uint32_t w, RigidWorld& world) { world.keep_contacts(are_many() ? *many_before_[w] : *before_); });
}

void RigidWorlds::restore() {
  for_each([&](uint32_t w, RigidWorld&) { restore(w); });
}

void RigidWorlds::restore(uint32_t w) {
  world(w).restore(are_many() ? *many_before_[w] : *before_);
}

void RigidWorlds::reset(uint32_t w) {
  many_[w]->restore(*start_);
}

}  // namespace meniscus::collision
