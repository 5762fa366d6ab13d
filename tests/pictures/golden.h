// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Pictures that were looked at and found good, one for each pass of the renderer: golden/NAME.png.
#pragma once

#include <cstdlib>

#include "tests/bench/harness/render_bench.h"

namespace meniscus::tests {

/// Expects that the picture looks like golden/NAME.png. Otherwise it is saved, and the message says where.
/// With MENISCUS_RENEW_PICTURES=1 in the environment it becomes golden/NAME.png instead.
void expect_picture(const std::string& name, const io::Image& image);

/// Draws on the CPU, so that no GPU's driver has a say; on a GPU with MENISCUS_PICTURES_ON_GPU=1 in the
/// environment.
class GoldenTest : public RenderTest {
 protected:
  GoldenTest() : RenderTest(devices()) {}

  static render::EglDevices devices() {
    const char* on_gpu = std::getenv("MENISCUS_PICTURES_ON_GPU");
    return on_gpu && *on_gpu == '1' ? render::EglDevices::all : render::EglDevices::software;
  }

  /// Above a ground at y = 0.
  static io::PreviewScene on_ground(Vec3 eye, Vec3 target, float field_of_view = 35) {
    io::PreviewScene scene = small_scene();
    scene.shapes = {shape(PlaneGeometry{})};
    scene.camera = SceneCamera{eye, target, field_of_view};
    return scene;
  }

  void expect_drawn(const std::string& name, const io::PreviewScene& scene,
                    const render::Moment& moment = {}) const {
    expect_picture(name, draw(scene, moment));
  }
};

}  // namespace meniscus::tests
