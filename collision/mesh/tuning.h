// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of meshes of solids: symbol or name, unit, why this value, and the test that notices.
#pragma once

#include <cstddef>

namespace meniscus::collision::mesh_tuning {

/// Of the box's diagonal: vertices nearer than this are one. Files store about seven digits.
/// Test: CleanMesh.WeldsVerticesAMillionthOfTheBoxApart.
inline constexpr double weld_distance = 1e-6;

/// Of the box's diagonal: vertices that the first file of a sequence merges may be this far apart in another.
/// Text with few digits rounds, and vertices of changed triangles are about an edge apart.
/// Test: MeshSequenceTest.RefusesOtherTrianglesWithRepeatedVertices.
inline constexpr double sequence_weld_distance = 1e-4;

/// The least height of a triangle over its longest edge. Below it a float normal is all rounding.
/// Test: CleanMesh.DropsFlatAndRepeatedTrianglesAndUnusedVertices.
inline constexpr double flat_height = 1e-7;

/// Of the box's diagonal: parts that overlap by less touch and do not cross. Welded vertices are no crossing.
/// Test: MeshDefects.PartsThatTouchOrLieApartDoNotCross.
inline constexpr double touch_distance = 1e-6;

/// The least volume of a hull over the cube of its diagonal. Flatter points lie in a plane but for rounding.
/// Test: BodyErrorTest.AHullMustSpanAVolume.
inline constexpr double least_volume = 1e-6;

/// The least principal moment of inertia over the largest. Below it the solve is dominated by rounding.
/// Test: MassProperties.WhatHasNoMassIsRefused.
inline constexpr double least_moment = 1e-6;

/// Of the trace: products of inertia up to this are rounding, and the axes stay as they are.
/// Test: MassProperties.ClosedFormsAreTheIntegrals.
inline constexpr double rounded_product = 1e-9;

/// Of the hull's volume: parts of a concave mesh are cut while the hull of one exceeds it by more.
/// Test: ConvexParts.ABowlIsOpen.
inline constexpr double most_excess = 0.001;

/// Cells along each axis of a part. It may be cut between them. More cost time and find little.
/// Test: ConvexParts.ARingHasAHole.
inline constexpr size_t cells_an_axis = 8;

/// The weight of the difference between both sides' hulls. Where all cuts are equally good, as for a ring,
/// the middle one is best. V-HACD (Mamou 2016) has such a term too.
/// Test: ConvexParts.ARingHasAHole.
inline constexpr double balance = 0.05;

/// Radii of a node: beyond this distance, the winding number takes its far field (Barill et al. 2018). The
/// error, measured in and around scanned meshes, is 0.04 at most and 0.006 in the mean.
/// Test: TriangleBvhOver.WindingNumberAgreesWithBruteForce.
inline constexpr float opening = 2;

}  // namespace meniscus::collision::mesh_tuning

namespace meniscus::collision::bullet_tuning {

/// Memory held back for Bullet: bytes of a block, blocks of a small world, and solids for each further one.
/// Bullet's arrays grow by doubling.
/// Test: FaultsTest.NoMemoryFromAnyCallStackOnIsAnError.
inline constexpr std::size_t reserve_block = 256 << 10, reserve_blocks = 4, solids_a_reserve_block = 64;

}  // namespace meniscus::collision::bullet_tuning
