// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Selects the edges that form chains, and colours the edges that remain.
#include "cloth/build/chains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <numeric>

#include "cloth/build/colouring.h"
#include "cloth/build/incidence.h"
#include "cloth/build/tuning.h"
#include "pbd/device/scalar.h"

namespace meniscus::cloth {

namespace {

constexpr uint32_t none = 0xffffffff;

using Ends = std::array<uint32_t, 2>;

/// Selects chains, one layer after the other, from the edges that remain.
class Drawing {
 public:
  Drawing(std::span<const EdgeConstraint> edges, std::span<const Vec3> rest, std::span<const Piece> pieces)
      : edges_(edges),
        rest_(rest),
        ends_(ends_of(edges)),
        around_(std::span<const Ends>(ends_), static_cast<uint32_t>(rest.size())),
        left_(edges.size()) {
    const std::vector<bool> is_stiff = stiff_edges(), in_grain = vertices_in_grain(is_stiff, pieces);
    for (uint32_t k = 0; k < edges.size(); ++k) {
      const EdgeConstraint& e = edges[k];
      // A seam is not an edge of the mesh at rest.
      const float length_at_rest = length(rest[e.b] - rest[e.a]);
      left_[k] = (is_stiff[k] || !in_grain[e.a]) &&
                 std::fabs(length_at_rest - e.rest_length) <= chain_tuning::same_length * e.rest_length &&
                 !has_none(e.a, pieces);
    }
  }

  /// Selects chains that share no vertex. Each is a list of edges, with their ends in order.
  std::vector<std::vector<EdgeConstraint>> layer() {
    taken_.assign(rest_.size(), false);
    std::vector<std::vector<EdgeConstraint>> chains;
    for (uint32_t seed = 0; seed < rest_.size(); ++seed) {
      visit(seed, {0, 0, 0}, chains);
      while (!front_.empty()) {
        const auto [v, along] = front_.front();
        front_.pop_front();
        visit(v, along, chains);
      }
    }
    return chains;
  }

  bool left(uint32_t edge) const { return left_[edge]; }

 private:
  static std::vector<Ends> ends_of(std::span<const EdgeConstraint> edges) {
    std::vector<Ends> ends;
    for (const EdgeConstraint& e : edges) ends.push_back({e.a, e.b});
    return ends;
  }

  std::vector<bool> stiff_edges() const {
    std::vector<float> least(rest_.size(), pbd::most_finite);
    for (const EdgeConstraint& e : edges_) {
      for (uint32_t v : {e.a, e.b}) least[v] = std::min(least[v], e.compliance);
    }
    std::vector<bool> is_stiff;
    for (const EdgeConstraint& e : edges_)
      is_stiff.push_back(e.compliance <= chain_tuning::much_softer *
                                             std::max(chain_tuning::stiff, std::min(least[e.a], least[e.b])));
    return is_stiff;
  }

  /// Marks the vertices of pieces with a grain. Their stiff edges are the warp and the weft: two of three.
  std::vector<bool> vertices_in_grain(const std::vector<bool>& is_stiff,
                                      std::span<const Piece> pieces) const {
    std::vector<uint32_t> edges_from(rest_.size()), stiff_from(rest_.size());
    for (uint32_t k = 0; k < edges_.size(); ++k) {
      ++edges_from[edges_[k].a];
      stiff_from[edges_[k].a] += is_stiff[k];
    }
    std::vector<bool> in_grain(rest_.size(), true);
    for (const Piece& p : pieces) {
      const auto sum = [&](const std::vector<uint32_t>& each) {
        return std::accumulate(each.begin() + p.first_vertex, each.begin() + p.end_vertex, 0u);
      };
      std::fill(in_grain.begin() + p.first_vertex, in_grain.begin() + p.end_vertex,
                sum(stiff_from) > chain_tuning::fraction_of_grain * static_cast<float>(sum(edges_from)));
    }
    return in_grain;
  }

  /// Whether the piece of v has no chains, see draw_chains.
  static bool has_none(uint32_t v, std::span<const Piece> pieces) {
    return std::any_of(pieces.begin(), pieces.end(), [&](const Piece& p) {
      return (p.inside > 0 || p.tear_strain > 0) && v >= p.first_vertex && v < p.end_vertex;
    });
  }

  uint32_t other_end(uint32_t edge, uint32_t v) const {
    return edges_[edge].a == v ? edges_[edge].b : edges_[edge].a;
  }
  Vec3 direction(uint32_t edge, uint32_t from) const {
    return normalized_or(rest_[other_end(edge, from)] - rest_[from], {0, 0, 0});
  }

  /// Selects a chain through v along this direction and its reverse. A direction of 0 stands for that of v's
  /// first remaining edge.
  void visit(uint32_t v, Vec3 along, std::vector<std::vector<EdgeConstraint>>& chains) {
    if (taken_[v]) return;
    if (dot(along, along) == 0) {
      for (uint32_t k : around_.at(v)) {
        if (!left_[k]) continue;
        along = direction(k, v);
        break;
      }
      if (dot(along, along) == 0) return;
    }
    std::vector<uint32_t> forth = follow(v, along), back = follow(v, -along);
    if (forth.size() + back.size() == 0) return;
    taken_[v] = true;
    std::vector<uint32_t> path(back.rbegin(), back.rend()), vertices;
    path.insert(path.end(), forth.begin(), forth.end());
    uint32_t at = v;
    for (uint32_t k : back) at = other_end(k, at);
    std::vector<EdgeConstraint> chain;
    for (uint32_t k : path) {
      const uint32_t next = other_end(k, at);
      chain.push_back({at, next, edges_[k].rest_length, edges_[k].compliance});
      look_around(at, direction(k, at));
      at = next;
    }
    look_around(at, -direction(path.back(), at));
    for_each_part(path.size(), [&](size_t first, size_t count) {
      if (count < Chain::fewest_edges) return;
      for (size_t k = first; k < first + count; ++k) left_[path[k]] = false;
      chains.emplace_back(chain.begin() + static_cast<std::ptrdiff_t>(first),
                          chain.begin() + static_cast<std::ptrdiff_t>(first + count));
    });
  }

  /// Cuts chains that are too long. The edge at a cut is left out, so that the parts share no vertex.
  template <class Part>
  static void for_each_part(size_t count, const Part& part) {
    const size_t parts = (count + 1 + Chain::most_edges) / (Chain::most_edges + 1);
    for (size_t p = 0, first = 0; p < parts; ++p) {
      const size_t end = (count + 1) * (p + 1) / parts - 1;
      part(first, end - first);
      first = end + 1;
    }
  }

  std::vector<uint32_t> follow(uint32_t v, Vec3 along) {
    std::vector<uint32_t> path;
    taken_[v] = true;
    for (;;) {
      uint32_t best = none;
      float cosine = chain_tuning::least_cosine;
      for (uint32_t k : around_.at(v)) {
        if (!left_[k] || taken_[other_end(k, v)]) continue;
        const float c = dot(direction(k, v), along);
        if (c > cosine) {
          cosine = c;
          best = k;
        }
      }
      if (best == none) break;
      along = direction(best, v);
      v = other_end(best, v);
      taken_[v] = true;
      path.push_back(best);
    }
    return path;
  }

  /// Chains beside this one run in the same direction.
  void look_around(uint32_t v, Vec3 along) {
    for (uint32_t k : around_.at(v)) {
      const uint32_t w = other_end(k, v);
      if (!taken_[w]) front_.push_back({w, along});
    }
  }

  struct Visit {
    uint32_t vertex;
    Vec3 along;
  };

  std::span<const EdgeConstraint> edges_;
  std::span<const Vec3> rest_;
  std::vector<Ends> ends_;
  Incidence around_;
  std::vector<bool> left_, taken_;
  std::deque<Visit> front_;
};

/// The edges outside chains, in the order of their vertices and with new colours. Among themselves they need
/// fewer colours; the diagonals of a sheet need two.
Coloured<EdgeConstraint> left_over(std::span<const EdgeConstraint> edges, const std::vector<bool>& stays,
                                   size_t vertices) {
  std::vector<EdgeConstraint> left;
  for (size_t k = 0; k < edges.size(); ++k) {
    if (stays[k]) left.push_back(edges[k]);
  }
  const auto ends = [](const EdgeConstraint& e) { return std::array{e.a, e.b}; };
  std::stable_sort(left.begin(), left.end(), [&](const auto& e, const auto& f) { return ends(e) < ends(f); });
  std::vector<std::array<uint32_t, 2>> corners;
  for (const EdgeConstraint& e : left) corners.push_back(ends(e));
  const std::span<const std::array<uint32_t, 2>> view(corners);
  return sorted_by_colour<EdgeConstraint>(left, colour_constraints(view, static_cast<uint32_t>(vertices)));
}

}  // namespace

Chains draw_chains(ClothConstraints& constraints, std::span<const Vec3> rest, std::span<const Piece> pieces) {
  const std::vector<EdgeConstraint>& edges = constraints.edges.items;
  Drawing drawing(edges, rest, pieces);
  std::vector<bool> stiff(edges.size()), stays(edges.size());
  for (uint32_t k = 0; k < edges.size(); ++k) stiff[k] = drawing.left(k);
  Chains out;
  for (uint32_t layer = 0; layer < chain_tuning::most_layers; ++layer) {
    auto chains = drawing.layer();
    if (chains.empty()) break;
    std::stable_sort(chains.begin(), chains.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
    for (const std::vector<EdgeConstraint>& chain : chains) {
      out.chains.push_back({static_cast<uint32_t>(out.edges.size()), static_cast<uint32_t>(chain.size())});
      out.edges.insert(out.edges.end(), chain.begin(), chain.end());
    }
    out.layer_starts.push_back(static_cast<uint32_t>(out.chains.size()));
  }
  for (uint32_t k = 0; k < edges.size(); ++k) stays[k] = !stiff[k] || drawing.left(k);
  constraints.edges = left_over(edges, stays, rest.size());
  return out;
}

}  // namespace meniscus::cloth
