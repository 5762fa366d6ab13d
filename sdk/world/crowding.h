// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How many particles may be created within one support radius.
#pragma once

#include <meniscus/types.h>

#include <cstdint>
#include <functional>
#include <span>

#include "pbd/state/state_visitor.h"

namespace meniscus {

/// Keeps a bound on the particles within any support radius. The present ones are read only when the bound is
/// too high to tell. Motion alone makes no crowd.
class Crowding {
 public:
  /// Throws Error(capacity) if more than world_tuning::most_crowded particles would be within `reach` (m) of
  /// one that is added. The message names how many, where, and the limit.
  void check(std::span<const Vec3> added, const std::function<std::span<const Vec3>()>& present, float reach);

  void visit_state(pbd::StateVisitor& v) { v.value("bound", bound_); }

 private:
  uint64_t bound_ = 0;
};

}  // namespace meniscus
