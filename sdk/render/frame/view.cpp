// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Computes view and projection matrices.
#include "sdk/render/frame/view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace meniscus::render {
namespace {

Vec3 some_orthogonal(Vec3 unit) {
  const Vec3 axis = std::abs(unit.x) < 0.7f ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
  return normalized_or(axis - dot(axis, unit) * unit, axis);
}

}  // namespace

Matrix4 look_at(Vec3 position, Vec3 target, Vec3 up) {
  const Vec3 back = normalized_or(position - target, {0, 0, 1});
  const Vec3 right = normalized_or(cross(up, back), some_orthogonal(back)), top = cross(back, right);
  Matrix4 m;
  m << right.x, right.y, right.z, -dot(right, position),  //
      top.x, top.y, top.z, -dot(top, position),           //
      back.x, back.y, back.z, -dot(back, position),       //
      0, 0, 0, 1;
  return m;
}

View camera_view(const SceneCamera& camera, Vec3 up, float aspect, Vec3 centre, float radius) {
  View v;
  v.view = look_at(camera.position, camera.target, up);
  v.tan_y = std::tan(camera.field_of_view * std::numbers::pi_v<float> / 360);
  v.tan_x = aspect * v.tan_y;
  const float distance = length(centre - camera.position);
  v.near_plane = std::max(0.1f * (distance - radius), 0.005f * radius);
  v.far_plane = distance + 40 * radius;  // the ground goes on beyond the scene
  const float n = v.near_plane, f = v.far_plane;
  v.projection << 1 / v.tan_x, 0, 0, 0,  //
      0, 1 / v.tan_y, 0, 0,              //
      0, 0, -(f + n) / (f - n), -2 * f * n / (f - n), 0, 0, -1, 0;
  return v;
}

View sun_view(Vec3 to_sun, Vec3 centre, float radius) {
  View v;
  v.view = look_at(centre + (2 * radius) * to_sun, centre, {0, 1, 0});
  v.near_plane = radius;
  v.far_plane = 3 * radius;
  const float s = 1 / radius, n = v.near_plane, f = v.far_plane;
  v.projection << s, 0, 0, 0,  //
      0, s, 0, 0,              //
      0, 0, -2 / (f - n), -(f + n) / (f - n), 0, 0, 0, 1;
  return v;
}

Matrix4 matrix_of(const Pose& pose) {
  const Vec3 x = rotate(pose.rotation, {1, 0, 0}), y = rotate(pose.rotation, {0, 1, 0}),
             z = rotate(pose.rotation, {0, 0, 1}), p = pose.position;
  Matrix4 m;
  m << x.x, y.x, z.x, p.x,  //
      x.y, y.y, z.y, p.y,   //
      x.z, y.z, z.z, p.z,   //
      0, 0, 0, 1;
  return m;
}

}  // namespace meniscus::render
