// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Clusters of constraints. The constraints of a cluster touch few vertices, which stay in the cache of a CPU
// core or of a GPU's multiprocessor. The clusters of a pass share no vertex, so that they are solved at once.
// A whole sweep takes a few passes, where colours would take a launch each.
#pragma once

#include <span>

#include "cloth/build/build_constraints.h"

namespace meniscus::cloth {

enum class ConstraintKind : uint32_t { hinge, strain, edge };

/// Constraints of one kind and colour in a cluster: items[first] to items[first + count − 1].
struct Batch {
  ConstraintKind kind;
  uint32_t first, count;
};

/// A cluster has the vertices vertices[first_vertex] to vertices[end_vertex − 1]. Its items are its
/// edges.
struct Cluster {
  uint32_t first_batch, end_batch;
  uint32_t first_vertex, end_vertex;
  uint32_t first_item = 0, end_item = 0;

  static constexpr uint32_t most_vertices = 256;
};

/// The constraints of all cloth, sorted by cluster, kind and colour.
struct Clusters {
  std::vector<HingeConstraint> hinges;
  std::vector<StrainConstraint> strains;
  std::vector<EdgeConstraint> edges;
  std::vector<Batch> batches;            ///< of each cluster, in the order of kinds and of colours
  std::vector<Cluster> clusters;         ///< of each pass
  std::vector<uint32_t> pass_starts{0};  ///< one more than the number of passes
  uint32_t bending_passes = 0;           ///< the first ones
  std::vector<uint32_t> vertices;        ///< of each cluster, ascending
  /// Edges of few colours are in no cluster, if nothing else stretches. Then this holds the first edge of
  /// each colour, and the total. Otherwise it is empty.
  std::vector<uint32_t> colour_starts;
};

/// Passes of bending come before passes of stretch and shear, if there are any. Edges of two colours, such as
/// the diagonals of a sheet, are two passes by themselves and need no clusters. `rest`: m, the vertices at
/// rest.
Clusters build_clusters(const ClothConstraints& constraints, std::span<const Vec3> rest);
/// Renumbers the vertices of constraints to their places in the list of their cluster.
void number_locally(Clusters& clusters);

}  // namespace meniscus::cloth
