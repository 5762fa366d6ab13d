// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The contacts of fluid with cloth as means over vertices, for sets that exchange forces through them.
#pragma once

#include "pbd/device/base/view.h"
#include "pbd/math/vec.h"

namespace meniscus::pbd {

/// A point of cloth moves by Σ b_v v_v over the vertices behind it, with weights b_v ≥ 0 whose sum is 1. What
/// acts on the point acts on them with the same weights. So both directions are given: the map from vertices
/// to contacts, and its transpose.
template <class D>
class VertexMeans {
 public:
  virtual ~VertexMeans() = default;
  /// The number of vertices; 0 if no fluid meets cloth.
  virtual uint32_t vertices() const = 0;
  /// By contact on cloth: Σ b_v value(v).
  virtual void to_contacts(View<const Vec4> values, View<Vec4> means) = 0;
  /// By vertex: Σ b_c value(c) over its contacts c, w included. Sums run in multiples of `unit`, a power of
  /// two, so that their order leaves no trace. A value is below 2⁵² units.
  virtual void to_vertices(View<const Vec4> values, View<Vec4> sums, float unit) = 0;
};

}  // namespace meniscus::pbd
