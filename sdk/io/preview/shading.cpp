// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Shades the samples of a raster and averages them into pixels.
#include "sdk/io/preview/shading.h"

#include <algorithm>

#include "sdk/io/preview/edges.h"
#include "sdk/io/preview/light.h"

namespace meniscus::io {
namespace {

constexpr Vec3 lamp_color{1.02f, 0.97f, 0.89f}, sky_color{0.29f, 0.34f, 0.42f},
    floor_color{0.14f, 0.13f, 0.13f};
constexpr Vec3 backdrop_top{0.17f, 0.24f, 0.33f}, backdrop_bottom{0.58f, 0.62f, 0.65f};

Vec3 times(Vec3 a, Vec3 b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
Vec3 mix(Vec3 a, Vec3 b, float t) {
  return a + t * (b - a);
}

/// Keeps dark and middle tones, and compresses brighter ones towards white.
float tone(float x) {
  return x < 0.5f ? x : 1 - 0.25f / x;
}

uint8_t to_srgb(float linear) {
  const float c = std::clamp(linear, 0.0f, 1.0f);
  const float s = c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f;
  return static_cast<uint8_t>(255 * s + 0.5f);
}

class Shader {
 public:
  Shader(const Raster& raster, const Drawing& drawing, const Studio& studio, int step)
      : raster_(raster),
        camera_(raster.camera()),
        drawing_(drawing),
        studio_(studio),
        step_(step),
        lamp_(drawing, studio.towards_lamp, studio.center, studio.radius, studio.grain),
        open_(ambient_openness(raster, step, std::max(4 * studio.grain, 0.06f * studio.radius))),
        view_up_(camera_.direction_to_view(studio.up)),
        view_lamp_(camera_.direction_to_view(studio.towards_lamp)) {}

  Vec3 color(int x, int y) const {
    const std::size_t sample = raster_.index(x, y);
    if (raster_.surface(sample) == Raster::nothing) return backdrop(y);
    const Vec3 world = camera_.position() + raster_.depth(sample) * camera_.world_ray(x, y);
    return mix(lit(x, y, world), backdrop(y), haze(world));
  }

 private:
  Vec3 backdrop(int y) const {
    const float t = static_cast<float>(y) / static_cast<float>(camera_.height());
    return mix(backdrop_top, backdrop_bottom, t * t * (3 - 2 * t));
  }

  /// An infinite ground fades into the background away from the scene.
  float haze(Vec3 world) const {
    const float distance = std::max(0.0f, length(world - studio_.center) / studio_.radius - 1.3f);
    return 1 - std::exp(-0.20f * distance * distance);
  }

  float openness(int x, int y) const {
    return open_[static_cast<std::size_t>(y / step_) * (camera_.width() / step_) + x / step_];
  }

  Vec3 lit(int x, int y, Vec3 world) const {
    const std::size_t sample = raster_.index(x, y);
    const Surface& surface = drawing_.surfaces[raster_.surface(sample)];
    const Vec3 normal = raster_.normal(sample), eye = normalized_or(-camera_.view_ray(x, y), {0, 0, -1});
    const float facing = dot(normal, view_lamp_);
    const float lamp = facing > 0 ? lamp_.visible_from(world) : 0;
    const float open = openness(x, y);
    const Vec3 ambient = open * mix(floor_color, sky_color, 0.5f + 0.5f * dot(normal, view_up_));
    const Vec3 diffuse = times(surface.albedo, ambient + lamp * std::max(facing, 0.0f) * lamp_color);
    const float shine = std::pow(std::max(0.0f, dot(normal, normalized_or(view_lamp_ + eye, normal))), 48.0f);
    const float grazing = std::pow(1 - std::clamp(dot(normal, eye), 0.0f, 1.0f), 4.0f);
    return diffuse + surface.gloss * (0.45f * lamp * shine * lamp_color + 0.30f * open * grazing * sky_color);
  }

  const Raster& raster_;
  const Camera& camera_;
  const Drawing& drawing_;
  const Studio& studio_;
  int step_;
  Lamp lamp_;
  std::vector<float> open_;
  Vec3 view_up_, view_lamp_;
};

Image averaged(const std::vector<Vec3>& colors, int width, int height, int step) {
  Image image{width / step, height / step, {}};
  image.rgb.reserve(static_cast<std::size_t>(3) * image.width * image.height);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      Vec3 sum{0, 0, 0};
      for (int k = 0; k < step * step; ++k) {
        sum += colors[static_cast<std::size_t>(y * step + k / step) * width + x * step + k % step];
      }
      sum = sum / static_cast<float>(step * step);
      image.rgb.insert(image.rgb.end(), {to_srgb(sum.x), to_srgb(sum.y), to_srgb(sum.z)});
    }
  }
  return image;
}

}  // namespace

Image shade(const Raster& raster, const Drawing& drawing, const Studio& studio, int step) {
  const int width = raster.camera().width(), height = raster.camera().height();
  const Shader shader(raster, drawing, studio, step);
  std::vector<Vec3> colors(static_cast<std::size_t>(width) * height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Vec3 c = shader.color(x, y);
      colors[raster.index(x, y)] = {tone(c.x), tone(c.y), tone(c.z)};
    }
  }
  // The same thickness at every picture size, and never hidden by a particle that rests against its own
  // container.
  const EdgePen pen{{0.06f, 0.09f, 0.13f}, 0.75f, 0.0021f * static_cast<float>(height), studio.grain};
  for (const Edge& edge : drawing.edges) draw_edge(edge, pen, raster, colors);
  return averaged(colors, width, height, step);
}

}  // namespace meniscus::io
