// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Draws the world behind the panels.
#include "sdk/viewer/canvas.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>

namespace meniscus::viewer {

void Canvas::show(const Snapshot& snapshot) {
  if (snapshot.build != build_) {
    io::PreviewScene scene = io::preview_of(*snapshot.scene);
    if (width_ > 0) scene.width = width_;
    if (height_ > 0) scene.height = height_;
    renderer_ = std::make_unique<render::Renderer>(scene, snapshot.moment());
    width_ = scene.width;
    height_ = scene.height;
    scene_ = snapshot.scene;
    if (liquid_) apply_liquid();
    picker_.emplace(*snapshot.scene);
    build_ = snapshot.build;
    home_ = renderer_->camera();
    up_ = normalized_or(-scene.gravity, {0, 1, 0});
    if (!orbit_) orbit_.emplace(home_, up_);
  }
  renderer_->load(snapshot.moment());
  is_painted_ = false;
}

void Canvas::set_liquid(std::optional<Liquid> liquid) {
  if (liquid == liquid_) return;
  liquid_ = liquid;
  if (renderer_) apply_liquid();
}

void Canvas::apply_liquid() {
  auto media = io::preview_of(*scene_).media;
  if (liquid_) std::fill(media.begin(), media.end(), io::medium_of(*liquid_));
  renderer_->set_media(std::move(media));
  is_painted_ = false;
}

void Canvas::see_all() {
  if (renderer_) orbit_.emplace(home_, up_);
  is_painted_ = false;
}

void Canvas::draw(int width, int height, bool moving) {
  if (!renderer_) return;
  const bool is_draft = moving && draft_.share() < 1;
  if (!is_painted_ || (was_draft_ && !moving) || width != width_ || height != height_) {
    width_ = width;
    height_ = height;
    paint(is_draft ? draft_.share() : 1);
    was_draft_ = is_draft;
    is_painted_ = true;
  }
  renderer_->show(width, height);
}

void Canvas::paint(float share) {
  const auto pixels = [&](int all) { return std::max(1, static_cast<int>(share * static_cast<float>(all))); };
  renderer_->set_size(pixels(width_), pixels(height_), share);
  renderer_->set_camera(orbit_->camera());
  const auto start = std::chrono::steady_clock::now();
  renderer_->paint();
  glFinish();
  paint_ms_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  draft_.took(paint_ms_, share);
}

std::optional<Aabb> Canvas::box() const {
  return renderer_ ? std::optional(renderer_->box()) : std::nullopt;
}

io::Image Canvas::image() {
  if (!renderer_ || width_ == 0) throw Error(ErrorCode::invalid_argument, "there is no picture yet");
  if (was_draft_) paint(1);
  was_draft_ = false;
  return renderer_->image();
}

}  // namespace meniscus::viewer
