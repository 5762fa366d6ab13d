// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A camera that the mouse turns about a target.
#pragma once

#include <meniscus/scene.h>
#include "pbd/math/vec.h"

namespace meniscus::viewer {

/// A ray; `direction` has unit length.
struct Ray {
  Vec3 from{0, 0, 0}, direction{0, 0, -1};
};

/// A camera that the mouse turns about its target. Mouse motion is in fractions of the window's height, x to
/// the right and y down. Places are in [0, 1]² from the upper left corner.
class Orbit {
 public:
  Orbit(const SceneCamera& start, Vec3 up) : camera_(start), up_(up) {}

  const SceneCamera& camera() const { return camera_; }

  /// Turns by half a turn per window height; it stops short of the poles.
  void turn(float x, float y);
  /// Shifts the view: points at the target's distance follow the mouse.
  void pan(float x, float y);
  /// Moves nearer by an eighth per notch of the wheel.
  void zoom(float notches);
  /// Looks at this point from the present direction and distance.
  void look_at(Vec3 target);

  Ray ray_through(float x, float y, float aspect) const;
  /// The place at which a point is seen: x and y as above. z is its distance along the line of sight, m,
  /// negative behind the eye.
  Vec3 project(Vec3 point, float aspect) const;
  Vec3 forward() const { return normalized_or(camera_.target - camera_.position, {0, 0, -1}); }

 private:
  Vec3 right() const;
  float half_height() const;  // half height of the picture at distance 1

  SceneCamera camera_;
  Vec3 up_;
};

}  // namespace meniscus::viewer
