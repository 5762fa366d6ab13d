// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of how cloth is built: symbol or name, unit, why this value, and the test that notices.
#pragma once

#include <cstddef>
#include <cstdint>

namespace meniscus::cloth {

namespace chain_tuning {

/// Layers of chains. A sheet has two, warp and weft; a mesh without a grain needs one more.
/// Test: Chains.OfAPatchOfTrianglesRunInThreeDirections.
inline constexpr uint32_t most_layers = 3;

/// The least cosine of the angle between successive edges. A sharper turn is the corner of another row.
/// Test: Chains.OfASheetAreItsWarpAndWeft.
inline constexpr float least_cosine = 0.7f;

/// Edges of the shortest chain. A shorter one gains nothing over single constraints.
/// Test: Chains.LongOnesAreCut.
inline constexpr uint32_t fewest_edges = 4;

/// How many times softer than the stiffest edge around it a stiff edge may be. Diagonals of woven cloth are
/// far softer.
/// Test: Chains.OfASheetWithASoftWeftRunAlongThatAsWell.
inline constexpr float much_softer = 8;

/// m/N: an edge of no more compliance is as stiff as a chain needs. A still stiffer one beside it does not
/// make it soft.
/// Test: none.
inline constexpr float stiff = 5e-5f;

/// Of a piece's edges: a piece with more stiff edges has a grain. Warp and weft are two of three.
/// Test: Chains.PiecesHaveAGrainOrNoneEachOnItsOwn.
inline constexpr float fraction_of_grain = 0.5f;

/// Of the rest length: an edge whose ends are otherwise apart in the mesh at rest is a seam.
/// Test: Chains.ASeamIsPartOfNone.
inline constexpr float same_length = 0.01f;

}  // namespace chain_tuning

namespace colouring_tuning {

/// A first colouring with more than 5/4 of the least number of colours is tried in another order. Meshes that
/// are numbered along rows stay below.
/// Test: Colouring.OfAShuffledSheetIsNotMuchWorse.
inline constexpr uint32_t accepted_over = 5, accepted_under = 4;

/// A colour with less than one in so many of the mean number of constraints is divided among the others. A
/// larger one seldom can be.
/// Test: Colouring.OfASheetIsNearTheLeastPossible.
inline constexpr size_t small_colour = 4;

/// The search for a division ends after one step per so many constraints of the mesh, and so many more per
/// constraint of the colour. Beyond that it seldom ends well.
/// Test: Colouring.OfASheetIsNearTheLeastPossible.
inline constexpr size_t constraints_a_step = 5, steps_a_constraint = 16;

/// Steps: for how long a constraint that was placed is protected. Without it two constraints displace each
/// other by turns.
/// Test: none.
inline constexpr uint32_t recent = 400;

/// The cost of a displaced constraint that has no other free colour, and of each step that it is younger than
/// `recent`. A free colour counts half as much as full protection.
/// Test: none.
inline constexpr uint32_t homeless_cost = 1000, recent_cost = 5;

}  // namespace colouring_tuning

namespace balance_tuning {

/// The least factor of a hinge's stiffness. A hinge without stiffness would be a crease.
/// Test: BuildBending.OfASheetIsTheSameInAnyDirection.
inline constexpr double least_factor = 0.1;

/// How much factors near 1 are preferred to exact energies.
/// Test: BuildBending.OfASheetIsTheSameInAnyDirection.
inline constexpr double preference = 1e-5;

/// At most so many rounds of coordinate descent, until no factor changes by more than this.
/// Test: BuildBending.OfASheetIsTheSameInAnyDirection.
inline constexpr int rounds = 100;
inline constexpr double accuracy = 1e-4;

/// Of the forces that a bend exerts on a vertex: the greatest sum with which the mesh counts as regular
/// there. Rounding leaves 1e-4 on sheets of a thousand columns. On a mesh with vertices moved by a tenth of
/// an edge it is more than 0.1. Test: ClothBending.OfAnIrregularMeshIsAsAsked.
inline constexpr double regular = 0.01;

}  // namespace balance_tuning

namespace build_tuning {

/// Of a triangle's longest edge: its least height. With a seam of 2·10⁻⁴ a sheet that drops blows up, and
/// with 5·10⁻⁴ it recovers.
/// Test: ClothMesh.AThinTriangleIsRefusedByItsEdge.
inline constexpr double least_height = 5e-4;

/// 1/s²: a hinge counts as at most so stiff against the masses of its corners. That is stiffer than any
/// substep resolves.
/// Test: BendingMatrix.HasFiniteEntriesForUnyieldingCloth.
inline constexpr double stiffest_bending = 1e9;

/// Rounds of the power iteration that bounds the fastest bending. More bound it hardly better.
/// Test: BendingMatrix.BoundsItsFastestMode.
inline constexpr int bound_rounds = 20;

/// rad: a rest shape with a smaller angle counts as flat, so its hinge is isometric. Meshes from files are
/// flat to about this.
/// Test: BuildBending.IsometricHingesMeasureTheAngle.
inline constexpr double flat_angle = 1e-3;

/// The cosine, of 8°, between a triangle's normal and the x axis from which on the warp is taken from z. The
/// projection of x would be short.
/// Test: none.
inline constexpr double warp_along_normal = 0.9903;

/// Of 2 π over the size of gusts: the least wave number, and by how much others exceed it. Two octaves around
/// the size make gusts of mixed sizes.
/// Test: none.
inline constexpr double least_gust = 0.5, gust_range = 1.5;

}  // namespace build_tuning

}  // namespace meniscus::cloth
