// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Chains that are solved side by side in SIMD lanes, and the working memory of a solve.
#pragma once

#include "cloth/build/chains.h"
#include "cloth/solve/tridiagonal.h"
#include "pbd/device/scalar.h"

namespace meniscus::cloth {

using pbd::gather;
using pbd::less_mask;
using pbd::select_less;

/// Chains that are solved side by side, as many as D::Real has lanes. Shorter chains wait at their ends for
/// the longest.
template <class D>
struct ChainsAtOnce {
  using Real = typename D::Real;
  static constexpr uint32_t lanes = D::lane_count;

  uint32_t first[lanes], count[lanes];
  uint32_t most = 0;  ///< the number of edges of the longest
  Real edges;

  /// The chains from chains[begin] to chains[end − 1].
  MENISCUS_HD ChainsAtOnce(pbd::View<const Chain> chains, uint32_t begin, uint32_t end) {
    for (uint32_t lane = 0; lane < lanes; ++lane) {
      const bool there = begin + lane < end;
      const Chain chain = chains[there ? begin + lane : begin];
      first[lane] = chain.first;
      count[lane] = there ? chain.count : 0;
      most = count[lane] > most ? count[lane] : most;
    }
    edges = pbd::by_lane<D>([&](uint32_t lane) { return static_cast<float>(count[lane]); });
  }

  /// Where edge k of each chain is; for a chain without an edge k, the place of another edge.
  MENISCUS_HD pbd::Places<D> edge(uint32_t k) const {
    pbd::Places<D> places;
    for (uint32_t lane = 0; lane < lanes; ++lane) places.at[lane] = first[lane] + (k < count[lane] ? k : 0);
    return places;
  }
  /// Bits of the chains that have an edge k.
  MENISCUS_HD uint32_t have_edge(uint32_t k) const { return less_mask(number(k), edges); }
  /// x for chains that have an edge k, 0 for others.
  MENISCUS_HD Real if_edge(uint32_t k, const Real& x) const {
    return select_less(number(k), edges, x, Real(0));
  }

 private:
  MENISCUS_HD static Real number(uint32_t k) { return Real(static_cast<float>(k)); }
};

/// Working memory of the solve. Each edge has n, its multiplier λ, |λ|/l and l; one edge that does not exist
/// stands before the first and one after the last. Each vertex has w and the push on it. The rows of a system
/// follow, with the rows that a group of threads reduces them to.
template <class Group>
struct ChainScratch {
  using Real = typename Group::Device::Real;
  using Length = TridiagonalRow<Real>;
  using Lateral = TridiagonalRow<Real, pbd::Vec3Of<Real>>;

  struct alignas(alignof(Real) > 16 ? alignof(Real) : 16) Edge {
    pbd::Vec3Of<Real> n;
    Real lambda;
  };

  Edge edges[Chain::most_edges + 2];
  Real stiffness[Chain::most_edges + 2], rest_length[Chain::most_edges + 2];
  Real weight[Chain::most_edges + 1];
  Chain chain;                                                        ///< the only chain
  uint32_t vertex[Group::is_one_thread ? 1 : Chain::most_edges + 1];  ///< its vertices
  pbd::Vec3Of<Real> push[Chain::most_edges + 1];
  struct alignas(64) {
    unsigned char bytes[(Chain::most_edges + 1) * sizeof(Lateral)];
  } rows[Group::is_one_thread ? 1 : 2];

  template <class Row>
  MENISCUS_HD Row* first_rows() {
    return reinterpret_cast<Row*>(rows[0].bytes);
  }
  template <class Row>
  MENISCUS_HD Row* other_rows() {
    return reinterpret_cast<Row*>(rows[Group::is_one_thread ? 0 : 1].bytes);
  }
};

/// The greatest of value(k) for k < count, or 1 if that is greater. `kept` has room for as many values.
/// Groups of several threads use it.
template <class Group, class Real, class Value>
MENISCUS_HD Real greatest_from_one(const Group& group, Real* kept, uint32_t count, const Value& value) {
  using pbd::max;
  Real most(1);
  if constexpr (Group::is_one_thread) {
    for (uint32_t k = 0; k < count; ++k) most = max(most, value(k));
  } else {
    // Values above 1 are rare.
    const bool found = group.any(count, [&](uint32_t k) { return most < (kept[k] = value(k)); });
    if (!found) return most;
    while (count > 1) {
      const uint32_t half = (count + 1) / 2;
      group.for_each(count - half, [=](uint32_t k) { kept[k] = max(kept[k], kept[half + k]); });
      count = half;
    }
    most = max(most, kept[0]);
  }
  return most;
}

}  // namespace meniscus::cloth
