// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Constraints sorted by colour. Constraints of the same colour share no vertex. So all of them are solved at
// once, and one colour after the other, as Gauss–Seidel requires.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace meniscus::cloth {

/// Constraints sorted by colour. Colour c is items[colour_starts[c]] to items[colour_starts[c + 1] − 1].
template <class Constraint>
struct Coloured {
  std::vector<Constraint> items;
  std::vector<uint32_t> colour_starts{0};  ///< one more than the number of colours

  uint32_t colours() const { return static_cast<uint32_t>(colour_starts.size() - 1); }
};

/// Sorts constraints by colour. Constraints of the same colour keep their order.
template <class Constraint>
Coloured<Constraint> sorted_by_colour(std::span<const Constraint> constraints,
                                      std::span<const uint32_t> colours) {
  Coloured<Constraint> sorted;
  if (constraints.empty()) return sorted;
  sorted.items.resize(constraints.size());
  sorted.colour_starts.assign(*std::max_element(colours.begin(), colours.end()) + 2, 0);
  for (uint32_t c : colours) ++sorted.colour_starts[c + 1];
  std::partial_sum(sorted.colour_starts.begin(), sorted.colour_starts.end(), sorted.colour_starts.begin());
  std::vector<uint32_t> next(sorted.colour_starts.begin(), sorted.colour_starts.end() - 1);
  for (size_t i = 0; i < constraints.size(); ++i) sorted.items[next[colours[i]]++] = constraints[i];
  return sorted;
}

}  // namespace meniscus::cloth
