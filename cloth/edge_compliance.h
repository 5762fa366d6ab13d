// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "cloth/constraints.h"

namespace meniscus::cloth {

/// 1/s: what has been pressed together opens by about this share of its length. Fabric that is pressed
/// buckles, in folds that a mesh may be too coarse for; were its edges to regain their lengths within a
/// substep, crumpled cloth would burst apart.
inline constexpr float opening_rate = 10;

/// 1/kg: what an edge yields with that is `error` (m) longer than at rest. What was pressed together as the
/// substep began becomes as soft as lets it open at that rate; it still pushes, and pulls on nothing.
template <class Vertices>
MENISCUS_HD float edge_compliance(const Vertices& vertices, const EdgeConstraint& e, float error,
                                  float weight, float inverse_dt) {
  const float given = e.compliance * inverse_dt * inverse_dt;
  const float opening = opening_rate / inverse_dt * e.rest_length;
  if (error >= -opening) return given;
  const float lacking = e.rest_length - length(vertices.previous(e.b).xyz() - vertices.previous(e.a).xyz());
  return fmaxf(given, weight * (lacking / opening - 1));
}

}  // namespace meniscus::cloth
