// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "cloth/build/constraints.h"
#include "pbd/device/scalar.h"

namespace meniscus::cloth {

/// 1/s: what has been pressed together opens by about this share of its length. Fabric that is pressed
/// buckles, in folds that a mesh may be too coarse for; were its edges to regain their lengths within a
/// substep, crumpled cloth would burst apart.
inline constexpr float recovery_rate = 10;

/// 1/s: the same for an edge that shears (SolveEdge), which buckling does not shorten before it has sheared.
inline constexpr float shear_recovery_rate = 40;

/// 1/kg: what an edge with this compliance (m/N) yields with that is `error` (m) longer than at rest. What
/// was pressed together as the substep began, when it had the length that was() returns, becomes as soft as
/// lets it open by the share `opens` of its length at rest; it still pushes, and pulls on nothing. R has a
/// lane for each of several edges.
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
