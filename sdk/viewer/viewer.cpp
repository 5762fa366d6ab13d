// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/viewer/viewer.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <chrono>

#include "sdk/viewer/canvas.h"
#include "sdk/viewer/keys.h"
#include "sdk/viewer/mouse.h"
#include "sdk/viewer/panels.h"
#include "sdk/viewer/simulation.h"
#include "sdk/viewer/window.h"

namespace meniscus::viewer {
namespace {

class Viewer {
 public:
  explicit Viewer(const ViewerOptions& options)
      : options_(options),
        window_("Meniscus", options.width, options.height, options.check_opengl),
        name_(options.name) {
    open(options.scene);
  }

  void run() {
    for (int frames = 0; !window_.should_close();) {
      window_.wait(frames > 0 ? 0.0 : 0.25);
      // ImGui needs a few frames to settle after what happened.
      if (window_.touched()) frames = 3;
      if (take_news()) frames = std::max(frames, 2);
      if (frames > 0) --frames;
      for (const int key : window_.keys()) press(key, controls_, window_, shown_ && shown_->playing);
      if (window_.size().width > 0 && window_.size().height > 0) draw();
      obey();
    }
  }

  ViewerEnd end() {
    if (const auto last = simulation_.latest(); last && last->build) shown_ = last;
    return {.steps = shown_ ? shown_->steps : 0,
            .time = shown_ ? shown_->time : 0,
            .screenshots = screenshots_,
            .mistakes = window_.mistakes()};
  }

 private:
  void open(const Scene& scene) {
    controls_.scene = scene;
    controls_.scene_needs_reset = false;
    simulation_.open(std::make_shared<const Scene>(scene));
  }

  /// Whether there are any.
  bool take_news() {
    const bool was_building = std::exchange(is_building_, simulation_.is_building());
    std::shared_ptr<const Snapshot> latest = simulation_.latest();
    if (latest == shown_) return was_building != is_building_;
    if (!shown_ || latest->build != shown_->build || latest->steps < shown_->steps) history_.clear();
    if (shown_ && latest->steps > shown_->steps) history_.add(latest->step);
    shown_ = std::move(latest);
    if (!shown_->build) return true;
    window_.set_title(
        fmt::format("{}: {:.3f} s, {} steps - Meniscus", shown_->scene->name, shown_->time, shown_->steps));
    canvas_.show(*shown_);
    return true;
  }

  void draw() {
    window_.begin();
    mouse_.act(canvas_);
    if (controls_.panels && shown_) {
      draw_panels(controls_, {.snapshot = *shown_,
                              .history = history_,
                              .scenes = options_.scenes,
                              .scene = name_,
                              .is_building = is_building_,
                              .paint_ms = canvas_.paint_ms(),
                              .notice = notice_});
    }
    const Window::Size size = window_.size();
    canvas_.draw(size.width, size.height);
    window_.draw_panels();
    window_.end();
  }

  /// Does what keys and panels have asked for.
  void obey() {
    if (controls_.open) open_named(*controls_.open);
    if (controls_.reset) open(controls_.scene);
    if (controls_.play) simulation_.play(*controls_.play);
    if (controls_.step) simulation_.step();
    if (controls_.frame_all) canvas_.see_all();
    if (controls_.screenshot) take_screenshot();
    if (pace_ != controls_.pace) simulation_.set_pace(pace_ = controls_.pace);
    controls_.clear_requests();
  }

  void open_named(const std::string& name) {
    try {
      open(options_.load(name));
      name_ = name;
      notice_.clear();
      canvas_.forget_camera();
    } catch (const std::exception& error) {
      notice_ = error.what();
    }
  }

  void take_screenshot() {
    try {
      std::filesystem::create_directories(options_.folder);
      const auto file = options_.folder / fmt::format("view_{:05}.png", screenshots_ + 1);
      io::write_png(file, canvas_.image());
      ++screenshots_;
      notice_ = "Wrote " + file.string();
    } catch (const std::exception& error) {
      notice_ = error.what();
    }
  }

  const ViewerOptions& options_;
  Window window_;
  Simulation simulation_{Window::wake};
  Controls controls_;
  std::string name_, notice_;
  double pace_ = 1;
  bool is_building_ = false;
  std::shared_ptr<const Snapshot> shown_;
  StageHistory history_;
  Canvas canvas_;
  Mouse mouse_;
  int screenshots_ = 0;
};

}  // namespace

ViewerEnd run_viewer(const ViewerOptions& options) {
  Viewer viewer(options);
  viewer.run();
  return viewer.end();
}

}  // namespace meniscus::viewer
