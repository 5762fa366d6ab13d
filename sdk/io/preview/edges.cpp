// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Clips lines and draws them with antialiasing against the depth of the raster.
#include "sdk/io/preview/edges.h"

#include <algorithm>

namespace meniscus::io {
namespace {

constexpr float near_depth = 1e-3f;  // m

/// Clips a line in view space at the near plane; false if nothing of it remains.
bool clip_to_near(Vec3& a, Vec3& b) {
  if (!(a.z > near_depth || b.z > near_depth)) return false;
  Vec3& behind = a.z < b.z ? a : b;
  if (behind.z < near_depth) {
    behind = a + (near_depth - a.z) / (b.z - a.z) * (b - a);
    behind.z = near_depth;
  }
  return true;
}

/// The visible part of a line, as a range of t in [0, 1], along the axis on which it advances.
void clip_range(float from, float to, float size, float& t_low, float& t_high) {
  const float t0 = (0 - from) / (to - from), t1 = (size - from) / (to - from);
  t_low = std::max(t_low, std::min(t0, t1));
  t_high = std::min(t_high, std::max(t0, t1));
}

class EdgeWalk {
 public:
  EdgeWalk(const EdgePen& pen, const Raster& raster, std::vector<Vec3>& colors)
      : pen_(pen), raster_(raster), colors_(colors) {}

  /// Steps sample by sample along the axis on which the line is longer; both ends are projected.
  void draw(Vec3 a, Vec3 b) {
    steep_ = std::abs(b.y - a.y) > std::abs(b.x - a.x);
    const float from = steep_ ? a.y : a.x, to = steep_ ? b.y : b.x;
    if (from == to) return;
    float t_low = 0, t_high = 1;
    clip_range(from, to, static_cast<float>(steep_ ? camera().height() : camera().width()), t_low, t_high);
    const float span = to - from, slope = (steep_ ? b.x - a.x : b.y - a.y) / span;
    half_ = 0.5f * pen_.thickness * std::sqrt(1 + slope * slope);
    const int count = static_cast<int>(std::ceil(std::max(0.0f, t_high - t_low) * std::abs(span)));
    for (int k = 0; k < count; ++k) {
      const float t = t_low + (static_cast<float>(k) + 0.5f) / std::abs(span);
      const float depth = 1 / ((1 - t) / a.z + t / b.z);
      cross_section(from + t * span, (steep_ ? a.x : a.y) + t * slope * span, depth);
    }
  }

 private:
  const Camera& camera() const { return raster_.camera(); }

  void cross_section(float main, float side, float depth) {
    const int first = static_cast<int>(std::floor(side - half_)),
              last = static_cast<int>(std::floor(side + half_));
    for (int s = first; s <= last; ++s) {
      const float cover =
          std::min(side + half_, static_cast<float>(s + 1)) - std::max(side - half_, static_cast<float>(s));
      blend(steep_ ? s : static_cast<int>(main), steep_ ? static_cast<int>(main) : s, depth, cover);
    }
  }

  void blend(int x, int y, float depth, float cover) {
    if (x < 0 || y < 0 || x >= camera().width() || y >= camera().height()) return;
    const std::size_t sample = raster_.index(x, y);
    if (raster_.depth(sample) < depth - pen_.bias) return;
    colors_[sample] += cover * pen_.opacity * (pen_.color - colors_[sample]);
  }

  const EdgePen& pen_;
  const Raster& raster_;
  std::vector<Vec3>& colors_;
  bool steep_ = false;
  float half_ = 0;
};

}  // namespace

void draw_edge(const Edge& edge, const EdgePen& pen, const Raster& raster, std::vector<Vec3>& colors) {
  Vec3 a = raster.camera().to_view(edge.from), b = raster.camera().to_view(edge.to);
  if (!clip_to_near(a, b)) return;
  EdgeWalk(pen, raster, colors).draw(raster.camera().project(a), raster.camera().project(b));
}

}  // namespace meniscus::io
