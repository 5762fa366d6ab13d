// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Merges the constraints of several pieces, and adds seams.
#include "cloth/build/merge.h"

#include <meniscus/error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <unordered_map>

#include "cloth/build/colouring.h"

namespace meniscus::cloth {

namespace {

void shift(EdgeConstraint& e, uint32_t by) {
  e.a += by;
  e.b += by;
}
void shift(StrainConstraint& s, uint32_t by) {
  s.a += by;
  s.b += by;
  s.c += by;
}
void shift(HingeConstraint& h, uint32_t by) {
  h.a += by;
  h.b += by;
  h.c += by;
  h.d += by;
}
void shift(IsometricConstraint& h, uint32_t by) {
  h.a += by;
  h.b += by;
  h.c += by;
  h.d += by;
}

// Joins the constraints of one kind of all pieces. `kind` is the member that holds them.
template <class Constraint>
Coloured<Constraint> joined(std::span<const ClothConstraints> pieces, std::span<const uint32_t> first_vertex,
                            Coloured<Constraint> ClothConstraints::*kind) {
  Coloured<Constraint> all;
  uint32_t colours = 0;
  for (const ClothConstraints& piece : pieces) colours = std::max(colours, (piece.*kind).colours());
  for (uint32_t c = 0; c < colours; ++c) {
    for (size_t p = 0; p < pieces.size(); ++p) {
      const Coloured<Constraint>& self = pieces[p].*kind;
      if (c >= self.colours()) continue;
      for (uint32_t i = self.colour_starts[c]; i < self.colour_starts[c + 1]; ++i) {
        all.items.push_back(self.items[i]);
        shift(all.items.back(), first_vertex[p]);
      }
    }
    all.colour_starts.push_back(static_cast<uint32_t>(all.items.size()));
  }
  return all;
}

void check_seam(const EdgeConstraint& seam, size_t number, size_t vertices) {
  const auto refuse = [&](const std::string& why) {
    throw Error(ErrorCode::invalid_argument, "seam " + std::to_string(number) + " " + why);
  };
  for (uint32_t v : {seam.a, seam.b}) {
    if (v < vertices) continue;
    refuse("has the vertex " + std::to_string(v) + ", but there are " + std::to_string(vertices));
  }
  if (seam.a == seam.b) refuse("has vertex " + std::to_string(seam.a) + " at both ends");
  if (!std::isfinite(seam.rest_length) || seam.rest_length < 0) {
    refuse("has a length of " + std::to_string(seam.rest_length) + "; it must be finite and ≥ 0");
  }
  if (!std::isfinite(seam.compliance) || seam.compliance < 0) {
    refuse("has a compliance of " + std::to_string(seam.compliance) + "; it must be finite and ≥ 0");
  }
}

using ColoursAt = std::unordered_map<uint32_t, std::vector<bool>>;  // by vertex with seams

bool has(const std::vector<bool>& colours, uint32_t c) {
  return c < colours.size() && colours[c];
}

void note(std::vector<bool>& colours, uint32_t c) {
  if (c >= colours.size()) colours.resize(c + 1);
  colours[c] = true;
}

ColoursAt colours_at_ends(std::span<const EdgeConstraint> seams, std::span<const EdgeConstraint> edges,
                          std::span<const uint32_t> colours) {
  ColoursAt at;
  for (const EdgeConstraint& seam : seams) {
    at[seam.a];
    at[seam.b];
  }
  for (size_t i = 0; i < edges.size(); ++i) {
    for (uint32_t v : {edges[i].a, edges[i].b}) {
      if (const auto end = at.find(v); end != at.end()) note(end->second, colours[i]);
    }
  }
  return at;
}

std::vector<uint32_t> colours_of(const Coloured<EdgeConstraint>& edges) {
  std::vector<uint32_t> colours(edges.items.size());
  for (uint32_t c = 0; c < edges.colours(); ++c) {
    std::fill(colours.begin() + edges.colour_starts[c], colours.begin() + edges.colour_starts[c + 1], c);
  }
  return colours;
}

}  // namespace

ClothConstraints merge(std::span<const ClothConstraints> pieces) {
  ClothConstraints all;
  std::vector<uint32_t> first_vertex;
  for (const ClothConstraints& piece : pieces) {
    first_vertex.push_back(static_cast<uint32_t>(all.masses.size()));
    all.masses.insert(all.masses.end(), piece.masses.begin(), piece.masses.end());
  }
  all.edges = joined(pieces, first_vertex, &ClothConstraints::edges);
  all.strains = joined(pieces, first_vertex, &ClothConstraints::strains);
  all.hinges = joined(pieces, first_vertex, &ClothConstraints::hinges);
  for (size_t p = 0; p < pieces.size(); ++p) {
    for (IsometricConstraint hinge : pieces[p].isometric) {
      shift(hinge, first_vertex[p]);
      all.isometric.push_back(hinge);
    }
  }
  return all;
}

void add_seams(ClothConstraints& all, std::span<const EdgeConstraint> seams) {
  if (seams.empty()) return;
  for (size_t i = 0; i < seams.size(); ++i) check_seam(seams[i], i, all.masses.size());
  std::vector<EdgeConstraint> edges = all.edges.items;
  std::vector<uint32_t> colours = colours_of(all.edges);
  ColoursAt at = colours_at_ends(seams, edges, colours);
  for (const EdgeConstraint& seam : seams) {
    std::vector<bool>&a = at[seam.a], &b = at[seam.b];
    uint32_t colour = 0;
    while (has(a, colour) || has(b, colour)) ++colour;
    note(a, colour);
    note(b, colour);
    edges.push_back(seam);
    colours.push_back(colour);
  }
  std::vector<std::array<uint32_t, 2>> ends(edges.size());
  for (size_t i = 0; i < ends.size(); ++i) ends[i] = {edges[i].a, edges[i].b};
  const std::span<const std::array<uint32_t, 2>> view = ends;
  improve_colours(view, static_cast<uint32_t>(all.masses.size()), colours);
  all.edges = sorted_by_colour<EdgeConstraint>(edges, colours);
}

}  // namespace meniscus::cloth
