// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of emitters: symbol or name, unit, why this value, and the test that notices.
#pragma once

namespace meniscus::flow_tuning {

/// Spacings: the least distance of layers and of places. At a smaller distance a particle has no room.
/// Test: EmitterSites.RectanglesOfAnySides.
inline constexpr double closest = 0.7;

/// Added to the number of spacings squared in an opening before it is cut to an integer. With ½, some layers
/// would be closer than `closest`.
/// Test: EmitterSites.DiscsOfAnySize.
inline constexpr double place_rounding = 0.6;

/// What a layer that is too close costs, beside the logarithm of its distance. It is larger than any such
/// logarithm.
/// Test: EmitterSites.RectanglesOfAnySides.
inline constexpr int close_layer_cost = 10;

}  // namespace meniscus::flow_tuning
