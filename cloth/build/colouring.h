// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace meniscus::cloth {

/// A colour for each constraint, so that no two of a colour share a vertex: colours are 0, 1, 2, … without
/// gaps, as few as greedy colouring and the moves of a few constraints at a time get along with, and about
/// equally many constraints in each. The same input gives the same colours. `Arity` vertices a constraint,
/// all different and below `vertex_count`.
template <size_t Arity>
std::vector<uint32_t> colour_constraints(std::span<const std::array<uint32_t, Arity>> constraints,
                                         uint32_t vertex_count);

/// Shares out colours that have but few edges, and evens out the others: for a colouring that has grown.
void improve_colours(std::span<const std::array<uint32_t, 2>> edges, uint32_t vertex_count,
                     std::vector<uint32_t>& colours);

}  // namespace meniscus::cloth
