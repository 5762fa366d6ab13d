// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The depth buffer of the preview, with normals and surfaces.
#pragma once

#include <limits>

#include "sdk/io/preview/camera.h"
#include "sdk/io/preview/drawing.h"

namespace meniscus::io {

/// The depth, normal and surface of the first hit at each sample.
class Raster {
 public:
  static constexpr uint32_t nothing = 0xffffffff;
  static constexpr float far_away = std::numeric_limits<float>::infinity();

  explicit Raster(const Camera& camera);

  void draw(const Drawing& drawing);

  const Camera& camera() const { return camera_; }
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * camera_.width() + x; }
  float depth(std::size_t sample) const { return depth_[sample]; }
  Vec3 normal(std::size_t sample) const { return normal_[sample]; }  ///< in view space, towards the camera
  uint32_t surface(std::size_t sample) const { return surface_[sample]; }

 private:
  struct Corner;
  struct Window;

  void draw_spheres(const std::vector<Sphere>& spheres);
  void draw(const Sphere& sphere, Vec3 view_center);
  void draw(const Triangle& triangle);
  void draw(const Ground& ground);
  void fill(const std::array<Corner, 3>& corners, const Triangle& triangle);
  void put(std::size_t sample, float depth, Vec3 normal, uint32_t surface);

  Camera camera_;
  std::vector<float> depth_;
  std::vector<Vec3> normal_;
  std::vector<uint32_t> surface_;
};

}  // namespace meniscus::io
