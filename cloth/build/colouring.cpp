// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Greedy colouring of constraints, with an improvement step after it.
#include "cloth/build/colouring.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "cloth/build/incidence.h"
#include "cloth/build/recolouring.h"
#include "cloth/build/topology.h"
#include "cloth/build/tuning.h"

namespace meniscus::cloth {

namespace {

/// Gives each constraint in turn the first colour that no constraint at its vertices has.
template <size_t Arity>
std::vector<uint32_t> first_fit(Corners<Arity> corners, const Incidence& incidence,
                                std::span<const uint32_t> order) {
  std::vector<uint32_t> colours(corners.size(), none);
  std::vector<uint32_t> taken_by;  // by colour: the last constraint that could not have it
  for (uint32_t i : order) {
    for (uint32_t v : corners[i]) {
      for (uint32_t other : incidence.at(v)) {
        if (colours[other] != none) taken_by[colours[other]] = i;
      }
    }
    uint32_t colour = 0;
    while (colour < taken_by.size() && taken_by[colour] == i) ++colour;
    if (colour == taken_by.size()) taken_by.push_back(none);
    colours[i] = colour;
  }
  return colours;
}

/// Numbers vertices breadth-first, part by part.
template <size_t Arity>
std::vector<uint32_t> breadth_first_ranks(Corners<Arity> corners, const Incidence& incidence) {
  const size_t vertices = incidence.starts.size() - 1;
  std::vector<uint32_t> rank(vertices, none), found;
  found.reserve(vertices);
  const auto find = [&](uint32_t v) {
    if (rank[v] != none) return;
    rank[v] = static_cast<uint32_t>(found.size());
    found.push_back(v);
  };
  size_t next = 0;
  for (uint32_t seed = 0; seed < vertices; ++seed) {
    find(seed);
    for (; next < found.size(); ++next) {
      for (uint32_t i : incidence.at(found[next])) std::for_each(corners[i].begin(), corners[i].end(), find);
    }
  }
  return rank;
}

/// Orders constraints as a front meets them that spreads over the surface.
template <size_t Arity>
std::vector<uint32_t> spreading_order(Corners<Arity> corners, const Incidence& incidence) {
  const std::vector<uint32_t> rank = breadth_first_ranks(corners, incidence);
  std::vector<std::pair<std::array<uint32_t, Arity>, uint32_t>> keyed(corners.size());
  for (uint32_t i = 0; i < corners.size(); ++i) {
    auto& [key, constraint] = keyed[i];
    std::transform(corners[i].begin(), corners[i].end(), key.begin(), [&](uint32_t v) { return rank[v]; });
    std::sort(key.begin(), key.end());
    constraint = i;
  }
  std::sort(keyed.begin(), keyed.end());
  std::vector<uint32_t> order(corners.size());
  for (size_t k = 0; k < order.size(); ++k) order[k] = keyed[k].second;
  return order;
}

template <size_t Arity>
void improve(Corners<Arity> corners, const Incidence& incidence, std::vector<uint32_t>& colours) {
  if (count_of(colours) > Recolouring<Arity>::most_colours) return;
  Recolouring<Arity> recolouring(corners, incidence, colours);
  recolouring.dissolve_small_colours();
  recolouring.balance();
}

}  // namespace

template <size_t Arity>
std::vector<uint32_t> colour_constraints(Corners<Arity> constraints, uint32_t vertex_count) {
  if (constraints.empty()) return {};
  const Incidence incidence(constraints, vertex_count);
  std::vector<uint32_t> order(constraints.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<uint32_t> colours = first_fit<Arity>(constraints, incidence, order);
  // Meshes numbered along rows get few colours in their own order; other meshes do not.
  if (colouring_tuning::accepted_under * count_of(colours) >
      colouring_tuning::accepted_over * incidence.most_at_a_vertex()) {
    order = spreading_order<Arity>(constraints, incidence);
    std::vector<uint32_t> other = first_fit<Arity>(constraints, incidence, order);
    if (count_of(other) < count_of(colours)) colours = std::move(other);
  }
  improve<Arity>(constraints, incidence, colours);
  return colours;
}

void improve_colours(Corners<2> edges, uint32_t vertex_count, std::vector<uint32_t>& colours) {
  if (!edges.empty()) improve<2>(edges, Incidence(edges, vertex_count), colours);
}

template std::vector<uint32_t> colour_constraints<2>(Corners<2>, uint32_t);
template std::vector<uint32_t> colour_constraints<3>(Corners<3>, uint32_t);
template std::vector<uint32_t> colour_constraints<4>(Corners<4>, uint32_t);

}  // namespace meniscus::cloth
