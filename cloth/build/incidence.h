// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The constraints at each vertex, as CSR adjacency.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace meniscus::cloth {

/// The vertices of each constraint.
template <size_t Arity>
using Corners = std::span<const std::array<uint32_t, Arity>>;

/// The constraints at each vertex.
struct Incidence {
  std::vector<uint32_t> starts, constraints;

  template <size_t Arity>
  Incidence(Corners<Arity> corners, uint32_t vertex_count) : starts(vertex_count + 1, 0) {
    for (const auto& c : corners) {
      for (uint32_t v : c) ++starts[v + 1];
    }
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    constraints.resize(starts.back());
    std::vector<uint32_t> next(starts.begin(), starts.end() - 1);
    for (uint32_t i = 0; i < corners.size(); ++i) {
      for (uint32_t v : corners[i]) constraints[next[v]++] = i;
    }
  }

  std::span<const uint32_t> at(uint32_t vertex) const {
    return std::span(constraints).subspan(starts[vertex], starts[vertex + 1] - starts[vertex]);
  }
  /// The greatest number of constraints at a vertex: a lower bound on the number of colours.
  uint32_t most_at_a_vertex() const {
    uint32_t most = 0;
    for (size_t v = 0; v + 1 < starts.size(); ++v) most = std::max(most, starts[v + 1] - starts[v]);
    return most;
  }
};

}  // namespace meniscus::cloth
