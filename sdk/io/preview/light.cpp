// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Renders the shadow map and the ambient obscurance.
#include "sdk/io/preview/light.h"

#include <algorithm>
#include <numbers>

namespace meniscus::io {
namespace {

constexpr int map_size = 1536;

Camera camera_of_lamp(Vec3 towards_lamp, Vec3 center, float radius) {
  constexpr float distance = 12;  // in radii
  SceneCamera view{center + distance * radius * towards_lamp, center, 0};
  view.field_of_view = 2 * std::asin(1 / distance) * 180 / std::numbers::pi_v<float>;
  const Vec3 up = std::abs(towards_lamp.y) < 0.9f ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
  return Camera(view, up, map_size, map_size);
}

Drawing without_grounds(const Drawing& drawing) {
  Drawing casters;
  casters.spheres = drawing.spheres;
  casters.triangles = drawing.triangles;
  return casters;
}

/// A rotation angle per pixel: the same for the same pixel, and without a visible pattern.
float turn_of(int x, int y) {
  const uint32_t mixed = (static_cast<uint32_t>(x) * 73856093u) ^ (static_cast<uint32_t>(y) * 19349663u);
  return static_cast<float>((mixed * 2654435761u) >> 8) / static_cast<float>(1u << 24);
}

class Obscurance {
 public:
  Obscurance(const Raster& raster, int step, float radius)
      : raster_(raster), camera_(raster.camera()), step_(step), radius_(radius) {}

  float openness(int px, int py) const {
    const int x = px * step_, y = py * step_;
    const std::size_t here = raster_.index(x, y);
    if (raster_.surface(here) == Raster::nothing) return 1;
    const float depth = raster_.depth(here);
    const Vec3 point = depth * camera_.view_ray(x, y), normal = raster_.normal(here);
    const float reach =
        std::min(radius_ * camera_.scale() / depth, 0.2f * static_cast<float>(camera_.height()));
    float sum = 0;
    for (int tap = 0; tap < taps; ++tap) {
      const float share = (static_cast<float>(tap) + 0.5f) / taps;
      const float angle = 2 * std::numbers::pi_v<float> * (share * windings + turn_of(px, py));
      sum += blocked(point, normal, x + share * reach * std::cos(angle), y + share * reach * std::sin(angle));
    }
    return std::max(0.0f, 1 - 2.2f * sum / taps);
  }

 private:
  static constexpr int taps = 14, windings = 5;

  float blocked(Vec3 point, Vec3 normal, float column, float row) const {
    const int x = std::clamp(static_cast<int>(column), 0, camera_.width() - 1);
    const int y = std::clamp(static_cast<int>(row), 0, camera_.height() - 1);
    const std::size_t there = raster_.index(x, y);
    if (raster_.surface(there) == Raster::nothing) return 0;
    const Vec3 offset = raster_.depth(there) * camera_.view_ray(x, y) - point;
    const float square = dot(offset, offset) / (radius_ * radius_);
    const float fade = std::max(0.0f, 1 - square);
    return fade * fade * std::max(0.0f, dot(offset, normal) / radius_ - 0.02f) / (square + 0.05f);
  }

  const Raster& raster_;
  const Camera& camera_;
  int step_;
  float radius_;
};

/// Blurs along rows (dx = 1) or columns (dy = 1), but not across jumps of depth.
std::vector<float> blurred(const std::vector<float>& values, const Raster& raster, int step, float radius,
                           int dx, int dy) {
  constexpr int reach = 3;
  const int width = raster.camera().width() / step, height = raster.camera().height() / step;
  std::vector<float> result(values.size());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float depth = raster.depth(raster.index(x * step, y * step));
      float sum = 0, weight = 0;
      for (int k = -reach; k <= reach; ++k) {
        const int u = std::clamp(x + k * dx, 0, width - 1), v = std::clamp(y + k * dy, 0, height - 1);
        const float there = raster.depth(raster.index(u * step, v * step));
        if (k != 0 && !(std::abs(there - depth) < 0.5f * radius)) continue;
        sum += values[static_cast<std::size_t>(v) * width + u];
        ++weight;
      }
      result[static_cast<std::size_t>(y) * width + x] = sum / weight;
    }
  }
  return result;
}

}  // namespace

Lamp::Lamp(const Drawing& drawing, Vec3 towards_lamp, Vec3 center, float radius, float bias)
    : raster_(camera_of_lamp(towards_lamp, center, radius)), bias_(bias) {
  raster_.draw(without_grounds(drawing));
}

float Lamp::visible_from(Vec3 world) const {
  const Camera& camera = raster_.camera();
  const Vec3 view = camera.to_view(world);
  constexpr int reach = 2;
  constexpr float last = map_size - reach;
  if (view.z <= 0) return 1;
  const Vec3 at = camera.project(view);
  if (!(at.x >= reach && at.y >= reach && at.x < last && at.y < last)) return 1;
  const int column = static_cast<int>(at.x), row = static_cast<int>(at.y);
  int open = 0;
  for (int dy = -reach; dy <= reach; dy += 2) {
    for (int dx = -reach; dx <= reach; dx += 2) {
      open += raster_.depth(raster_.index(column + dx, row + dy)) > at.z - bias_;
    }
  }
  return static_cast<float>(open) / 9;
}

std::vector<float> ambient_openness(const Raster& raster, int step, float radius) {
  const int width = raster.camera().width() / step, height = raster.camera().height() / step;
  const Obscurance obscurance(raster, step, radius);
  std::vector<float> open(static_cast<std::size_t>(width) * height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) open[static_cast<std::size_t>(y) * width + x] = obscurance.openness(x, y);
  }
  return blurred(blurred(open, raster, step, radius, 1, 0), raster, step, radius, 0, 1);
}

}  // namespace meniscus::io
