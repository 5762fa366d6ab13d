// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The rigid worlds behind the bodies of a solver: one, or one for each world of a batch.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "collision/rigid/rigid_world.h"
#include "pbd/device/cpu/host_threads.h"

namespace meniscus::collision {

/// What touches in a world of a batch, and which bodies are awake, after its last step and before it.
struct RigidNews {
  std::vector<RigidTouch> touches, touches_before;
  std::vector<uint8_t> awake, awake_before;  ///< by body
  bool is_new = false;                       ///< noted in the present step

  /// Changes nothing if it fails.
  void note(RigidWorld& world);
  void take_back();
  /// Nothing has changed since.
  void settle();
};

/// Steps one rigid world, or as many as a batch has. The worlds of a batch are alike, and bodies are numbered
/// world after world. Each world steps alone, on any of several threads, so the others do not change it.
class RigidWorlds {
 public:
  explicit RigidWorlds(RigidWorld& only);

  /// From now on there are `worlds`, each made by make() in the state of the one world. Changes nothing if it
  /// throws.
  void make_many(uint32_t worlds, std::unique_ptr<pbd::HostThreads> threads,
                 const std::function<std::unique_ptr<RigidWorld>()>& make);
  bool are_many() const { return !many_.empty(); }
  uint32_t count() const { return are_many() ? static_cast<uint32_t>(many_.size()) : 1; }
  RigidWorld& world(uint32_t w) const { return are_many() ? *many_[w] : only_; }
  bool any_failed() const { return std::find(failed_.begin(), failed_.end(), 1) != failed_.end(); }
  /// Bodies of a world.
  uint32_t each() const { return world(0).body_slots(); }
  /// By world of a batch: whether the next steps advance it. The others stay. No world has failed yet.
  void set_stepping(std::span<const uint8_t> steps);
  bool steps(uint32_t body) const { return !are_many() || takes_part(body / each()); }
  /// By world of a batch: whether a body was not finite in this step. Such a world is back at the step's
  /// start, and stays there.
  std::span<const uint8_t> failed() const { return failed_; }
  /// Of a world of a batch.
  const RigidNews& news(uint32_t world) const { return news_[world]; }
  const std::vector<RigidNews>& all_news() const { return news_; }
  void set_all_news(std::vector<RigidNews> news) noexcept { news_ = std::move(news); }
  /// The news that make_many() and reset() start with, of a world alone.
  void keep_news(std::span<const RigidTouch> touches, std::span<const uint8_t> awake);
  /// Starts with what a world has now, after its state was replaced.
  void renew(uint32_t world);

  // As those of RigidWorld, for all worlds that step.
  uint32_t body_slots() const { return count() * each(); }
  RigidMass mass(uint32_t body) const { return world(body / each()).mass(body % each()); }
  void predict(float dt, std::span<RigidMotion> out) const;
  void start_step();
  void begin_step(float dt);
  /// Finishes the step of each world, checks it, and writes where its bodies arrive. One world throws if a
  /// body is not finite; a world of a batch fails. Then calls note(first, end) for its bodies. For worlds of
  /// a batch all that is on one of the threads.
  void finish_step(float dt, std::span<const RigidImpulse> impulses, std::span<RigidMotion> arrived,
                   const std::function<void(uint32_t, uint32_t)>& note);
  /// For one world, as predict().
  void predict_world(uint32_t world, float dt, std::span<RigidMotion> out) const;
  void end_step();

  /// Keeps the state at the start of a step, in two halves that may run at once.
  void save_bodies();
  void keep_contacts();
  /// Gives that state back to all worlds that step.
  void restore();
  void restore(uint32_t world);
  /// Gives a world of a batch the state of make_many().
  void reset(uint32_t world);

 private:
  bool takes_part(uint32_t w) const { return steps_[w] && !failed_[w]; }
  template <class Work>
  void for_each(const Work& work) const;
  void fail_unless_finite(uint32_t w);

  RigidWorld& only_;
  RigidWorld::SnapshotPtr before_, start_;  // of the one world
  std::vector<std::unique_ptr<RigidWorld>> many_;
  std::vector<RigidWorld::SnapshotPtr> many_before_;
  std::vector<uint8_t> steps_, failed_;  // by world of a batch
  std::vector<RigidNews> news_;          // likewise
  RigidNews kept_news_;
  std::unique_ptr<pbd::HostThreads> threads_;
};

}  // namespace meniscus::collision
