// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Draws frames with OpenGL in a context without a screen.
#include "sdk/cli/output/frame_renderer.h"

#include "sdk/render/egl_context.h"
#include "sdk/render/legend.h"
#include "sdk/render/still.h"

namespace meniscus::cli {
namespace {

render::Moment moment_of(const World& world, const FrameSample& sample) {
  return {.world = &world, .bodies = sample.bodies, .cloth = sample.cloth, .ropes = sample.ropes};
}

render::RenderSettings settings_of(const PictureOptions& options) {
  render::RenderSettings settings;
  settings.anisotropic = options.anisotropic;
  settings.caustics = options.caustics;
  if (options.filter == "bilateral") settings.filter = render::SurfaceFilter::bilateral;
  if (options.filter == "curvature-flow") settings.filter = render::SurfaceFilter::curvature_flow;
  if (options.filter == "none") settings.filter = render::SurfaceFilter::none;
  return settings;
}

}  // namespace

struct FrameRenderer::Parts {
  render::ViewChoice choice;
  render::StillSettings still;
  render::EglContext context;
  render::Renderer renderer;
  render::ViewMeter meter;

  Parts(const io::PreviewScene& scene, const PictureOptions& options, const render::Moment& first)
      : choice(render::view_choice(options.views)),
        still{options.samples, options.aperture, options.shutter},
        renderer(scene, first, settings_of(options)) {}

  io::Image draw(const World& world, render::Moment moment) {
    const SceneCamera& camera = renderer.camera();
    const render::ViewData view =
        meter.measure(world, choice, moment.cloth.strains, renderer.box(), camera.target - camera.position);
    moment.view = &view;
    io::Image image = render::draw_still(renderer, moment, still);
    draw_legend(image, view);
    return image;
  }
};

FrameRenderer::FrameRenderer(const io::PreviewScene& scene, const PictureOptions& options, const World& world,
                             const FrameSample& first)
    : parts_(std::make_unique<Parts>(scene, options, moment_of(world, first))) {}

FrameRenderer::~FrameRenderer() = default;

io::Image FrameRenderer::draw(const World& world, const FrameSample& sample) {
  return parts_->draw(world, moment_of(world, sample));
}

std::vector<std::array<float, 4>> FrameRenderer::fluid_normals() {
  return parts_->renderer.fluid_normals();
}

}  // namespace meniscus::cli
