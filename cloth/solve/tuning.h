// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of the solver of cloth: symbol or name, unit, why this value, and the test that
// notices.
#pragma once

namespace meniscus::cloth::cloth_tuning {

/// 1/s: the rate at which a compressed edge recovers, as a fraction of its length. Compressed fabric buckles,
/// in folds that may be too fine for the mesh. If its edges regained their lengths within a substep, crumpled
/// cloth would burst apart.
/// Test: PressedCloth.Opens.
inline constexpr float recovery_rate = 10;

/// 1/s: the same for an edge that shears (SolveEdge). Buckling does not shorten such an edge before it has
/// sheared.
/// Test: ClothRounds.KeepRowsFromSliding.
inline constexpr float shear_recovery_rate = 40;

/// The greatest relaxation of compressed edges. Some edges of a hanging mesh of triangles are compressed.
/// Lengthened in full each substep, they buckle back and forth and never come to rest.
/// Test: ClothHanging.ByTethersASheetKeepsItsLength.
inline constexpr float compressed_relaxation = 0.2f;

/// Heavy-ball momentum (Polyak 1964) of pulling edges, from round to round. Chains take back most of a
/// diagonal's step. Its multiplier would need w/α̃ rounds to reach what the shear stiffness asks for. With
/// momentum it needs about the square root of that.
/// Test: ClothRounds.GatherMomentum.
inline constexpr float round_momentum = 0.85f;

/// Of the warm start: the fraction of a multiplier that pushes. Edges that push buckle, so they keep less.
/// Test: ClothRounds.AreSavedByAStartFromTheLastSubstep.
inline constexpr float pushing_start = 0.4f;

/// Of w_k + w_k₊₁: what is added to the diagonal of a chain. Without it, a straight chain between two fixed
/// vertices has no solution.
/// Test: ClothChain.AStripOfClothHangsAsACatenary.
inline constexpr float chain_regularisation = 0.0003f;

/// The most that a mode of bending keeps of its error, slow modes aside. Above a third, stiff modes
/// oscillate. Test: ClothBending.OfAStripAlongTheWarpIsAsAsked.
inline constexpr float bending_error = 0.2f;

/// The most steps of the block solve of bending in a substep. They suffice up to D hₜ²/(ρ Δ⁴) = 35 on a
/// sheet. Beyond that, cloth is softer than asked. Test: ClothBending.IsReportedWhereItIsNotHad.
inline constexpr uint32_t most_bending_steps = 64;

}  // namespace meniscus::cloth::cloth_tuning
