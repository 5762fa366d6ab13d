// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Four lanes in the registers of one GPU thread: four loads are in flight before the first is used.
#pragma once

#include <cstdint>

#include "pbd/device/view.h"
#include "pbd/math/vec.h"

namespace meniscus::pbd {

struct BatchFloat {
  float a, b, c, d;

  BatchFloat() = default;
  MENISCUS_HD BatchFloat(float s) : a(s), b(s), c(s), d(s) {}
  MENISCUS_HD BatchFloat(float a_, float b_, float c_, float d_) : a(a_), b(b_), c(c_), d(d_) {}
};

MENISCUS_HD inline BatchFloat operator+(BatchFloat x, BatchFloat y) {
  return {x.a + y.a, x.b + y.b, x.c + y.c, x.d + y.d};
}
MENISCUS_HD inline BatchFloat operator-(BatchFloat x, BatchFloat y) {
  return {x.a - y.a, x.b - y.b, x.c - y.c, x.d - y.d};
}
MENISCUS_HD inline BatchFloat operator*(BatchFloat x, BatchFloat y) {
  return {x.a * y.a, x.b * y.b, x.c * y.c, x.d * y.d};
}

/// Bit k is set where x < y in lane k.
MENISCUS_HD inline uint32_t less_mask(BatchFloat x, BatchFloat y) {
  return uint32_t(x.a < y.a) | uint32_t(x.b < y.b) << 1 | uint32_t(x.c < y.c) << 2 | uint32_t(x.d < y.d) << 3;
}

/// Four consecutive elements from `first` on; the array must reach that far.
MENISCUS_HD inline Vec4Of<BatchFloat> load_run(View<const Vec4> from, uint32_t first, BatchFloat*) {
  const View<const Vec4> run{from.data + first, from.count - first};
  const Vec4 p = load(run, 0), q = load(run, 1), r = load(run, 2), s = load(run, 3);
  return {{p.x, q.x, r.x, s.x}, {p.y, q.y, r.y, s.y}, {p.z, q.z, r.z, s.z}, {p.w, q.w, r.w, s.w}};
}

/// What a kernel is a template over when one thread runs it on four lanes.
struct CudaBatch {
  using Real = BatchFloat;
  static constexpr uint32_t lane_count = 4;
};

}  // namespace meniscus::pbd
