// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of the pressure grid: symbol or name, unit, why this value, and the test that notices.
#pragma once

#include <cstdint>

namespace meniscus::fluid {

namespace grid_tuning {

// ---- the solve, once a substep ----

/// Iterations of conjugate gradients. Two are enough for 200 layers.
/// Test: PressureGridTest.HoldsAColumnThatIterationsAloneDoNot.
inline constexpr int iterations = 2;

/// ω: the fraction of the solution that moves particles. The iterations remove the rest, so that the grid
/// does not overshoot.
/// Test: PressureGridTest.TheFloorBearsTheWeight.
inline constexpr float fraction = 0.9f;

/// 1/s: the rate at which old errors are corrected. At once, short substeps would turn small errors into high
/// speeds.
/// Test: PressureGridVesselTest.AFullVesselStaysAtRest.
inline constexpr float recovery = 30;

/// In a node's volume: a lack up to this counts as noise. A greater one is left to gravity.
/// Test: none.
inline constexpr float most_lacking = 0.02f;

/// Spacings: the greatest displacement of particles by a face. A face with few particles would throw them
/// further.
/// Test: none.
inline constexpr float farthest = 0.5f;

// ---- the excess of a particle ----

/// The excess counts in full from C = −0.1 on, as disorder of the lattice, and not below −0.3, at a surface.
/// In between its factor is slope · C + offset.
/// Test: PressureGridTest.HoldsAColumnThatIterationsAloneDoNot.
inline constexpr float disorder_slope = 5, disorder_offset = 1.5f;

// ---- the classes of nodes ----

/// Widths of a cell: the greatest depth in a solid at which a node is an unknown. Half a width deeper than
/// the fluid, no face moves any particle.
/// Test: PressureGridTest.WallsMayStandAnywhereAmongTheNodes.
inline constexpr float deepest = -0.45f;

/// The least weight of a particle on a node at which the particle counts there. If a particle that touches a
/// solid has no weight, as at its cell's border, its contacts could not receive the node's load.
/// Test: PressureGridTest.TheFloorBearsTheWeight.
inline constexpr float least_weight = 1e-6f;

/// The least fraction of a plane that a contact must hold to be a wall here. A smaller part does not close a
/// node.
/// Test: none.
inline constexpr float least_wall = 0.5f;

/// Of a node's particles: up to this fraction on one side of cloth, that side is dry and the cloth a wall.
/// Stray particles must not open it.
/// Test: FluidAndCloth.ASheetIsAFloorToThePressureGrid.
inline constexpr float dry_side = 0.05f;

/// A node is fluid if particles fill this fraction of its open volume. Half is the surface by volume.
/// Test: PressureGridTest.HoldsAColumnThatIterationsAloneDoNot.
inline constexpr float filled = 0.5f;

/// A node with less than `mostly_open` of its volume outside solids is fluid from this fraction on. Few
/// particles reach it, so their sum is noisier.
/// Test: PressureGridTest.WallsMayStandAnywhereAmongTheNodes.
inline constexpr float filled_beside_walls = 0.3f, mostly_open = 0.5f;

// ---- the weights of particles ----

/// Particles with fewer neighbours than this are separate drops, and take no part. Where the table wraps
/// around they could be among the nodes of distant fluid.
/// Test: PressureGridVesselTest.DropsFarAwayNeitherTakeMemoryNorDisturb.
inline constexpr uint32_t least_neighbours = 4;

/// A particle's weight outside solids counts as at least this, which bounds by how much its excess is scaled
/// up.
/// Test: none.
inline constexpr float least_outside = 0.1f;

/// A particle whose weights on movable faces add up to less than this is not moved. The factor would be too
/// large.
/// Test: none.
inline constexpr float least_on_faces = 0.05f;

/// Of the heaviest particle at a face: the face's mass counts as at least this. Otherwise spray would get
/// high speeds.
/// Test: none.
inline constexpr float least_face_mass = 0.5f;

// ---- the load on solids ----

/// The least factor of a contact for nearness, before it is squared, and the least for facing the push. With
/// them any contact takes the load if none is near or faces it.
/// Test: ThreeTogether.KeepTheirMomentumWithEachSolver.
inline constexpr float least_nearness = 0.01f, least_facing = 1e-5f;

// ---- sealed components ----

/// Of a node's diagonal: a remainder up to this is rounding, so the node does not open its component.
/// Test: PressureGridVesselTest.VesselsDoNotDisturbAPoolForLong.
inline constexpr float sealed_rounding = 1e-6f;

}  // namespace grid_tuning

namespace multigrid_tuning {

/// One group of threads solves tables of up to 2 to the power of this. Larger ones need more groups to be
/// fast.
/// Test: MultigridTest.DepthTakesNoMoreIterations.
inline constexpr uint32_t small_bits = 6;

/// Sweeps before and after each visit of the coarser level, on small levels; on other levels one. They cost
/// no launch there.
/// Test: MultigridTest.RaggedEdgesDoNotHarm.
inline constexpr int small_sweeps = 2;

/// Of the sum of the diagonals: a remainder of a coarse equation up to this is rounding.
/// Test: PressureGridVesselTest.VesselsDoNotDisturbAPoolForLong.
inline constexpr float coarse_rounding = 2e-6f;

}  // namespace multigrid_tuning

}  // namespace meniscus::fluid
