// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Runs the simulation thread, and publishes its snapshots.
#include "sdk/viewer/simulation.h"

#include "pbd/device/start_thread.h"

namespace meniscus::viewer {

Simulation::Simulation(std::function<void()> notify)
    : notify_(std::move(notify)),
      thread_(pbd::start_thread("the thread of the simulation", [this] { run(); })) {}

Simulation::~Simulation() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void Simulation::post(Task task) {
  {
    const std::lock_guard lock(mutex_);
    tasks_.push_back(std::move(task));
  }
  changed_.notify_one();
}

void Simulation::open(std::shared_ptr<const Scene> scene) {
  {
    const std::lock_guard lock(mutex_);
    ++builds_due_;
  }
  post([this, scene = std::move(scene)] { build(scene); });
}

void Simulation::change(std::shared_ptr<const Scene> scene) {
  post([this, scene = std::move(scene)] {
    try {
      if (built_) take_over(*scene);
      error_.clear();
      is_published_ = false;
    } catch (const std::exception& error) {
      fail(error.what());
    }
  });
}

void Simulation::play(bool playing) {
  post([this, playing] {
    playing_ = playing && built_;
    steps_due_ = 0;
    next_step_ = Clock::now();
    error_.clear();
    is_published_ = false;
  });
}

void Simulation::step() {
  post([this] {
    playing_ = false;
    if (built_) ++steps_due_;
    error_.clear();
  });
}

void Simulation::set_pace(double pace) {
  post([this, pace] { pace_ = pace; });
}

void Simulation::hold(std::optional<Grab> grab) {
  post([this, grab = std::move(grab)] {
    grab_ = grab;
    if (!grab_) held_.reset();
    is_published_ = false;
  });
}

void Simulation::measure(const render::ViewChoice& choice, const Aabb& box, Vec3 sight) {
  post([=, this] {
    view_ = choice;
    box_ = box;
    sight_ = sight;
    is_published_ = false;
  });
}

std::shared_ptr<const Snapshot> Simulation::latest() {
  std::shared_ptr<const Snapshot> snapshot;
  {
    const std::lock_guard lock(mutex_);
    is_seen_ = true;
    snapshot = latest_;
  }
  changed_.notify_one();
  return snapshot;
}

bool Simulation::is_building() const {
  const std::lock_guard lock(mutex_);
  return builds_due_ > 0;
}

// ---- the other thread ----

void Simulation::run() {
  std::unique_lock lock(mutex_);
  while (wait_for_work(lock)) {
    const std::vector<Task> tasks = std::exchange(tasks_, {});
    const bool is_awaited = is_seen_;
    lock.unlock();
    for (const Task& task : tasks) task();
    // Before the next step, which may take long.
    if (!is_published_ && is_awaited) publish();
    if (steps_due_ > 0 || (playing_ && Clock::now() >= next_step_)) advance();
    lock.lock();
  }
}

/// Returns false when the thread is to end.
bool Simulation::wait_for_work(std::unique_lock<std::mutex>& lock) {
  const auto has_work = [&] {
    return stopping_ || !tasks_.empty() || steps_due_ > 0 || (!is_published_ && is_seen_);
  };
  if (playing_)
    changed_.wait_until(lock, next_step_, has_work);
  else
    changed_.wait(lock, has_work);
  return !stopping_;
}

void Simulation::build(std::shared_ptr<const Scene> scene) {
  try {
    BuiltScene built = build_scene(*scene);
    built_.reset();
    built_.emplace(std::move(built));
    scene_ = std::move(scene);
    frame_time_ = scene_->frame_time;
    grab_.reset();
    held_.reset();
    meter_ = {};
    ++build_;
    steps_ = 0;
    report_ = {};
    error_.clear();
    is_published_ = false;
  } catch (const std::exception& error) {
    fail(error.what());
  }
  playing_ = false;
  const std::lock_guard lock(mutex_);
  --builds_due_;
}

void Simulation::take_over(const Scene& scene) {
  World& world = built_->world;
  WorldDef def = scene.world;
  def.device = world.def().device;
  def.threads = world.def().threads;
  def.origin = world.def().origin;
  def.particle_spacing = world.def().particle_spacing;
  def.support_ratio = world.def().support_ratio;
  def.contact_radius = world.def().contact_radius;
  def.kernel = world.def().kernel;
  def.diffuse = world.def().diffuse;
  def.periodic = world.def().periodic;
  world.set_def(def);
  for (std::size_t i = 0; i < scene_->fluids.size(); ++i) {
    FluidDef fluid = scene.fluids.at(i);
    fluid.rest_density = scene_->fluids[i].rest_density;
    fluid.filter = scene_->fluids[i].filter;
    world.set_fluid(built_->fluids[i], fluid);
  }
  world.set_wind(scene.wind.value_or(WindDef{}));
  frame_time_ = scene.frame_time;
}

void Simulation::advance() {
  const auto frame = std::chrono::duration<double>(pace_ > 0 ? frame_time_ / pace_ : 0.0);
  // A late step does not catch up later.
  next_step_ = std::max(next_step_ + std::chrono::duration_cast<Clock::duration>(frame), Clock::now());
  if (steps_due_ > 0) --steps_due_;
  try {
    if (grab_) held_ = pull(*grab_, *built_, *scene_, frame_time_);
    report_ = built_->world.step(frame_time_);
    ++steps_;
    is_published_ = false;
  } catch (const std::exception& error) {
    fail(error.what());
  }
}

void Simulation::fail(const std::string& why) {
  error_ = why;
  playing_ = false;
  steps_due_ = 0;
  is_published_ = false;
}

void Simulation::publish() {
  is_published_ = true;
  auto snapshot = std::make_shared<Snapshot>();
  try {
    if (built_) {
      *snapshot = snapshot_of(*built_, *scene_);
      snapshot->view = meter_.measure(built_->world, view_, snapshot->cloth.strains, box_, sight_);
    }
  } catch (const std::exception& error) {
    error_ = error.what();
    playing_ = false;
  }
  snapshot->build = build_;
  snapshot->scene = scene_;
  snapshot->steps = steps_;
  snapshot->step = report_;
  snapshot->playing = playing_;
  snapshot->error = error_;
  snapshot->held = held_;
  {
    const std::lock_guard lock(mutex_);
    latest_ = std::move(snapshot);
    is_seen_ = false;
  }
  notify_();
}

}  // namespace meniscus::viewer
