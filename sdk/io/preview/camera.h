// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The pinhole camera of the preview.
#pragma once

#include <meniscus/scene.h>
#include "pbd/math/vec.h"

namespace meniscus::io {

/// A pinhole camera over a raster of samples. View space has x to the right, y up and z forward, so z is the
/// depth.
class Camera {
 public:
  /// `up` need not be orthogonal to the line of sight.
  Camera(const SceneCamera& view, Vec3 up, int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  Vec3 position() const { return position_; }
  float scale() const { return scale_; }  ///< samples per unit length at depth 1

  Vec3 to_view(Vec3 world) const;
  Vec3 direction_to_view(Vec3 world) const;
  /// Column (x) and row (y) of a point in view space, in samples; z is its depth, which must be positive.
  Vec3 project(Vec3 view) const { return {column(view.x / view.z), row(view.y / view.z), view.z}; }
  float column(float x_over_z) const { return 0.5f * static_cast<float>(width_) + scale_ * x_over_z; }
  float row(float y_over_z) const { return 0.5f * static_cast<float>(height_) - scale_ * y_over_z; }
  /// The ray through the centre of a sample, in view space, with depth 1.
  Vec3 view_ray(int x, int y) const;
  /// The same in world space.
  Vec3 world_ray(int x, int y) const;

 private:
  int width_, height_;
  float scale_;
  Vec3 position_, right_, up_, forward_;
};

/// A three-quarter view from above that contains the whole box.
SceneCamera view_of(const Aabb& box, Vec3 up, float aspect);

}  // namespace meniscus::io
