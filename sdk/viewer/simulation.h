// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "sdk/viewer/grab.h"
#include "sdk/viewer/snapshot.h"

namespace meniscus::viewer {

/// A world on a thread of its own, so that the window answers however long a step takes. All calls return at
/// once; what they lead to shows in the snapshots.
class Simulation {
 public:
  /// `notify` is called, on the other thread, whenever there is something new to see.
  explicit Simulation(std::function<void()> notify);
  ~Simulation();

  /// Builds a scene's world in place of the present one, paused. Where that fails, the present one stays, and
  /// its snapshot says why.
  void open(std::shared_ptr<const Scene> scene);
  /// Takes over what a running world can of a scene that was changed; see World::set_def.
  void change(std::shared_ptr<const Scene> scene);
  void play(bool playing);
  /// One step, and then a pause.
  void step();
  /// While it plays, steps come no faster than in real time, times this; 0: as fast as they can.
  void set_pace(double pace);

  /// What each step pulls at from now on; nothing lets go.
  void hold(std::optional<Grab> grab);

  /// What snapshots are to measure, from now on; see ViewMeter.
  void measure(const render::ViewChoice& choice, const Aabb& box, Vec3 sight);

  /// The last one that is done; null before the first.
  std::shared_ptr<const Snapshot> latest();
  /// A world is being built.
  bool is_building() const;

 private:
  using Clock = std::chrono::steady_clock;
  using Task = std::function<void()>;

  void post(Task task);
  void run();
  bool wait_for_work(std::unique_lock<std::mutex>& lock);
  void build(std::shared_ptr<const Scene> scene);
  void take_over(const Scene& scene);
  void advance();
  void fail(const std::string& why);
  void publish();

  const std::function<void()> notify_;

  mutable std::mutex mutex_;  // guards these
  std::condition_variable changed_;
  std::vector<Task> tasks_;
  std::shared_ptr<const Snapshot> latest_;
  bool is_seen_ = true;  // latest_ has been asked for
  bool stopping_ = false;
  int builds_due_ = 0;

  // Of the other thread alone.
  std::shared_ptr<const Scene> scene_;
  std::optional<BuiltScene> built_;
  float frame_time_ = 0.016f;  // s
  BuildNumber build_ = 0;
  uint64_t steps_ = 0;
  StepReport report_;
  std::optional<Grab> grab_;
  std::optional<Vec3> held_;
  std::string error_;
  render::ViewMeter meter_;
  render::ViewChoice view_;
  Aabb box_{{-1, -1, -1}, {1, 1, 1}};
  Vec3 sight_{0, 0, -1};
  int steps_due_ = 0;  // one by one
  bool playing_ = false, is_published_ = true;
  double pace_ = 1;
  Clock::time_point next_step_{};

  std::thread thread_;  // last: it uses all of the above
};

}  // namespace meniscus::viewer
