// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "cloth/chains.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

#include "cloth/incidence.h"

namespace meniscus::cloth {

namespace {

constexpr uint32_t none = 0xffffffff;

class ChainColouring {
 public:
  ChainColouring(const std::vector<EdgeConstraint>& edges, const Incidence& around)
      : edges_(edges), around_(around), colours_(edges.size(), none) {}

  std::vector<uint32_t> run() {
    for (uint32_t v = 0; v + 1 < around_.starts.size(); ++v)
      if (around_.at(v).size() == 1) walk(v);
    for (const EdgeConstraint& e : edges_) walk(e.a);  // the rings are left
    return colours_;
  }

 private:
  /// Along edges without a colour, from one end.
  void walk(uint32_t v) {
    for (uint32_t k; (k = uncoloured(v)) != none;) {
      const uint32_t next = edges_[k].a == v ? edges_[k].b : edges_[k].a;
      colours_[k] = free_colour(v, next);
      v = next;
    }
  }
  uint32_t uncoloured(uint32_t v) const {
    for (uint32_t k : around_.at(v))
      if (colours_[k] == none) return k;
    return none;
  }
  uint32_t free_colour(uint32_t v, uint32_t w) const {
    uint32_t taken = 0;
    for (uint32_t end : {v, w})
      for (uint32_t k : around_.at(end))
        if (colours_[k] != none) taken |= 1u << colours_[k];
    return taken & 1 ? (taken & 2 ? 2 : 1) : 0;
  }

  const std::vector<EdgeConstraint>& edges_;
  const Incidence& around_;
  std::vector<uint32_t> colours_;
};

}  // namespace

Coloured<EdgeConstraint> take_chains(ClothConstraints& constraints, size_t vertices) {
  std::vector<EdgeConstraint> edges = constraints.edges.items;
  // Those of one colour go through memory in order.
  std::sort(edges.begin(), edges.end(), [](const EdgeConstraint& e, const EdgeConstraint& f) {
    return std::tuple(e.a, e.b) < std::tuple(f.a, f.b);
  });
  std::vector<std::array<uint32_t, 2>> ends;
  for (const EdgeConstraint& e : edges) ends.push_back({e.a, e.b});
  const Incidence around(std::span<const std::array<uint32_t, 2>>(ends), static_cast<uint32_t>(vertices));
  if (around.most_at_a_vertex() > 2) return {};
  constraints.edges = {};
  return sorted_by_colour(std::span<const EdgeConstraint>(edges), ChainColouring(edges, around).run());
}

}  // namespace meniscus::cloth
