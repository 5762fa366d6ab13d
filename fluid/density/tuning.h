// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of crowds: symbol or name, unit, why this value, and the test that notices.
#pragma once

namespace meniscus::fluid::crowd_tuning {

/// C of a particle that was placed, above which it belongs to a crowd: twice the rest density. Particles that
/// are placed at random, at the rest density, stay below.
/// Test: CrowdTest.ParticlesAtOnePointPart.
inline constexpr float dense = 1.0f;

/// Spacings: particles that are nearer count as near the same point. Their nearness falls from 1 to 0. And
/// the nearness above which particles that were placed belong to a crowd.
/// Test: CrowdTest.TwoAtOnePointPart.
inline constexpr float near_spacings = 0.2f, near = 0.5f;

/// The error above which a particle joins the crowd beside it. Water in motion stays below.
/// Test: CrowdTest.InsideAPoolItPartsAsGently.
inline constexpr float joins = 0.05f;

/// The compression below which a particle leaves the crowd. The density constraint removes it at little
/// speed. Test: CrowdTest.ParticlesAtOnePointPart.
inline constexpr float parted = 0.01f;

/// 1/s: the rate at which the density constraint takes over the compression that is kept, or C a second where
/// that is above 1. Under a load, displacements without speed are undone as fast as they are made.
/// Test: CrowdTest.InsideAPoolItParts.
inline constexpr float recovery = 2;

/// Of C: two sums over thousands of neighbours, at positions that were rounded twice, differ by less.
/// Test: CrowdTest.ParticlesAtOnePointPart.
inline constexpr float rounding = 1e-3f;

/// Of the last multiplier, what the next round starts from. A crowd parts over many substeps in the same way.
/// Test: CrowdTest.ParticlesAtOnePointPart.
inline constexpr float momentum = 0.9f;

/// ω of the damped Jacobi rounds. The spectrum's bound is 4.5, so up to .44 is stable, and with
/// momentum more.
/// Test: CrowdTest.ParticlesAtOnePointPart.
inline constexpr float relaxation = 0.3f;

}  // namespace meniscus::fluid::crowd_tuning
