// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of films: symbol or name, unit, why this value, and the test that notices.
#pragma once

#include <cstddef>
#include <cstdint>

namespace meniscus::collision::film_tuning {

/// Spacings: the longest edge of a film's triangles. Particles give the pressure at its rim no more finely.
/// Test: FilmTest.APlugOverADrainIsHeldWithTheFilmsIntegral.
inline constexpr float edge = 0.75f;

/// Triangles of one body at most. Those of larger bodies are coarser.
/// Test: FilmSurface.IsNoFinerThanNeeded.
inline constexpr uint32_t most_triangles = 16384;

/// Contact radii: a gap below the first is a film, however few particles are in it. One above the second is
/// none. A particle fits from two on, and needs some room to get in.
/// Test: FilmTest.TheForceIsSteadyWhileABodyIsLifted.
inline constexpr float narrow = 3, wide = 4;

/// The cosine between a face's normal and the opposite of the other's from which the two form a gap, and the
/// one from which they form a whole one.
/// Test: none.
inline constexpr float least_facing = 0.25f, whole_facing = 0.5f;

/// Contact radii: below this gap both faces are rough, and the film is as thick everywhere.
/// Test: FilmSolve.IsUniformBelowTheRoughness.
inline constexpr float roughness = 0.2f;

/// Times the film's conductance: the conductance from a rim to the fluid beside it. More would cost digits.
/// Test: FilmSolve.TheRimHasThePressureOfTheFluid.
inline constexpr float rim = 100;

/// Of the kernel: the part that fluid fills at a rim that is wet. A quarter of the space holds fluid there.
/// Test: FilmTest.TheForceOnWhatIsFlushOnTheFloorIsThatOfArchimedes.
inline constexpr float wet = 0.1f;

/// Steps of the conjugate gradients at most, and the residual at which they end, of that at their start. A
/// film 100 triangles wide needs as many steps.
/// Test: FilmSolve.IsThatOfTheDenseSystem.
inline constexpr uint32_t most_steps = 256;
inline constexpr float residual = 1e-4f;

/// The difference of two normals against gravity from which the upper of two bodies has the film. Between
/// faces that are more upright than that there is little to choose.
/// Test: none.
inline constexpr float upright = 0.2f;

/// Of the film's load, what it bears at most where particles exert less than they should. They are that much
/// off; a jet on the body that is stronger counts.
/// Test: FilmSolve.NeitherPullsNorBearsAJet.
inline constexpr float most_load = 1.1f;

/// Of the film's load: how much the scale may differ over the standard deviation of the film's place. So much
/// torque can be borne as particles exert too little or too much.
/// Test: FilmSolve.NeitherPullsNorBearsAJet.
inline constexpr float most_tilt = 0.2f;

/// Bodies that may stand on one another, and films pass on what they bear beyond their pressure.
/// Test: FloatingBodiesTest.APileUnderWaterDoesNotSinkIntoItself.
inline constexpr int storeys = 6;

/// Pairs of solids at most that the host tests for nearness. More would take longer than to look for films.
/// Test: none.
inline constexpr size_t most_pairs = 1 << 16;

/// N·s and N·m·s: the unit in which impulses are summed as integers.
/// Test: FilmLoads.AreOppositeOnBothFaces.
inline constexpr double unit = 0x1p-32;

}  // namespace meniscus::collision::film_tuning
