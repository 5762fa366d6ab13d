// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Checks of periodic axes, and of what a world with them takes.
#include "sdk/world/check/periodic.h"

#include <meniscus/error.h>

#include <string>

#include "sdk/world/check/check.h"

namespace meniscus {

namespace {

constexpr char axis_names[] = "xyz";

float along(Vec3 v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

}  // namespace

pbd::PeriodicAxes periodic_axes(const PeriodicDef& def) {
  const auto low = [](const std::optional<PeriodicExtent>& e) { return e ? e->low : 0.0f; };
  const auto length = [](const std::optional<PeriodicExtent>& e) { return e ? e->high - e->low : 0.0f; };
  return {{low(def.x), low(def.y), low(def.z)}, {length(def.x), length(def.y), length(def.z)}};
}

namespace check {

void no_periodic_axes(const WorldDef& world, const char* kind) {
  if (!periodic_axes(world.periodic).any()) return;
  throw Error(ErrorCode::invalid_argument,
              std::string("a world with periodic axes takes no ") + kind + "; it takes fluids and shapes");
}

void between_seams(const pbd::PeriodicAxes& axes, std::span<const Vec3> points, const char* what) {
  for (const Vec3 p : points) {
    for (int axis = 0; axis < 3; ++axis) {
      const float low = along(axes.low, axis), extent = along(axes.extent, axis), x = along(p, axis);
      if (extent > 0 && !(x >= low && x <= low + extent))
        refuse(what, text_of(p), std::string("between the ends of WorldDef::periodic.") + axis_names[axis]);
    }
  }
}

}  // namespace check

}  // namespace meniscus
