// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of contacts of fluid with cloth: symbol or name, unit, why this value, and the test
// that notices.
#pragma once

namespace meniscus::collision::fluid_cloth_tuning {

// ---- finding contacts ----

/// The least cosine between the normals of places that are one layer of cloth. Layers that fold over differ
/// by more.
/// Test: FluidOnCloth.DoesNotGoThrough.
inline constexpr float same_layer = 0.7f;

/// Of the distance at the end: a particle with at least this relative motion may have met the triangle. One
/// that meets it has at least a third; the rest is room for rounding.
/// Test: FluidOnCloth.DoesNotGoThrough.
inline constexpr float fast_by_end = 0.3f;

/// Of the distance at the start, or of the radius if that is less: a particle that comes this near has met
/// the triangle. Nearer, the normal would be less certain.
/// Test: FluidOnCloth.DoesNotGoThrough.
inline constexpr float meeting = 0.5f;

/// Of the largest radius: the greatest gap of a meeting, with room for rounding.
/// Test: none.
inline constexpr float largest_gap = 0.51f;

/// The square of the least radius, in support radii, within which the cover of a border is measured.
/// Test: none.
inline constexpr float least_cover2 = 0.01f;

/// The least cosine between the normals of a triangle and of the plane that it covers. A triangle that stands
/// on the plane covers nothing.
/// Test: none.
inline constexpr float covering = 0.5f;

// ---- the vertices that share a contact ----

/// Of the spread's radius: the least radius that is tried near a border, and the ratio of one to the next.
/// Smaller ones have too few vertices.
/// Test: ClothHull.FloatsAsDeepAsArchimedesSays.
inline constexpr float least_spread = 0.4f, next_spread = 0.75f;

/// Of the cube of the sum of weights: the least determinant of the moments. Vertices in a row have none.
/// Test: none.
inline constexpr float least_moments = 1e-4f;

// ---- loads ----

/// Contact radii: a particle nearer than this is about to press. A particle that would stop just before the
/// cloth is pressed against it by the layers behind.
/// Test: FluidAndCloth.RestingWaterHangsFromThePins.
inline constexpr float about_to_press = 1.1f;

/// The greatest tangential component of a particle's weight, over its normal impulse, with which cloth
/// carries it. With less, taut light cloth became unstable.
/// Test: ClothHull.FloatsAsDeepAsArchimedesSays.
inline constexpr float most_drag = 4;

/// Contact radii: a passing particle is clear of cloth at this distance, and one that begins to pass is
/// nearer. The second layer of particles is further away.
/// Test: PermeableCloth.PassesWaterAsAFallingHeadSays.
inline constexpr float clear = 1.5f;

// ---- the fail-safe ----

/// Rounds in which a motion is stopped at another triangle. Each stops nearer to its triangle.
/// Test: FluidOnCloth.DoesNotGoThrough.
inline constexpr int clamp_rounds = 6;

/// Of the distance at the start, and of the radius: a particle that comes nearer than both has passed
/// through. It is far above rounding, and far below what contacts keep.
/// Test: FluidOnCloth.DoesNotGoThrough.
inline constexpr float clamp_gap = 0.5f, clamp_gap_of_radius = 1e-3f;

}  // namespace meniscus::collision::fluid_cloth_tuning
