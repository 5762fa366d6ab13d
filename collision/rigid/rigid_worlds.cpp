// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Functions of RigidWorlds.
#include "collision/rigid/rigid_worlds.h"

#include <meniscus/error.h>

#include <algorithm>
#include <utility>

namespace meniscus::collision {

void RigidNews::note(RigidWorld& world) {
  std::vector<RigidTouch> now = world.touches();
  world.read_awake(awake_before);  // the last that may fail
  awake_before.swap(awake);
  touches_before.swap(touches);
  touches.swap(now);
  is_new = true;
}

void RigidNews::take_back() {
  if (!std::exchange(is_new, false)) return;
  touches = touches_before;
  awake = awake_before;
}

void RigidNews::settle() {
  touches_before = touches;
  awake_before = awake;
  is_new = false;
}

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
  news_.assign(worlds, kept_news_);
  threads_ = std::move(threads);
  many_ = std::move(made);
  many_before_ = std::move(before);
}

void RigidWorlds::set_stepping(std::span<const uint8_t> steps) {
  if (are_many()) std::copy(steps.begin(), steps.end(), steps_.begin());
  failed_.assign(failed_.size(), 0);
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
  threads_->for_each(count(), [&](uint32_t w) { predict_world(w, dt, out); });
}

void RigidWorlds::predict_world(uint32_t w, float dt, std::span<RigidMotion> out) const {
  const bool rests = are_many() && !takes_part(w);
  world(w).predict(rests ? 0 : dt, out.subspan(size_t{w} * each(), each()));
}

void RigidWorlds::begin_step(float dt) {
  for_each([&](uint32_t, RigidWorld& world) { world.begin_step(dt); });
}

void RigidWorlds::finish_step(float dt, std::span<const RigidImpulse> impulses,
                              std::span<RigidMotion> arrived,
                              const std::function<void(uint32_t, uint32_t)>& note) {
  if (!are_many()) {
    only_.finish_step(dt, impulses);
    only_.check_finite();
    only_.predict(0, arrived);
    return note(0, each());
  }
  threads_->for_each(count(), [&](uint32_t w) {
    const uint32_t first = w * each();
    if (takes_part(w)) {
      many_[w]->finish_step(dt, impulses.subspan(first, each()));
      fail_unless_finite(w);
    }
    predict_world(w, 0, arrived);
    note(first, first + each());
  });
}

void RigidWorlds::fail_unless_finite(uint32_t w) {
  try {
    many_[w]->check_finite();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::non_finite) throw;
    restore(w);
    news_[w].settle();
    failed_[w] = 1;
  }
}

void RigidWorlds::start_step() {
  failed_.assign(failed_.size(), 0);
  for (RigidNews& news : news_) news.is_new = false;
}

void RigidWorlds::end_step() {
  for_each([&](uint32_t w, RigidWorld& world) {
    world.end_step();
    if (are_many()) news_[w].note(world);
  });
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
  if (are_many()) news_[w].take_back();
}

void RigidWorlds::keep_news(std::span<const RigidTouch> touches, std::span<const uint8_t> awake) {
  kept_news_.touches.assign(touches.begin(), touches.end());
  kept_news_.awake.assign(awake.begin(), awake.end());
  kept_news_.settle();
}

void RigidWorlds::renew(uint32_t w) {
  news_[w].touches = many_[w]->touches();
  many_[w]->read_awake(news_[w].awake);
  news_[w].settle();
}

void RigidWorlds::reset(uint32_t w) {
  many_[w]->restore(*start_);
  news_[w] = kept_news_;
}

}  // namespace meniscus::collision
