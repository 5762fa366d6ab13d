// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The main loop of the viewer.
#include "sdk/viewer/viewer.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <chrono>

#include "sdk/scene/scene_file.h"
#include "sdk/viewer/canvas.h"
#include "sdk/viewer/keys.h"
#include "sdk/viewer/mouse.h"
#include "sdk/viewer/movie.h"
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
        source_(options.scene) {
    controls_.parameters.open(source_.document);
    build();
  }

  void run() {
    for (int frames = 0; !window_.should_close();) {
      window_.wait(frames > 0 ? 0.0 : 0.1);
      // ImGui needs a few frames to settle after an event.
      if (window_.touched()) frames = 3;
      if (take_news()) frames = std::max(frames, 2);
      if (frames > 0) --frames;
      for (const int key : window_.keys()) press(key, controls_, window_, shown_ && shown_->playing);
      if (window_.size().width > 0 && window_.size().height > 0) draw();
      obey();
    }
  }

  ViewerEnd end() {
    attempt([&] { end_movie(); });
    if (const auto last = simulation_.latest(); last && last->build) shown_ = last;
    return {.steps = shown_ ? shown_->steps : 0,
            .time = shown_ ? shown_->time : 0,
            .screenshots = screenshots_,
            .videos = videos_,
            .grabs = mouse_.grabs(),
            .mistakes = window_.mistakes()};
  }

 private:
  /// The scene with the user's changes.
  std::shared_ptr<const Scene> edited_scene() const {
    return std::make_shared<const Scene>(scene_of_document(controls_.parameters.document(), source_.path));
  }

  void build() {
    simulation_.open(edited_scene());
    controls_.parameters.was_reset();
    notice_.clear();
  }

  /// Takes a new snapshot; returns whether there is one.
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
    if (shown_) mouse_.act(canvas_, *shown_, simulation_);
    if (controls_.panels && shown_) {
      draw_panels(controls_, {.snapshot = *shown_,
                              .history = history_,
                              .scenes = options_.scenes,
                              .scene = source_.name,
                              .is_building = is_building_,
                              .paint_ms = canvas_.paint_ms(),
                              .notice = notice_});
    }
    const Window::Size size = window_.size();
    canvas_.draw(size.width, size.height, is_moving());
    attempt_movie();
    window_.draw_panels();
    window_.end();
  }

  /// Whether the world plays, or the camera has moved a moment ago.
  bool is_moving() {
    const auto now = std::chrono::steady_clock::now();
    if (mouse_.has_steered()) last_motion_ = now;
    return (shown_ && shown_->playing) || now - last_motion_ < std::chrono::milliseconds(300);
  }

  /// Executes what keys and panels have requested.
  void obey() {
    if (controls_.open) attempt([&] { open_named(*controls_.open); });
    if (controls_.reset) attempt([&] { build(); });
    if (controls_.parameters_changed) attempt([&] { simulation_.change(edited_scene()); });
    if (controls_.play) simulation_.play(*controls_.play);
    if (controls_.step) simulation_.step();
    if (controls_.frame_all) canvas_.see_all();
    if (controls_.screenshot) attempt([&] { take_screenshot(); });
    choose_view();
    canvas_.set_liquid(controls_.liquid);
    if (pace_ != controls_.pace) simulation_.set_pace(pace_ = controls_.pace);
    controls_.clear_requests();
  }

  /// Runs an action; the panel shows its error if it fails.
  template <class Action>
  void attempt(const Action& action) {
    try {
      action();
    } catch (const std::exception& error) {
      notice_ = error.what();
    }
  }

  void choose_view() {
    const std::optional<Aabb> box = canvas_.box();
    if (!box || (controls_.view == view_ && view_build_ == shown_->build)) return;
    view_ = controls_.view;
    view_build_ = shown_->build;
    simulation_.measure(view_, *box, canvas_.orbit()->forward());
  }

  void open_named(const std::string& name) {
    SceneSource source = options_.load(name);
    std::swap(source_, source);
    controls_.parameters.open(source_.document);
    canvas_.forget_camera();
    build();
  }

  /// Starts, continues or ends the video that the controls ask for. An error ends it.
  void attempt_movie() {
    if (!shown_ || !shown_->build || !controls_.movie) return attempt([&] { end_movie(); });
    try {
      if (!movie_) start_movie();
      // A reset, or another scene.
      if (shown_->build != movie_build_ || shown_->steps < movie_steps_)
        throw Error(ErrorCode::invalid_argument, "the scene starts anew, which ends the video");
      if (shown_->steps > movie_steps_) movie_->add(canvas_.image(), movie_steps_ = shown_->steps);
    } catch (const std::exception& error) {
      controls_.movie = false;
      attempt([&] { end_movie(); });
      notice_ = error.what();
    }
  }

  void start_movie() {
    std::filesystem::create_directories(options_.folder);
    const auto file = options_.folder / fmt::format("view_{:05}.mp4", videos_ + 1);
    movie_build_ = shown_->build;
    movie_steps_ = shown_->steps;
    movie_.emplace(file, canvas_.image(), double{shown_->scene->frame_time}, movie_steps_);
    notice_ = "Recording " + file.string();
  }

  void end_movie() {
    if (!movie_) return;
    const std::string file = movie_->path().string();
    try {
      movie_->end();
    } catch (...) {
      movie_.reset();
      throw;
    }
    movie_.reset();
    ++videos_;
    notice_ = "Wrote " + file;
  }

  void take_screenshot() {
    std::filesystem::create_directories(options_.folder);
    const auto file = options_.folder / fmt::format("view_{:05}.png", screenshots_ + 1);
    io::write_png(file, canvas_.image());
    ++screenshots_;
    notice_ = "Wrote " + file.string();
  }

  const ViewerOptions& options_;
  Window window_;
  Simulation simulation_{Window::wake};
  Controls controls_;
  SceneSource source_;
  std::string notice_;
  double pace_ = 1;
  render::ViewChoice view_;     // the view that the simulation measures
  BuildNumber view_build_ = 0;  // build for which it was chosen
  bool is_building_ = false;
  std::shared_ptr<const Snapshot> shown_;
  StageHistory history_;
  Canvas canvas_;
  Mouse mouse_;
  std::chrono::steady_clock::time_point last_motion_{};
  int screenshots_ = 0, videos_ = 0;
  std::optional<Movie> movie_;
  BuildNumber movie_build_ = 0;  // of what it shows
  uint64_t movie_steps_ = 0;     // that it has
};

}  // namespace

ViewerEnd run_viewer(const ViewerOptions& options) {
  Viewer viewer(options);
  viewer.run();
  return viewer.end();
}

}  // namespace meniscus::viewer
