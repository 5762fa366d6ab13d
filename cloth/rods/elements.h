// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The segments and chains of rods, as kernels read them.
#pragma once

#include <cstdint>

#include "pbd/device/base/view.h"
#include "pbd/math/vec.h"

namespace meniscus::cloth {

/// The part of a rod between two vertices. Compliances are inverse stiffnesses; 0 is unyielding.
struct RodSegment {
  uint32_t a, b;             ///< vertices
  uint32_t before, after;    ///< segments of the same rod; pbd::no_index at an end of the rod
  float rest_length;         ///< l, m
  float stretch_compliance;  ///< l/EA, m/N
  float shear_compliance;    ///< l/(κGA), m/N
  float bend_compliance;     ///< (l/2)/EI, rad/(N·m), of half of the segment
  float twist_compliance;    ///< (l/2)/GJ, rad/(N·m), of half of the segment
  float bend_mobility;       ///< 1/(kg·m²), inverse inertia about an axis across it
  float twist_mobility;      ///< 1/(kg·m²), about its own axis
  float damping;             ///< s, Rayleigh damping
  Quat rest;                 ///< from this frame to the next one, at rest
};

/// Segments in a row. In a closed chain the first segment follows the last.
struct RodChain {
  uint32_t first, count;
  uint32_t closed;  ///< 0 or 1
};

/// The orientation of a segment, and its rotation.
struct SegmentState {
  Quat frame{0, 0, 0, 1};  ///< the segment's z axis lies along it
  Vec3 spin{0, 0, 0};      ///< rad/s, in the world's axes
  bool held = false;       ///< it rotates with its spin, and nothing else rotates it
};

}  // namespace meniscus::cloth
