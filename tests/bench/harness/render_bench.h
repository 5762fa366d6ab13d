// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Small scenes for the renderer, and measurements of pictures for tests.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "sdk/render/egl_context.h"
#include "sdk/render/renderer.h"
#include "tests/worlds.h"

namespace meniscus::tests {

struct Pixel {
  int r, g, b;
};

inline Pixel at(const io::Image& image, int x, int y) {
  const std::size_t k = std::size_t{3} * (std::size_t{1} * y * image.width + x);
  return {image.rgb[k], image.rgb[k + 1], image.rgb[k + 2]};
}

inline int sum(Pixel p) {
  return p.r + p.g + p.b;
}

inline int difference(Pixel a, Pixel b) {
  return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
}

/// A test that needs OpenGL, and is skipped where there is none.
class RenderTest : public testing::Test {
 protected:
  explicit RenderTest(render::EglDevices devices = render::EglDevices::all) : devices_(devices) {}

  void SetUp() override {
    try {
      context_ = std::make_unique<render::EglContext>(devices_);
    } catch (const Error& error) {
      GTEST_SKIP() << error.what();
    }
  }

  /// 160 × 120 pixels, seen along −z from 3 m away.
  static io::PreviewScene small_scene(float spacing = 0.05f) {
    io::PreviewScene scene;
    scene.particle_spacing = spacing;
    scene.width = 160;
    scene.height = 120;
    scene.camera = SceneCamera{{0, 0, 3}, {0, 0, 0}, 35};
    return scene;
  }

  io::Image draw(const io::PreviewScene& scene, const render::Moment& moment = {}) const {
    return render::Renderer(scene, moment).draw(moment);
  }

 private:
  render::EglDevices devices_;
  std::unique_ptr<render::EglContext> context_;
};

/// Particles that have not moved, and what World makes of them.
class Water {
 public:
  explicit Water(std::span<const Vec3> points, float spacing = 0.05f)
      : world_(world_def(pbd::DeviceKind::cpu, spacing)) {
    world_.add_particles(world_.create_fluid({}), points);
  }

  render::Moment moment() const {
    return {.ellipsoids = world_.ellipsoids(), .fluids = world_.fluids(), .positions = world_.positions()};
  }

 private:
  World world_;
};

/// Of the lattice with this spacing, as disordered as water that has come to rest, what lies within a half
/// extent and is wanted.
template <class Wanted>
std::vector<Vec3> points_where(float spacing, Vec3 half, const Wanted& wanted) {
  std::mt19937 random(7);
  const auto count = [&](float extent) { return static_cast<int>(2 * extent / spacing + 0.5f); };
  std::vector<Vec3> points;
  for (Vec3 p : lattice(count(half.x), count(half.y), count(half.z), spacing, -half)) {
    if (wanted(p)) points.push_back(p + random_vector(random, 0.08f * spacing));
  }
  return points;
}

}  // namespace meniscus::tests
