// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Water on both sides of a taut sheet that parts a tank, held along its top and its bottom.
#pragma once

#include <meniscus/world.h>

#include <array>
#include <vector>

namespace meniscus::validation {

struct PartedTank {
  static constexpr float height = 0.4f;  ///< m, of the sheet

  World world;
  ClothId cloth;
  std::array<double, 2> volume{};  ///< m³, of the water on the left and on the right

  /// With water up to these levels, m.
  PartedTank(WorldDef base, float left, float right);

  /// By row of height from the floor up, m, the mean over the tank's width: how far the sheet is to the
  /// right. The mean over a second, after it has come to rest.
  std::vector<double> bulge_at_rest();

 private:
  std::vector<double> bulge() const;
};

/// What the theory says of the same, by finite differences on the sheet's own rows: T w'' = −Δp, with the
/// tension T that its stretch gives.
std::vector<double> exact_bulge(const std::array<double, 2>& volume);

/// The largest size of them.
double largest(const std::vector<double>& values);
double largest_difference(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace meniscus::validation
