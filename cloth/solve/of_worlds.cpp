// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Repeats the constraints of one world for all worlds of a batch.
#include "cloth/solve/of_worlds.h"

#include "pbd/repeated.h"

namespace meniscus::cloth {

namespace {

void shift(EdgeConstraint& e, uint32_t by) {
  e.a += by;
  e.b += by;
}

template <class Four>
void shift_four(Four& h, uint32_t by) {
  for (uint32_t* v : {&h.a, &h.b, &h.c, &h.d}) *v += by;
}

template <class T, class Shift>
std::vector<T> shifted(const std::vector<T>& one, uint32_t worlds, uint32_t each, const Shift& shift) {
  return pbd::repeated(std::span<const T>(one), worlds,
                       [&](T& value, uint32_t w) { shift(value, w * each); });
}

uint32_t size_of(const auto& values) {
  return static_cast<uint32_t>(values.size());
}

/// The items between two starts, of all worlds, for each two starts.
template <class T, class Shift>
std::vector<T> shifted_by_part(const std::vector<T>& one, const std::vector<uint32_t>& starts,
                               uint32_t worlds, const Shift& shift) {
  std::vector<T> all;
  for (size_t part = 0; part + 1 < starts.size(); ++part) {
    for (uint32_t w = 0; w < worlds; ++w) {
      for (uint32_t k = starts[part]; k < starts[part + 1]; ++k) {
        all.push_back(one[k]);
        shift(all.back(), w);
      }
    }
  }
  return all;
}

std::vector<uint32_t> times(std::vector<uint32_t> starts, uint32_t worlds) {
  for (uint32_t& start : starts) start *= worlds;
  return starts;
}

}  // namespace

ClothModel of_worlds(const ClothModel& one, uint32_t worlds) {
  const uint32_t vertices = size_of(one.rest), pieces = size_of(one.pieces);
  const auto add = [](uint32_t& number, uint32_t by) { number += by; };
  ClothModel all;
  all.constraints.masses = pbd::repeated(std::span<const float>(one.constraints.masses), worlds);
  all.constraints.isometric =
      shifted(one.constraints.isometric, worlds, vertices, shift_four<IsometricConstraint>);
  all.tethers = shifted(one.tethers, worlds, vertices, [](Tether& t, uint32_t by) {
    t.vertex += by;
    t.anchor += by;
  });
  all.triangles = pbd::repeated(std::span<const pbd::SurfaceTriangle>(one.triangles), worlds,
                                [&](pbd::SurfaceTriangle& t, uint32_t w) {
                                  t = pbd::SurfaceWorlds{worlds, vertices, pieces}.of(w, t);
                                });
  all.rest = pbd::repeated(std::span<const Vec3>(one.rest), worlds);
  all.pieces = shifted(one.pieces, worlds, vertices, [](Piece& p, uint32_t by) {
    p.first_vertex += by;
    p.end_vertex += by;
  });
  all.held = shifted(one.held, worlds, vertices, add);
  return all;
}

Chains of_worlds(const Chains& one, uint32_t vertices, uint32_t worlds) {
  Chains all;
  all.edges = shifted(one.edges, worlds, vertices, shift);
  all.layer_starts = times(one.layer_starts, worlds);
  for (const Chain& chain : one.chains) {
    for (uint32_t w = 0; w < worlds; ++w)
      all.chains.push_back({chain.first + w * size_of(one.edges), chain.count});
  }
  return all;
}

Clusters of_worlds(const Clusters& one, uint32_t vertices, uint32_t worlds) {
  const uint32_t hinges = size_of(one.hinges), strains = size_of(one.strains), edges = size_of(one.edges),
                 batches = size_of(one.batches), numbers = size_of(one.vertices);
  Clusters all;
  all.hinges = shifted(one.hinges, worlds, vertices, shift_four<HingeConstraint>);
  all.strains = shifted(one.strains, worlds, vertices, [](StrainConstraint& s, uint32_t by) {
    for (uint32_t* v : {&s.a, &s.b, &s.c}) *v += by;
  });
  all.batches = pbd::repeated(std::span<const Batch>(one.batches), worlds, [&](Batch& b, uint32_t w) {
    b.first += w * (b.kind == ConstraintKind::hinge    ? hinges
                    : b.kind == ConstraintKind::strain ? strains
                                                       : edges);
  });
  all.clusters = shifted_by_part(one.clusters, one.pass_starts, worlds, [&](Cluster& c, uint32_t w) {
    c.first_batch += w * batches;
    c.end_batch += w * batches;
    c.first_vertex += w * numbers;
    c.end_vertex += w * numbers;
    c.first_item += w * edges;
    c.end_item += w * edges;
  });
  all.pass_starts = times(one.pass_starts, worlds);
  all.bending_passes = one.bending_passes;
  all.vertices = shifted(one.vertices, worlds, vertices, [](uint32_t& v, uint32_t by) { v += by; });
  all.colour_starts = times(one.colour_starts, worlds);
  all.edges = one.colour_starts.empty()
                  ? shifted(one.edges, worlds, vertices, shift)
                  : shifted_by_part(one.edges, one.colour_starts, worlds,
                                    [&](EdgeConstraint& e, uint32_t w) { shift(e, w * vertices); });
  return all;
}

std::vector<uint32_t> places_by_world(const std::vector<uint32_t>& colour_starts, uint32_t worlds) {
  std::vector<uint32_t> places;
  for (uint32_t w = 0; w < worlds; ++w) {
    for (size_t c = 0; c + 1 < colour_starts.size(); ++c) {
      const uint32_t first = colour_starts[c], count = colour_starts[c + 1] - first;
      for (uint32_t k = 0; k < count; ++k) places.push_back(worlds * first + w * count + k);
    }
  }
  return places;
}

}  // namespace meniscus::cloth
