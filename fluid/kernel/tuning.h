// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of mirror ghosts and of full supports: symbol or name, unit, why this value, and the
// test that notices.
#pragma once

namespace meniscus::fluid::kernel_tuning {

/// Points along an edge of the packing on which kernels are calibrated, where the support radius allows. With
/// twice as many, V changes by 0.1 %.
/// Test: none.
inline constexpr int least_packing = 6;

/// Rounds in which the packing relaxes. With twice as many, V changes by less than 0.1 %.
/// Test: KernelTest.ALatticeIsAsDenseAsARelaxedPacking.
inline constexpr int packing_rounds = 400;

/// Of h²: what a round moves by Σ |∇W| n. From three times as much the packing does not settle.
/// Test: KernelTest.ALatticeIsAsDenseAsARelaxedPacking.
inline constexpr double packing_step = 0.06;

/// Spacings: the largest motion of a round. Points that start at one place would be thrown far away.
/// Test: none.
inline constexpr double packing_limit = 0.2;

/// Rounds of the power iteration for the spectrum's bound.
/// Test: KernelTest.TheSpectrumIsBounded.
inline constexpr int spectral_rounds = 60;

/// The bound of the spectrum over that of the packing. Water in motion exceeds what is at rest: the lattice
/// of poly6_spiky has 2.73, and 4.5 is safe. Test: RestTest.WaterComesToRest.
inline constexpr double spectral_margin = 1.65;

/// In support radii: a particle up to this deep behind a mirror counts as on it. Contacts let particles dip
/// in a little, and a dip must not remove a ghost.
/// Test: none.
inline constexpr float mirror_slack = 0.25f;

/// The cosine between normals above which two mirrors form one wall and share it. Walls that meet at a corner
/// are far below.
/// Test: MirrorGhostsTest.TwoSolidsThatMakeUpOneFloorCountOnce.
inline constexpr float same_wall = 0.9f;

/// The square of |Σ e| in 1/spacings below which a support is full. At a free surface |Σ e| is about ½;
/// inside it is the noise of disorder.
/// Test: none.
inline constexpr float full_gradient2 = 0.04f;

/// The least C of a particle with a full support. A thin spray has no gradient either, but less density.
/// Test: none.
inline constexpr float full_density = -0.3f;

}  // namespace meniscus::fluid::kernel_tuning
