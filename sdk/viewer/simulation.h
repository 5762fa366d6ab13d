// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The simulation of a world on its own thread.
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

/// A world on its own thread, so that the window responds however long a step takes. All calls return at
/// once; their effects appear in the snapshots.
class Simulation {
 public:
  /// `notify` is called on the other thread whenever there is a new snapshot.
  explicit Simulation(std::function<void()> notify);
  ~Simulation();

  /// Builds a scene's world in place of the present one, paused. If that fails, the present one stays, and
  /// its snapshot gives the reason.
  void open(std::shared_ptr<const Scene> scene);
  /// Applies the changes of a scene that a running world can take; see World::set_def.
  void change(std::shared_ptr<const Scene> scene);
  void play(bool playing);
  /// Makes one step, and then pauses.
  void step();
  /// While it plays, steps come no faster than this factor of real time; 0: as fast as possible.
  void set_pace(double pace);

  /// Sets what each later step pulls; an empty grab releases it.
  void hold(std::optional<Grab> grab);

  /// Sets what later snapshots measure; see ViewMeter.
  void measure(const render::ViewChoice& choice, const Aabb& box, Vec3 sight);

  /// The last complete snapshot; null before the first.
  std::shared_ptr<const Snapshot> latest();
  /// Whether a world is being built.
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

  mutable std::mutex mutex_;  // protects the members below
  std::condition_variable changed_;
  std::vector<Task> tasks_;
  std::shared_ptr<const Snapshot> latest_;
  bool is_seen_ = true;  // whether latest_ has been read
  bool stopping_ = false;
  int builds_due_ = 0;

  // Members that only the other thread uses.
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
  int steps_due_ = 0;  // single steps requested
  bool playing_ = false, is_published_ = true;
  double pace_ = 1;
  Clock::time_point next_step_{};

  std::thread thread_;  // last, because it uses all members above
};

}  // namespace meniscus::viewer
