// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of the forces: symbol or name, unit, why this value, and the test that notices.
#pragma once

#include <meniscus/defs.h>

#include <cstdint>

namespace meniscus::fluid::forces_tuning {

/// The tension that a drop's period shows, over the one asked for. It is measured, and both terms of the
/// force are divided by it.
/// Test: SurfaceTensionTest.ADropSwingsWithRayleighsPeriod.
constexpr double measured_over_asked(SmoothingKernel shape) {
  switch (shape) {
    case SmoothingKernel::wendland_c2:
      return 1.9;
    case SmoothingKernel::cubic_spline:
      return 2.15;
    case SmoothingKernel::poly6_spiky:
      break;
  }
  return 1.17;
}

/// Of the velocity change by a stiff solve: the residual at which the viscosity's iterations end. A honey
/// that stands still in a column then feels a wrong weight of 1e-4. Test:
/// ViscosityTest.AShearWaveDecaysAtTheAnalyticRate.
inline constexpr double viscosity_tolerance = 1e-4;

/// The iterations of the most viscous fluids, at 2 cm and 4 ms above 3,000 Pa·s. Each iteration dissipates,
/// so that a solve which ends here is too thin, and stable. Test:
/// ViscosityTest.AVeryStiffFluidDoesNotExplode.
inline constexpr uint32_t most_viscosity_iterations = 200;

/// Contact radii: a particle nearer to a wall than this feels the viscous force at this distance. Particles
/// that overlap at the start alone come so near.
/// Test: none.
inline constexpr float least_wall_distance = 0.5f;

}  // namespace meniscus::fluid::forces_tuning
