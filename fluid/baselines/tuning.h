// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of the baselines: symbol or name, unit, why this value, and the test that notices. Most
// are their authors'.
#pragma once

#include <cstdint>

namespace meniscus::fluid::baseline_tuning {

/// η of PCISPH: the largest C of any particle at which the iterations end (Solenthaler & Pajarola 2009).
/// Test: none.
inline constexpr float pcisph_tolerance = 0.01f;

/// The fewest iterations of PCISPH (Solenthaler & Pajarola 2009, section 3.4).
/// Test: BaselineStepTest.IterationsEndAtTheTolerance.
inline constexpr int least_pcisph_iterations = 3;

/// η of DFSPH's density solver: the mean of max(C, 0) (Bender & Koschier 2015, section 4).
/// Test: BaselineStepTest.IterationsEndAtTheTolerance.
inline constexpr float dfsph_tolerance = 1e-4f;

/// η_v of DFSPH's divergence solver: the mean of max(h_t dC/dt, 0) (Bender & Koschier 2015, section 4).
/// Test: none.
inline constexpr float divergence_tolerance = 1e-3f;

/// The fewest iterations of DFSPH's two solvers (Bender & Koschier 2015, algorithms 2 and 3).
/// Test: BaselineStepTest.IterationsEndAtTheTolerance.
inline constexpr int least_dfsph_iterations = 2, least_divergence_iterations = 1;

/// ω of DFSPH's Jacobi iterations, as in its authors' SPlisHSPlasH. Test: none.
inline constexpr float dfsph_relaxation = 0.5f;

/// Fraction of the last multipliers from which DFSPH's solvers start, as in its authors' SPlisHSPlasH.
/// Test: none.
inline constexpr float dfsph_warm_start = 0.5f;

/// Neighbours, of about 30 with full support: with fewer DFSPH leaves the divergence as it is, as in its
/// authors' SPlisHSPlasH. Test: none.
inline constexpr float least_neighbours = 20;

/// WCSPH's speed of sound over the fluid's greatest speed: at 10 the density varies by 1 % (Becker & Teschner
/// 2007, section 2.2). Test: none.
inline constexpr float sound_over_speed = 10;

/// γ of Tait's equation (Becker & Teschner 2007, eq. 7).
inline constexpr int tait_exponent = 7;

/// α of WCSPH's artificial viscosity; its authors use 0.08 to 0.5 (Becker & Teschner 2007, section 2.3).
/// Test: none.
inline constexpr float artificial_viscosity = 0.08f;

/// Spacings over the speed of sound, by which a substep of WCSPH is bounded. Pools and dam breaks are stable
/// up to 1.6 and break at 2; its authors ask for 0.4 smoothing lengths (Becker & Teschner 2007, section 2.4).
/// Test: BaselineStepTest.SoundBoundsTheSubstep.
inline constexpr float sound_courant_number = 1.2f;

/// The most substeps of a step that a baseline asks for. Test: none.
inline constexpr int most_substeps = 10000;

}  // namespace meniscus::fluid::baseline_tuning
