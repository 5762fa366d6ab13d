// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Draws the legend with rectangles and stb_easy_font.
#include "sdk/render/legend.h"

#include <spdlog/fmt/fmt.h>
#include <stb/stb_easy_font.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace meniscus::render {
namespace {

using Rgb = std::array<uint8_t, 3>;

struct Rectangle {
  int left, top, width, height;  // pixels
};

Rgb shown(Vec3 linear) {
  const auto srgb = [](float x) { return static_cast<uint8_t>(std::lround(255 * std::pow(x, 1 / 2.2f))); };
  return {srgb(linear.x), srgb(linear.y), srgb(linear.z)};
}

/// `cover`: the opacity, 0 to 1.
void fill(io::Image& image, const Rectangle& r, Rgb color, float cover = 1) {
  for (int y = std::max(r.top, 0); y < std::min(r.top + r.height, image.height); ++y) {
    for (int x = std::max(r.left, 0); x < std::min(r.left + r.width, image.width); ++x) {
      uint8_t* pixel = &image.rgb[std::size_t{3} * (std::size_t{1} * y * image.width + x)];
      for (int k = 0; k < 3; ++k)
        pixel[k] = static_cast<uint8_t>(cover * static_cast<float>(color[k]) +
                                        (1 - cover) * static_cast<float>(pixel[k]));
    }
  }
}

/// Writes in letters of stb_easy_font; each of its pixels is `size` wide.
void write(io::Image& image, int left, int top, int size, std::string text) {
  struct Corner {
    float x, y, z;
    uint8_t color[4];
  };
  std::vector<Corner> corners(text.size() * 128);
  const int count = stb_easy_font_print(0, 0, text.data(), nullptr, corners.data(),
                                        static_cast<int>(corners.size() * sizeof(Corner)));
  for (int quad = 0; quad < count; ++quad) {
    const Corner &a = corners[std::size_t{4} * quad], &c = corners[std::size_t{4} * quad + 2];
    const auto scaled = [&](float from, float to) { return size * static_cast<int>(to - from); };
    fill(image, {left + scaled(0, a.x), top + scaled(0, a.y), scaled(a.x, c.x), scaled(a.y, c.y)},
         {245, 245, 245});
  }
}

}  // namespace

std::vector<LegendEntry> legend_of(const ViewData& view) {
  std::vector<LegendEntry> entries;
  if (view.choice.particles == ParticleView::speed) entries.push_back({"speed", view.particles});
  if (view.choice.particles == ParticleView::density_error)
    entries.push_back({"density error", view.particles});
  if (view.choice.particles == ParticleView::pressure) entries.push_back({"pressure", view.particles});
  if (view.choice.strain) entries.push_back({"strain of cloth", view.strain});
  if (view.choice.distances) entries.push_back({"distance to solids", view.distances});
  return entries;
}

void draw_legend(io::Image& image, const ViewData& view) {
  const int size = std::max(1, image.height / 360), line = 12 * size, width = 180 * size;
  const std::vector<LegendEntry> entries = legend_of(view);
  int top = image.height - static_cast<int>(entries.size()) * (5 * line / 2) - line;
  for (const LegendEntry& entry : entries) {
    const int left = line;
    std::string text =
        fmt::format("{}: {:g} to {:g} {}", entry.name, entry.scale.low, entry.scale.high, entry.scale.unit);
    const int wide = std::max(width, size * stb_easy_font_width(text.data()));
    fill(image, {left - line / 2, top - line / 4, wide + line, 5 * line / 2}, {18, 20, 24}, 0.7f);
    for (int x = 0; x < width; ++x) {
      const float place = (static_cast<float>(x) + 0.5f) / static_cast<float>(width);
      fill(image, {left + x, top, 1, line}, shown(color_at(entry.scale.map, place)));
    }
    write(image, left, top + line + line / 4, size, text);
    top += 5 * line / 2;
  }
}

}  // namespace meniscus::render
