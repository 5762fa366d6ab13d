// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of World: symbol or name, unit, why this value, and the test that notices.
#pragma once

#include <cstddef>
#include <cstdint>

namespace meniscus::world_tuning {

/// Spacings: the range within which the points of a fluid that is shaken lie around their lattice. It breaks
/// the lattice and lets no two points come close.
/// Test: none.
inline constexpr float shaking = 0.5f;

/// Spacings: a mesh with shorter edges, in the mean, spreads contacts with fluid over vertices. On a coarser
/// one each triangle has its own particles.
/// Test: FluidAndCloth.FineLightClothBearsDeepWater.
inline constexpr float fine_mesh = 0.9f;

/// Mean edges: the least and the largest radius over which a contact is spread. Every vertex between
/// particles must get its part, and no contact may have too many vertices.
/// Test: FluidAndCloth.FineLightClothBearsDeepWater.
inline constexpr float least_spread = 1.2f, most_spread = 2.6f;

/// Vertices that are split in a piece and step, at most. It bounds the work where much tears at once. The
/// rest tears in the next steps. Test: none.
inline constexpr uint32_t most_splits = 64;

/// Contact distances: how far below a wet piece a drop appears. Nearer, cloth would absorb it again.
/// Test: WetCloth.HungUpItDripsAndIsHeavierByWhatItKeeps.
inline constexpr float drop_distance = 1.6f;

/// Particles within one support radius of a new one, itself included, at most. Each has a row of the
/// neighbour list as long as the longest, so this many at one point take 1.2 GB.
/// Test: CrowdTest.MoreThanTheLimitAreRefused.
inline constexpr uint32_t most_crowded = 16384;

/// Of the contact radius, or of the smaller solid's radius: deeper overlaps are warned of. Solids that are
/// stacked without a gap overlap by rounding.
/// Test: WarningsTest.OverlapsAreCounted.
inline constexpr float deep_overlap = 0.02f;

/// Spacings: positions that are rounded more coarsely are warned of.
/// Test: WarningsTest.PlacesFarFromTheOriginAreRounded.
inline constexpr float coarsest_position = 0.01f;

/// Nodes of a distance field: fields with more are warned of, as they take seconds on a CPU.
/// Test: CancelTest.TheFieldOfALargeHullIsBounded.
inline constexpr std::size_t many_field_nodes = 1'000'000;

/// Particles that emitters make in a step, at most: a bound on the time of a step.
/// Test: CancelTest.AStepMakesABoundedNumberOfParticles.
inline constexpr double most_arrivals = 1 << 20;

/// Spacings: how far points push one another where they are seeded without order. It is the default support.
/// Test: SeedingTest.DisorderHasTheRestDensity.
inline constexpr float relaxing_support = 2;

/// Of the support squared: what a round moves by the pushes. From three times as much points do not settle.
/// Spacings: the longest motion in a round. Points start about half a spacing from where they end.
/// Test: SeedingTest.DisorderHasTheRestDensity.
inline constexpr float relaxing_rate = 0.06f, relaxing_limit = 0.05f;

/// Rounds of points that are seeded without order, and how many use one list of neighbours.
/// Test: SeedingTest.DisorderHasTheRestDensity.
inline constexpr int relaxing_rounds = 80, rounds_of_a_list = 8;

/// Relaxations by the solver of particles that are seeded without order. Then max(C, 0) is below 1e-3.
/// Test: SeedingTest.DisorderHasTheRestDensity.
inline constexpr int seeding_relaxations = 20;

/// How often points that are seeded beside solids are moved out of them. In a corner one motion undoes a part
/// of another.
/// Test: SeedingTest.DisorderIsSafeAtWallsAndBodies.
inline constexpr int rounds_out_of_solids = 4;

/// s: the step of a relaxation. It is short, so that nothing passes through anything.
/// Test: none.
inline constexpr float relaxing_step = 0.001f;

}  // namespace meniscus::world_tuning
