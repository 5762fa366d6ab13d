// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Colours for constraints: two constraints of the same colour share no vertex.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace meniscus::cloth {

/// Chooses a colour for each constraint, so that constraints of the same colour share no vertex. Colours are
/// 0, 1, 2, … without gaps. Greedy colouring and moves of a few constraints at a time keep them few. Each has
/// about the same number of constraints. The same input gives the same colours. A constraint has `Arity`
/// vertices, all different and below `vertex_count`.
template <size_t Arity>
std::vector<uint32_t> colour_constraints(std::span<const std::array<uint32_t, Arity>> constraints,
                                         uint32_t vertex_count);

/// Removes colours of few edges, and balances the sizes of the others. For a colouring to which edges were
/// added.
void improve_colours(std::span<const std::array<uint32_t, 2>> edges, uint32_t vertex_count,
                     std::vector<uint32_t>& colours);

}  // namespace meniscus::cloth
