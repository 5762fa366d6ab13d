// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Turns, shifts and zooms the camera.
#include "sdk/viewer/orbit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace meniscus::viewer {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

Vec3 turned(Vec3 v, Vec3 axis, float angle) {
  const Vec3 half = std::sin(0.5f * angle) * axis;
  return rotate(Quat{half.x, half.y, half.z, std::cos(0.5f * angle)}, v);
}

}  // namespace

Vec3 Orbit::right() const {
  const Vec3 some = std::abs(up_.x) < 0.7f ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
  return normalized_or(cross(forward(), up_), some);
}

float Orbit::half_height() const {
  return std::tan(camera_.field_of_view * pi / 360);
}

void Orbit::turn(float x, float y) {
  constexpr float from_pole = 0.02f;
  const float height = std::acos(std::clamp(-dot(forward(), up_), -1.0f, 1.0f));  // rad, from straight above
  const float down = std::clamp(height - pi * y, from_pole, pi - from_pole) - height;
  Vec3 offset = camera_.position - camera_.target;
  offset = turned(offset, right(), down);
  camera_.position = camera_.target + turned(offset, up_, -pi * x);
}

void Orbit::pan(float x, float y) {
  const float size = 2 * half_height() * length(camera_.target - camera_.position);
  const Vec3 shift = size * (y * cross(right(), forward()) - x * right());
  camera_.position = camera_.position + shift;
  camera_.target = camera_.target + shift;
}

void Orbit::zoom(float notches) {
  const Vec3 offset = camera_.position - camera_.target;
  camera_.position = camera_.target + std::pow(0.875f, notches) * offset;
}

void Orbit::look_at(Vec3 target) {
  camera_.position = camera_.position + (target - camera_.target);
  camera_.target = target;
}

Vec3 Orbit::project(Vec3 point, float aspect) const {
  const Vec3 to = point - camera_.position;
  const float away = dot(to, forward()), high = half_height();
  const float x = dot(to, right()) / (away * aspect * high);
  const float y = dot(to, cross(right(), forward())) / (away * high);
  return {0.5f + 0.5f * x, 0.5f - 0.5f * y, away};
}

Ray Orbit::ray_through(float x, float y, float aspect) const {
  const float across = (2 * x - 1) * aspect * half_height(), high = (1 - 2 * y) * half_height();
  const Vec3 top = cross(right(), forward());
  return {camera_.position, normalized_or(forward() + across * right() + high * top, forward())};
}

}  // namespace meniscus::viewer
