// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds the camera, the light and the ground of a scene.
#include "sdk/render/frame/stage.h"

#include <meniscus/error.h>

#include <algorithm>
#include <cmath>

#include "sdk/io/preview/camera.h"

namespace meniscus::render {
namespace {

/// 1, 2 or 5 times a power of ten, near to `size`.
float round_length(float size) {
  const float power = std::pow(10.0f, std::floor(std::log10(size)));
  const float digit = size / power;
  return power * (digit < 1.5f ? 1.0f : digit < 3.5f ? 2.0f : digit < 7.5f ? 5.0f : 10.0f);
}

/// From the left, and slightly from behind the viewer.
Vec3 sun_direction(const SceneCamera& view, Vec3 up) {
  const Vec3 forward = normalized_or(view.target - view.position, {0, 0, -1});
  const Vec3 right = normalized_or(cross(forward, up), {1, 0, 0}), away = cross(up, right);
  return normalized_or(1.15f * up - 0.70f * right - 0.20f * away, up);
}

/// The highest plane that faces up, if there is one.
bool find_ground(const std::vector<ShapeDef>& shapes, Stage& stage) {
  bool found = false;
  for (const ShapeDef& shape : shapes) {
    const auto* plane = std::get_if<PlaneGeometry>(&shape.geometry);
    if (!plane) continue;
    const Vec3 normal = normalized_or(plane->normal, stage.up), world = rotate(shape.pose.rotation, normal);
    if (dot(world, stage.up) < 0.5f) continue;
    const float along = plane->offset / std::max(length(plane->normal), 1e-20f);
    const float offset = dot(world, to_world(shape.pose, along * normal));
    if (found && offset < stage.ground_offset) continue;
    stage.ground_normal = world;
    stage.ground_offset = offset;
    found = true;
  }
  return found;
}

float lowest(const Bounds& b, Vec3 up) {
  float low = 1e30f;
  for (int k = 0; k < 8; ++k) {
    low = std::min(low, dot(up, {k & 1 ? b.upper.x : b.lower.x, k & 2 ? b.upper.y : b.lower.y,
                                 k & 4 ? b.upper.z : b.lower.z}));
  }
  return low;
}

/// The colour is what the path of that name leaves; all black would take in all at once.
void set_by_color(Float4& extinction, Float4& glow, Vec3 color) {
  const auto left = [](float value) { return std::clamp(value, 0.02f, 0.98f); };
  glow = {left(color.x), left(color.y), left(color.z), 0};
  for (int k = 0; k < 3; ++k) extinction[k] = -std::log(glow[k]);
}

/// More than 4 a spacing is as dark, and would not fit the sums of shaders/fluid/thickness.comp.glsl.
void set_by_medium(Float4& extinction, Float4& glow, const io::Medium& medium, const Stage& stage) {
  const Vec3 per_metre = medium.absorption + medium.scattering;
  const auto on_path = [&](float value) { return stage.dye_length * std::min(value, 4 / stage.spacing); };
  extinction = {on_path(per_metre.x), on_path(per_metre.y), on_path(per_metre.z), 0};
  glow = float4(io::reflectance_of(medium));
}

}  // namespace

Stage stage_of(const io::PreviewScene& scene, const Bounds& known) {
  Bounds bounds = known;
  if (bounds.empty()) {
    bounds.add({-1, -1, -1});
    bounds.add({1, 1, 1});
  }
  Stage stage;
  stage.up = normalized_or(-scene.gravity, {0, 1, 0});
  const float aspect = static_cast<float>(scene.width) / static_cast<float>(scene.height);
  stage.camera = scene.camera ? *scene.camera : io::view_of({bounds.lower, bounds.upper}, stage.up, aspect);
  stage.to_sun = sun_direction(stage.camera, stage.up);
  stage.centre = bounds.centre();
  stage.spacing = scene.particle_spacing;
  stage.radius = std::max(bounds.radius(), stage.spacing);
  // A few tiles along the scene, but none so small that distant ones would flicker.
  const float away = length(stage.camera.position - bounds.centre());
  stage.tile = round_length(std::max(max_component(bounds.upper - bounds.lower) / 8, 0.06f * away));
  stage.dye_length = 0.22f * stage.radius;
  stage.ground_normal = stage.up;
  // Slightly below what stands on it, so that the two surfaces do not coincide.
  stage.ground_offset = lowest(bounds, stage.up) - 0.002f * stage.radius;
  find_ground(scene.shapes, stage);
  return stage;
}

FrameUniforms uniforms_of(const Stage& stage, int width, int height) {
  const float w = static_cast<float>(width), h = static_cast<float>(height);
  const View camera = camera_view(stage.camera, stage.up, w / h, stage.centre, stage.radius);
  const float cast = 1.1f * stage.radius;
  const View sun = sun_view(stage.to_sun, stage.centre, cast);
  FrameUniforms u;
  u.view = camera.view;
  u.projection = camera.projection;
  // The inverse of a rotation and a translation.
  const Eigen::Matrix3f back = camera.view.topLeftCorner<3, 3>().transpose();
  u.camera_to_world = Matrix4::Identity();
  u.camera_to_world.topLeftCorner<3, 3>() = back;
  u.camera_to_world.topRightCorner<3, 1>() = -back * camera.view.topRightCorner<3, 1>();
  u.world_to_sun = sun.projection * sun.view;
  const float away = length(stage.camera.position - stage.centre);
  u.eye = float4(stage.camera.position);
  u.to_sun = float4(stage.to_sun, cast);
  u.up = float4(stage.up);
  u.lens = {camera.tan_x, camera.tan_y, camera.near_plane, camera.far_plane};
  u.viewport = {w, h, 1 / w, 1 / h};
  u.ground = float4(stage.ground_normal, stage.ground_offset);
  u.floor = {stage.tile, stage.radius, stage.spacing, std::max(stage.radius, 0.6f * away)};
  u.centre = float4(stage.centre, stage.dye_length);
  return u;
}

FluidUniforms fluid_uniforms_of(const io::PreviewScene& scene) {
  const std::vector<Vec3>& colors = scene.fluid_colors;
  if (colors.size() > most_fluids) {
    throw Error(ErrorCode::invalid_argument, "the scene has " + std::to_string(colors.size()) +
                                                 " fluids and granular materials, but pictures can show " +
                                                 std::to_string(most_fluids) + " at most");
  }
  FluidUniforms u;
  for (std::size_t i = 0; i < most_fluids; ++i) {
    const bool known = i < colors.size();
    u.looks[i] = float4(known ? colors[i] : FluidDef{}.color, known && i >= scene.first_granular);
  }
  return u;
}

MediaUniforms media_uniforms_of(const io::PreviewScene& scene, const Stage& stage) {
  MediaUniforms u;
  for (std::size_t i = 0; i < most_fluids; ++i) {
    const Vec3 color = i < scene.fluid_colors.size() ? scene.fluid_colors[i] : FluidDef{}.color;
    if (i < scene.media.size() && scene.media[i])
      set_by_medium(u.extinctions[i], u.glows[i], *scene.media[i], stage);
    else
      set_by_color(u.extinctions[i], u.glows[i], color);
  }
  return u;
}

}  // namespace meniscus::render
