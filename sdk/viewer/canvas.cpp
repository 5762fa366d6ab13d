// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/viewer/canvas.h"

#include <epoxy/gl.h>

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
    build_ = snapshot.build;
    home_ = renderer_->camera();
    up_ = normalized_or(-scene.gravity, {0, 1, 0});
    if (!orbit_) orbit_.emplace(home_, up_);
  }
  renderer_->load(snapshot.moment());
  is_painted_ = false;
}

void Canvas::see_all() {
  if (renderer_) orbit_.emplace(home_, up_);
  is_painted_ = false;
}

void Canvas::draw(int width, int height) {
  if (!renderer_) return;
  if (width != width_ || height != height_) {
    renderer_->set_size(width, height);
    width_ = width;
    height_ = height;
    is_painted_ = false;
  }
  if (!is_painted_) {
    const auto start = std::chrono::steady_clock::now();
    renderer_->set_camera(orbit_->camera());
    renderer_->paint();
    glFinish();
    paint_ms_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    is_painted_ = true;
  }
  renderer_->show(width, height);
}

io::Image Canvas::image() const {
  if (!renderer_) throw Error(ErrorCode::invalid_argument, "there is no picture yet");
  return renderer_->image();
}

}  // namespace meniscus::viewer
