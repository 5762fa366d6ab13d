// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Rods as kernels read them.
#pragma once

#include <cstdint>

#include "pbd/device/base/view.h"
#include "pbd/math/vec.h"

namespace meniscus::cloth {

/// The part of a rod between two vertices. Compliances are inverse stiffnesses; 0 is unyielding.
struct RodSegment {
  uint32_t a, b;             ///< vertices
  uint32_t before, after;    ///< segments of the same rod; pbd::no_index where it ends
  float rest_length;         ///< l, m
  float stretch_compliance;  ///< l/EA, m/N
  float shear_compliance;    ///< l/(κGA), m/N
  float bend_compliance;     ///< (l/2)/EI, rad/(N·m), of half of the segment
  float twist_compliance;    ///< (l/2)/GJ, rad/(N·m), of half of the segment
  float bend_mobility;       ///< 1/(kg·m²), inverse inertia about an axis across it
  float twist_mobility;      ///< 1/(kg·m²), about its own axis
  float damping;             ///< s, of Rayleigh's kind
  Quat rest;                 ///< from this frame to the one after it, at rest
};

/// Segments in a row. In a closed chain the one after the last is the first.
struct RodChain {
  uint32_t first, count;
  uint32_t closed;  ///< 0 or 1
};

/// How a segment is turned and turns.
struct SegmentState {
  Quat frame{0, 0, 0, 1};  ///< the segment's z axis lies along it
  Vec3 spin{0, 0, 0};      ///< rad/s, in the world's axes
  bool held = false;       ///< it turns as its spin says, and nothing else turns it
};

}  // namespace meniscus::cloth
