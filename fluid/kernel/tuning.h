// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of mirror ghosts and of full supports: symbol or name, unit, why this value, and the
// test that notices.
#pragma once

namespace meniscus::fluid::kernel_tuning {

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
