// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of the engine: symbol or name, unit, why this value, and the test that notices.
#pragma once

namespace meniscus::engine_tuning {

/// Spacings: a new particle has room if all others are at least this far away. Nearer, the density solve
/// would throw both apart.
/// Test: EmitterRoomTest.WhereAParticleIsThereIsNoRoom.
inline constexpr float apart = 0.7f;

/// Spacings: the least distance of a new particle from solids and cloth. The outer layer of a lattice that
/// just fits is half a spacing away, and the margin absorbs rounding.
/// Test: BodyFluidTest.FluidIsNotSeededInsideABody.
inline constexpr float clearance = 0.49f;

/// Contact radii: a particle that is nearer to a solid when it appears overlaps it, and leaves it slowly.
/// Contacts at rest keep more.
/// Test: PlacedWater.IsNotThrownOutOfASolid.
inline constexpr float overlapping = 0.5f;

}  // namespace meniscus::engine_tuning
