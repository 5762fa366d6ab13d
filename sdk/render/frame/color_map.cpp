// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Interpolates the colour maps.
#include "sdk/render/frame/color_map.h"

#include <algorithm>
#include <array>

namespace meniscus::render {
namespace {

// Equidistant colours. Lightness grows along the first map, so that it is readable without colours as well.
constexpr std::array sequence{Vec3{0.017f, 0.018f, 0.140f}, Vec3{0.015f, 0.110f, 0.420f},
                              Vec3{0.012f, 0.330f, 0.440f}, Vec3{0.120f, 0.560f, 0.240f},
                              Vec3{0.700f, 0.720f, 0.060f}, Vec3{1.000f, 0.900f, 0.350f}};
constexpr std::array balance{Vec3{0.012f, 0.060f, 0.420f}, Vec3{0.120f, 0.360f, 0.750f},
                             Vec3{0.860f, 0.860f, 0.860f}, Vec3{0.760f, 0.230f, 0.110f},
                             Vec3{0.400f, 0.015f, 0.030f}};

template <std::size_t count>
Vec3 between(const std::array<Vec3, count>& colors, float place) {
  const float at = std::clamp(place, 0.0f, 1.0f) * static_cast<float>(count - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(at), count - 2);
  const float share = at - static_cast<float>(i);
  return (1 - share) * colors[i] + share * colors[i + 1];
}

}  // namespace

Vec3 color_at(ColorMap map, float place) {
  return map == ColorMap::sequence ? between(sequence, place) : between(balance, place);
}

}  // namespace meniscus::render
