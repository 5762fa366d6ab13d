// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Rasterises spheres, triangles and the ground into samples.
#include "sdk/io/preview/raster.h"

#include <algorithm>
#include <numeric>

namespace meniscus::io {
namespace {

constexpr float near_depth = 1e-3f;  // m

struct Interval {
  float low, high;
};

/// The slopes x/z between which a sphere is seen, those of the two tangents from the eye in the x-z plane.
Interval slopes(float x, float z, float radius) {
  const float k = std::sqrt(std::max(x * x + z * z - radius * radius, 0.0f));
  return {(x * k - z * radius) / (z * k + x * radius), (x * k + z * radius) / (z * k - x * radius)};
}

int clamped(float sample, int size) {
  return static_cast<int>(std::clamp(sample, 0.0f, static_cast<float>(size)));
}

}  // namespace

/// A corner of a triangle, in view space.
struct Raster::Corner {
  Vec3 position, normal;
};

/// The samples from `low` up to, but not including, `high`.
struct Raster::Window {
  int x_low, x_high, y_low, y_high;
};

Raster::Raster(const Camera& camera) : camera_(camera) {
  const std::size_t samples = static_cast<std::size_t>(camera.width()) * camera.height();
  depth_.assign(samples, far_away);
  normal_.assign(samples, Vec3{0, 0, -1});
  surface_.assign(samples, nothing);
}

void Raster::draw(const Drawing& drawing) {
  for (const Triangle& triangle : drawing.triangles) draw(triangle);
  draw_spheres(drawing.spheres);
  for (const Ground& ground : drawing.grounds) draw(ground);
}

void Raster::draw_spheres(const std::vector<Sphere>& spheres) {
  std::vector<Vec3> centers(spheres.size());
  for (std::size_t i = 0; i < spheres.size(); ++i) centers[i] = camera_.to_view(spheres[i].center);
  // Front to back, so that most samples are decided by one comparison of depths.
  std::vector<uint32_t> order(spheres.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](uint32_t a, uint32_t b) { return centers[a].z < centers[b].z; });
  for (const uint32_t i : order) draw(spheres[i], centers[i]);
}

void Raster::draw(const Sphere& sphere, Vec3 c) {
  const float r = sphere.radius;
  if (!(c.z > r + near_depth)) return;  // touches the eye, or is behind it
  if (!(length(c) < 1e15f)) return;     // too far for the squares below
  const Interval x = slopes(c.x, c.z, r), y = slopes(c.y, c.z, r);
  const Window window{
      clamped(camera_.column(x.low), camera_.width()), clamped(camera_.column(x.high) + 1, camera_.width()),
      clamped(camera_.row(y.high), camera_.height()), clamped(camera_.row(y.low) + 1, camera_.height())};
  const float front = c.z - r;
  for (int row = window.y_low; row < window.y_high; ++row) {
    for (int column = window.x_low; column < window.x_high; ++column) {
      const std::size_t sample = index(column, row);
      if (depth_[sample] <= front) continue;
      // From the centre to the nearest point of the ray: accurate also for small and distant spheres.
      const Vec3 ray = camera_.view_ray(column, row);
      const float inverse_square = 1 / dot(ray, ray);
      const float closest = dot(c, ray) * inverse_square;
      const Vec3 offset = closest * ray - c;
      const float inside = r * r - dot(offset, offset);
      if (inside <= 0) continue;
      const float back = std::sqrt(inside * inverse_square);
      put(sample, closest - back, (offset - back * ray) / r, sphere.surface);
    }
  }
}

void Raster::draw(const Triangle& triangle) {
  std::array<Corner, 4> clipped;  // clipped by the near plane: at most one corner more
  int count = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Vec3 a = camera_.to_view(triangle.corners[i]), b = camera_.to_view(triangle.corners[j]);
    const Vec3 na = camera_.direction_to_view(triangle.normals[i]),
               nb = camera_.direction_to_view(triangle.normals[j]);
    if (a.z > near_depth) clipped[count++] = {a, na};
    if ((a.z > near_depth) != (b.z > near_depth)) {
      const float t = (near_depth - a.z) / (b.z - a.z);
      clipped[count++] = {a + t * (b - a), na + t * (nb - na)};
      clipped[count - 1].position.z = near_depth;
    }
  }
  for (int i = 2; i < count; ++i) fill({clipped[0], clipped[i - 1], clipped[i]}, triangle);
}

void Raster::fill(const std::array<Corner, 3>& corners, const Triangle& triangle) {
  const Vec3 a = camera_.project(corners[0].position), b = camera_.project(corners[1].position),
             c = camera_.project(corners[2].position);
  const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  if (!(std::abs(area) > 0)) return;
  const bool behind = area > 0;  // rows run downwards, so counter-clockwise corners have a negative area
  const uint32_t surface = behind && triangle.back ? *triangle.back : triangle.surface;
  const Vec3 low = min(a, min(b, c)), high = max(a, max(b, c));
  const Window window{clamped(low.x, camera_.width()), clamped(high.x + 1, camera_.width()),
                      clamped(low.y, camera_.height()), clamped(high.y + 1, camera_.height())};
  for (int row = window.y_low; row < window.y_high; ++row) {
    for (int column = window.x_low; column < window.x_high; ++column) {
      const float x = static_cast<float>(column) + 0.5f, y = static_cast<float>(row) + 0.5f;
      const float u = ((x - a.x) * (c.y - a.y) - (y - a.y) * (c.x - a.x)) / area;  // the weight of b
      const float v = ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) / area;  // the weight of c
      if (u < 0 || v < 0 || u + v > 1) continue;
      // The inverse of the depth, not the depth, is linear over the picture. So is anything that is divided
      // by the depth.
      const float wa = (1 - u - v) / a.z, wb = u / b.z, wc = v / c.z;
      const float depth = 1 / (wa + wb + wc);
      const Vec3 normal =
          normalized_or(wa * corners[0].normal + wb * corners[1].normal + wc * corners[2].normal, {0, 0, -1});
      const bool turned = triangle.back ? behind : dot(normal, camera_.view_ray(column, row)) > 0;
      put(index(column, row), depth, turned ? -normal : normal, surface);
    }
  }
}

void Raster::draw(const Ground& ground) {
  const Vec3 normal = camera_.direction_to_view(ground.normal);
  const float height = dot(ground.origin - camera_.position(), ground.normal);
  const Vec3 helper = std::abs(ground.normal.x) < 0.7f ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
  const Vec3 across = normalized_or(cross(ground.normal, helper), helper),
             along = cross(across, ground.normal);
  for (int row = 0; row < camera_.height(); ++row) {
    for (int column = 0; column < camera_.width(); ++column) {
      const float depth = height / dot(camera_.view_ray(column, row), normal);
      const std::size_t sample = index(column, row);
      if (!(depth > near_depth && depth < depth_[sample])) continue;
      const Vec3 point = camera_.position() + depth * camera_.world_ray(column, row);
      const float tiles =
          std::floor(dot(point, across) / ground.tile) + std::floor(dot(point, along) / ground.tile);
      put(sample, depth, normal, ground.surface + (std::fmod(tiles, 2.0f) != 0 ? 1 : 0));
    }
  }
}

void Raster::put(std::size_t sample, float depth, Vec3 normal, uint32_t surface) {
  if (depth >= depth_[sample]) return;
  depth_[sample] = depth;
  normal_[sample] = normal;
  surface_[sample] = surface;
}

}  // namespace meniscus::io
