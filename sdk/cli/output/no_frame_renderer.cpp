// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Replaces frame_renderer.cpp in builds without the renderer.
#include "sdk/cli/output/frame_renderer.h"

namespace meniscus::cli {
namespace {

[[noreturn]] void fail() {
  throw Error(ErrorCode::device,
              "cannot render: this program was built without the renderer, as " MENISCUS_NO_RENDER_REASON);
}

}  // namespace

struct FrameRenderer::Parts {};

FrameRenderer::FrameRenderer(const io::PreviewScene&, const PictureOptions&, const World&,
                             const FrameSample&) {
  fail();
}
FrameRenderer::~FrameRenderer() = default;
io::Image FrameRenderer::draw(const World&, const FrameSample&) {
  fail();
}
std::vector<std::array<float, 4>> FrameRenderer::fluid_normals() {
  fail();
}

}  // namespace meniscus::cli
