// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The compliance of an edge, which rises while the edge recovers from compression.
#pragma once

#include "cloth/build/constraints.h"
#include "pbd/device/scalar.h"

namespace meniscus::cloth {

/// 1/kg: the compliance term of an edge. `compliance` is in m/N, and `error` is length minus rest length, m.
/// was() returns the length of the edge at the start of the substep. An edge that was compressed then becomes
/// soft enough to recover only the fraction `opens` of its rest length. It still pushes, and pulls on
/// nothing. R has a lane for each of several edges.
template <class R, class Was>
MENISCUS_HD R edge_compliance(R compliance, R rest_length, R error, R weight, float inverse_dt, R opens,
                              const Was& was) {
  using pbd::less_mask;
  using pbd::max;
  using pbd::select_less;
  const R given = compliance * R(inverse_dt) * R(inverse_dt);
  const R opening = opens * rest_length;
  if (less_mask(error, -opening) == 0) return given;
  const R softened = weight * ((rest_length - was()) / opening - R(1));
  return select_less(error, -opening, max(softened, given), given);
}

}  // namespace meniscus::cloth
