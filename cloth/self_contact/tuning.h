// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of contacts of cloth with cloth: symbol or name, unit, why this value, and the test
// that notices.
#pragma once

#include <cstdint>

namespace meniscus::cloth::self_contact_tuning {

// ---- contacts ----

/// Sweeps an iteration. Contacts need more sweeps than the cloth that they hold apart.
/// Test: SelfContactTest.AFoldedSheetKeepsItsLayersApart.
inline constexpr int sweeps = 2;

/// s, in which an overlap is opened by one thickness. At once, overlapping cloth would be thrown apart.
/// Test: SelfContactTest.OverlapIsOpenedSlowly.
inline constexpr float separation_time = 0.02f;

/// Thicknesses: two features beyond this distance are apart. The margin keeps contacts that rest just beyond
/// one thickness.
/// Test: SelfContactTest.AFoldedSheetKeepsItsLayersApart.
inline constexpr float reach = 1.1f;

/// Thicknesses: a pair further apart than the distance to keep and this margin is no contact.
/// Test: none.
inline constexpr float margin = 0.1f;

/// Of the thickness or the least height, whichever is less: half of the distance below which any pair is a
/// contact. Pairs on either side of a border would otherwise be missed there.
/// Test: SelfContactTest.NothingGoesThroughHoweverFast.
inline constexpr float nearness = 0.3f;

/// Of the distance at the start: a pair with at least this relative motion may meet, so the time of nearness
/// is computed.
/// Test: SelfContactTest.NothingGoesThroughHoweverFast.
inline constexpr float fast = 0.5f;

/// The same, of the distance at the end, for the quick test. A pair that is fast by the start has at least a
/// third; the rest is room for rounding.
/// Test: SelfContactTest.NothingGoesThroughHoweverFast.
inline constexpr float fast_by_end = 0.3f;

/// Of the distance at the start, or of the thickness if that is less: two features that come this near have
/// met. Nearer, the normal would be less certain.
/// Test: SelfContactTest.NothingGoesThroughHoweverFast.
inline constexpr float meeting = 0.5f;

/// Nearnesses: a fast pair that starts nearer than this is a contact. It may come within the nearness by the
/// solve.
/// Test: none.
inline constexpr float near_when_fast = 1.8f;

/// Thicknesses: features nearer than this have no direction in which to part.
/// Test: none.
inline constexpr float coincident = 1e-5f;

/// Of their distance at rest: what features of one part keep at most. Features that are nearer than the
/// thickness at rest, as in a fine mesh, are not pushed apart.
/// Test: SelfContactTest.AMeshFinerThanItsThicknessStaysAtRest.
inline constexpr float kept_of_rest = 0.7f;

// ---- how long candidates last ----

/// Of a vertex's displacement, and of how far the last solve moved it: the room in its motion bound for this
/// solve. Less room repeats steps, and more lists pairs in vain.
/// Test: SelfContactTest.NothingGoesThroughLargeSheets.
inline constexpr float room_of_motion = 0.25f, room_of_strayed = 1.5f;

/// Substeps that a search may last. Cloth at rest could last longer, but a search is cheap then.
/// Test: SelfContactTest.PairsAreLookedForAsOftenAsClothMoves.
inline constexpr float longest = 16;

/// Thicknesses: the greatest motion that a bound covers, if it covers more than this substep. The balls of
/// neighbouring vertices must not overlap, or all of a rough sheet would be listed.
/// Test: SelfContactTest.PairsOfFastClothAreLookedForForASubstepAlone.
inline constexpr float furthest = 0.5f;

/// Thicknesses: room in a bound for other motions than the present one. Larger bounds make searches rarer and
/// candidates more numerous, and took longer in all.
/// Test: SelfContactTest.PairsAreLookedForAsOftenAsClothMoves.
inline constexpr float leeway = 0.25f;

/// Times the room for the motion by the solve: what a bound adds to it, as vertices move to and fro.
/// Test: none.
inline constexpr float to_and_fro = 1.5f;

// ---- frames ----

/// Thicknesses in a substep: pieces whose motions differ by less share a frame. A step in which pieces in
/// different frames touch is repeated, so those that fall together should share one. Larger cells give pieces
/// a frame in which they move faster.
/// Test: SelfContactTest.PartsThatMoveApartCostNoMore.
inline constexpr float frame_cell = 4;

/// The most frames. Pieces in further ones share with others.
/// Test: none.
inline constexpr uint32_t most_frames = 64;

// ---- smooth sheets ----

/// rad: the widest angle from a group's axis to any normal around it, in a smooth sheet. With the leeway
/// below it stays less than a right angle.
/// Test: SelfContactTest.AFoldedSheetKeepsItsLayersApart.
inline constexpr float widest_cone = 1.3f;

/// rad: how much further normals may turn until the next search.
/// Test: SelfContactTest.AFoldedSheetKeepsItsLayersApart.
inline constexpr float cone_leeway = 0.13f;

/// Thicknesses: a group whose angle times its longest edge exceeds this is rough. Its box does not resemble
/// it, and its triangles are tested one by one.
/// Test: none.
inline constexpr float rough = 0.2f;

// ---- the fail-safe ----

/// Of the thickness or the least height, whichever is less: no pair may come nearer in a substep. It is far
/// above the rounding of positions, and far below what contacts keep.
/// Test: SelfContactTest.NothingGoesThroughHoweverFast.
inline constexpr float least_distance = 0.02f;

/// Of the least distance: a pair that is already nearer than this is nearly lost, and its zone stops.
/// Test: SelfContactSlowTest.NothingEverGoesThrough.
inline constexpr float nearly_lost = 0.1f;

/// Of the present distance: the gap that a pair which is nearly lost must keep, and that one near the least
/// distance must keep.
/// Test: SelfContactSlowTest.NothingEverGoesThrough.
inline constexpr float lost_gap = 0.5f, gap = 0.9f;

/// Of a coordinate: a motion up to this size may come from the rounding of a zone's motion.
/// Test: SelfContactSlowTest.NothingEverGoesThrough.
inline constexpr float rounding = 1e-6f;

/// Of the radius of a motion bound: zones stay within this, so that rounding does not carry them out.
/// Test: none.
inline constexpr float within = 0.999f;

/// Contact radii: no zone takes a vertex nearer than that to an immovable solid. Contacts of the next substep
/// still find it outside.
/// Test: ClothMeetings.ABodyTakesItsAttachmentsThroughClothThatIsHeldFast.
inline constexpr float least_to_solid = 0.25f;

/// Rounds of the fail-safe in a step after a quiet one, and rounds beyond those that the last step used. A
/// superfluous round costs little, but too few repeat the step.
/// Test: none.
inline constexpr uint32_t first_rounds = 2, spare_rounds = 2;

}  // namespace meniscus::cloth::self_contact_tuning
