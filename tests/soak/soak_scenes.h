// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Coupled scenes that never come to an end, for soak tests.
#pragma once

#include <functional>
#include <optional>
#include <random>

#include "tests/cloth_worlds.h"

namespace meniscus::tests {

inline constexpr float soak_spacing = 0.05f, soak_dt = 1.0f / 60;

/// A tank into whose walls cloth may reach.
struct SoftTank {
  Aabb box;
  float give;  ///< m
};

/// A world that runs, and what its user does to it before a step.
struct SoakScene {
  World world;
  std::function<void(World&, int step)> act;
  /// Particles that the user added, less those that he removed, since the last step.
  int64_t added_by_hand = 0;
  /// Pieces of torn cloth may reach into the wall by less than an edge when it tears. Without it none may be
  /// outside of the tank at all.
  std::optional<SoftTank> tank_of_cloth{};
};

/// Fills the scene's world. `act` may refer to the scene, which stays where it is.
using SoakMaker = void (*)(SoakScene& scene);

void fountain(SoakScene& scene);  ///< an emitter, a sink that drains as much, bodies that float
void tearing(SoakScene& scene);   ///< a jet tears sheets, which are replaced
void laundry(SoakScene& scene);   ///< cloth that absorbs and drips, in a drum that turns
void sleepers(SoakScene& scene);  ///< bodies, sand and water that come to rest and are kicked
void turnover(SoakScene& scene);  ///< bodies, ropes and particles that come and go
void balloons(SoakScene& scene);  ///< gas in closed cloth, on water, in gusts, on ropes

}  // namespace meniscus::tests
