// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of the forces: symbol or name, unit, why this value, and the test that notices.
#pragma once

namespace meniscus::fluid::forces_tuning {

/// The tension that a drop's period shows, over the one asked for. It is measured, and both terms of the
/// force are divided by it.
/// Test: SurfaceTensionTest.ADropSwingsWithRayleighsPeriod.
inline constexpr double measured_over_asked = 1.17;

}  // namespace meniscus::fluid::forces_tuning
