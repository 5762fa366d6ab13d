// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of a world's solids: symbol or name, unit, why this value, and the test that notices.
#pragma once

namespace meniscus::solids_tuning {

/// The least cosine between normals of samples that crowd each other. Samples on two sides of a thin sheet do
/// not.
/// Test: EmitterSites.AMeshGivesItsAreaTimesTheSpeed.
inline constexpr float same_side = -0.5f;

/// The exponent of the weight by which samples crowd each other, as in the source of the method.
/// Test: EmitterSites.AMeshGivesAlongItsNormals.
inline constexpr int crowding_exponent = 8;

/// Spacings: the cells of a mesh's field that is given no size. Particles cannot resolve finer details.
/// Test: StaticShapesTest.AMesh.
inline constexpr float field_cell = 0.5f;

/// Cells of the grid of a repair along the longest side of a mesh, at least. The volume of a
/// tetrahedron is then right to 0.6 %.
/// Test: BodyRepairTest.AnOpenMeshFallsAsTheClosedOne.
inline constexpr float repair_cells = 32;

/// Nodes of the field of a mesh that is given no size, about, at most. Sharp edges are rounded by about half
/// a cell. Test: CancelTest.TheFieldOfALargeHullIsBounded.
inline constexpr double most_field_nodes = 1u << 21;

}  // namespace meniscus::solids_tuning
