// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Projects points, and places a camera so that a box fills the picture.
#include "sdk/io/preview/camera.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace meniscus::io {
namespace {

Vec3 some_orthogonal(Vec3 unit) {
  const Vec3 axis = std::abs(unit.x) < 0.7f ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
  return normalized_or(axis - dot(axis, unit) * unit, axis);
}

float half_angle_tangent(float degrees) {
  return std::tan(0.5f * degrees * std::numbers::pi_v<float> / 180);
}

/// Moves a camera that looks along `forward` until all corners of the box fill its picture. It moves sideways
/// to centre the corners between opposite borders, and forwards or backwards. Each of the two disturbs the
/// other a little, so it makes a few rounds.
class Framing {
 public:
  Framing(Vec3 half, Vec3 right, Vec3 up, Vec3 forward) : forward_(forward), right_(right), up_(up) {
    for (int i = 0; i < 8; ++i) {
      corners_[i] = {i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z};
    }
  }

  /// The position of the camera relative to the middle of the box.
  Vec3 place(float tan_x, float tan_y) const {
    float distance = 0, x = 0, y = 0;
    for (int round = 0; round < 6; ++round) {
      distance = distance_for(x, y, tan_x, tan_y);
      x += middle(right_, x, distance);
      y += middle(up_, y, distance);
    }
    return x * right_ + y * up_ - distance_for(x, y, tan_x, tan_y) * forward_;
  }

 private:
  float distance_for(float x, float y, float tan_x, float tan_y) const {
    float distance = 0;
    for (const Vec3 p : corners_) {
      const float needed = std::max(std::abs(dot(p, right_) - x) / tan_x, std::abs(dot(p, up_) - y) / tan_y);
      distance = std::max(distance, needed - dot(p, forward_));
    }
    return distance;
  }

  /// Half the sum of the smallest and the largest slope at which corners are seen, times the distance.
  float middle(Vec3 axis, float offset, float distance) const {
    float low = 1e30f, high = -1e30f;
    for (const Vec3 p : corners_) {
      const float slope = (dot(p, axis) - offset) / (distance + dot(p, forward_));
      low = std::min(low, slope);
      high = std::max(high, slope);
    }
    return 0.5f * (low + high) * distance;
  }

  Vec3 forward_, right_, up_;
  std::array<Vec3, 8> corners_;
};

}  // namespace

Camera::Camera(const SceneCamera& view, Vec3 up, int width, int height)
    : width_(width),
      height_(height),
      scale_(0.5f * static_cast<float>(height) / half_angle_tangent(view.field_of_view)),
      position_(view.position),
      forward_(normalized_or(view.target - view.position, {0, 0, -1})) {
  right_ = normalized_or(cross(forward_, up), some_orthogonal(forward_));
  up_ = cross(right_, forward_);
}

Vec3 Camera::to_view(Vec3 world) const {
  return direction_to_view(world - position_);
}

Vec3 Camera::direction_to_view(Vec3 world) const {
  return {dot(world, right_), dot(world, up_), dot(world, forward_)};
}

Vec3 Camera::view_ray(int x, int y) const {
  return {(static_cast<float>(x) + 0.5f - 0.5f * static_cast<float>(width_)) / scale_,
          (0.5f * static_cast<float>(height_) - static_cast<float>(y) - 0.5f) / scale_, 1};
}

Vec3 Camera::world_ray(int x, int y) const {
  const Vec3 ray = view_ray(x, y);
  return ray.x * right_ + ray.y * up_ + forward_;
}

SceneCamera view_of(const Aabb& box, Vec3 up, float aspect) {
  constexpr float turn = 0.50f, lift = 0.42f, margin = 1.10f;  // radians; fraction of the picture
  SceneCamera view;
  const Vec3 half = 0.5f * (box.upper - box.lower);
  // The longer horizontal side of the box lies across the picture.
  Vec3 across = some_orthogonal(up), away = cross(up, across);
  if (dot(half, abs(away)) > dot(half, abs(across))) {
    const Vec3 swapped = across;
    across = away;
    away = -swapped;
  }
  const Vec3 level = std::cos(turn) * away - std::sin(turn) * across;
  const Vec3 forward = std::cos(lift) * level - std::sin(lift) * up;
  const Vec3 right = normalized_or(cross(forward, up), across);
  const float tan_y = half_angle_tangent(view.field_of_view);
  const Vec3 middle = 0.5f * (box.lower + box.upper);
  const Framing framing(half, right, cross(right, forward), forward);
  view.position = middle + framing.place(aspect * tan_y / margin, tan_y / margin);
  view.target = view.position + dot(middle - view.position, forward) * forward;
  return view;
}

}  // namespace meniscus::io
