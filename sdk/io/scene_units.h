// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The up axis and the frame rate of a scene, as files of whole scenes state them.
#pragma once

#include <cmath>

#include <meniscus/scene.h>

namespace meniscus::io {

/// Files know two up axes. Another gravity than along −z leaves y.
inline char up_axis(Vec3 gravity) {
  return -gravity.z > std::abs(gravity.x) && -gravity.z > std::abs(gravity.y) ? 'Z' : 'Y';
}

/// Frames a second. A frame time in a file has few digits, so what is a whole number but for these is one.
inline double rate_of(float frame_time) {
  const double rate = 1 / double{frame_time}, whole = std::round(rate);
  return std::abs(rate - whole) < 2e-6 * rate ? whole : rate;
}

}  // namespace meniscus::io
