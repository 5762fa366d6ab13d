// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/cli/frame_renderer.h"

#include <spdlog/fmt/fmt.h>

#include "sdk/cli/frame_exporter.h"
#include "sdk/render/egl_context.h"
#include "sdk/render/renderer.h"

namespace meniscus::cli {
namespace {

render::Moment moment_of(const World& world, const FrameSample& sample) {
  return {.ellipsoids = world.ellipsoids(),
          .fluids = sample.particles.fluids,
          .bodies = sample.bodies,
          .cloth = sample.cloth,
          .ropes = sample.ropes};
}

}  // namespace

struct FrameRenderer::Parts {
  render::EglContext context;
  render::Renderer renderer;

  Parts(const io::PreviewScene& scene, const render::Moment& first) : renderer(scene, first) {}
};

FrameRenderer::FrameRenderer(std::filesystem::path folder, const io::PreviewScene& scene, const World& world,
                             const FrameSample& first)
    : folder_(std::move(folder)), parts_(std::make_unique<Parts>(scene, moment_of(world, first))) {}

FrameRenderer::~FrameRenderer() = default;

io::Image FrameRenderer::draw(const World& world, const FrameSample& sample) {
  return parts_->renderer.draw(moment_of(world, sample));
}

void FrameRenderer::write(const World& world, const FrameSample& sample) {
  make_folder(folder_ / "frames");
  io::write_png(folder_ / fmt::format("frames/render_{:05}.png", sample.frame), draw(world, sample));
}

}  // namespace meniscus::cli
