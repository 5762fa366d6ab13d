// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of signed distance fields and density maps: symbol or name, unit, why this value, and
// the test that notices.
#pragma once

#include <cstdint>

namespace meniscus::collision::sdf_tuning {

/// Steps of the grid, and samples of the quadrature, in a support radius of the density map.
/// Test: DensityMap.EdgesAndCornersOfABoxAgreeWithQuadrature.
inline constexpr double steps_a_radius = 8, samples_a_radius = 4;

/// Samples of a density map, at most: two arrays of 64 MiB. A field of more than an eighth as many nodes,
/// with cells of h/4, has one sample a node. Beside a box its values are then off by 0.002 at faces, as with
/// more samples, and by 0.011 at edges. Test: DensityMap.WithFewerSamplesItIsOffByLittle.
inline constexpr double most_samples = 1u << 24;

/// Of a step: a cell of h/4 counts as one despite rounding.
/// Test: DensityQuadrature.CellsAreDividedAsOftenAsAllowed.
inline constexpr double step_rounding = 1e-4;

/// Random points near a mesh at which the error of its field is measured, beside the points on it.
/// Test: SdfToError.CellsAreAsSmallAsTheTargetAsks.
inline constexpr uint32_t strewn_points = 1u << 15;

/// The winding numbers between which a point lies beside a hole, where the sign of the distance is open.
/// Test: SdfToError.AHoleIsNoError.
inline constexpr float least_beside_hole = 0.1f, most_beside_hole = 0.9f;

/// Cells along the longest side of a mesh in the first grid that is tried for a given error.
/// Test: none.
inline constexpr float first_cells = 8;

/// Points of the grid that repairs a mesh, at most: about 20 s on one core.
/// Test: RepairMesh.WallsThinnerThanTheFinestCellsAreRefused.
inline constexpr double most_repair_points = 1u << 22;

/// Of the first cells of a repair: the finest ones. Tips of 15° still lose less than a first cell.
/// Test: RepairMesh.SharpTipsAreKept.
inline constexpr float finest_repair = 0.125f;

/// Of a cell: how far a vertex of a repaired mesh stays from the nodes of the grid. At a node, the vertices
/// of several edges would coincide. Test: RepairMesh.OverlappingBoxesBecomeTheirUnion.
inline constexpr float off_node = 0.02f;

/// Of a cell: the distance on both sides of a mesh's point at which its winding number is compared.
/// Test: RepairMesh.OverlappingBoxesBecomeTheirUnion.
inline constexpr float beside_surface = 0.01f;

}  // namespace meniscus::collision::sdf_tuning
