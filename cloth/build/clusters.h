// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Constraints in clusters: those of a cluster touch few vertices, which stay in a core's cache, or in that of
// a GPU's multiprocessor; and the clusters of a pass share no vertex, so that they are solved at once. A
// whole sweep takes a few passes, and not a launch for each colour.
#pragma once

#include <span>

#include "cloth/build/build_constraints.h"

namespace meniscus::cloth {

enum class ConstraintKind : uint32_t { isometric, hinge, strain, edge };

/// Constraints of one kind and colour in a cluster: items[first] to items[first + count − 1].
struct Batch {
  ConstraintKind kind;
  uint32_t first, count;
};

/// Its vertices: vertices[first_vertex] to vertices[end_vertex − 1]; and of its constraints, isometric hinges
/// or edges, whichever it has.
struct Cluster {
  uint32_t first_batch, end_batch;
  uint32_t first_vertex, end_vertex;
  uint32_t first_item = 0, end_item = 0;

  static constexpr uint32_t most_vertices = 256;
};

/// The constraints of all cloth, sorted by cluster, kind and colour.
struct Clusters {
  std::vector<IsometricConstraint> isometric;
  std::vector<HingeConstraint> hinges;
  std::vector<StrainConstraint> strains;
  std::vector<EdgeConstraint> edges;
  std::vector<Batch> batches;            ///< of each cluster: in the order of the kinds, and of the colours
  std::vector<Cluster> clusters;         ///< of each pass
  std::vector<uint32_t> pass_starts{0};  ///< one more than passes
  uint32_t bending_passes = 0;           ///< the first ones
  std::vector<uint32_t> vertices;        ///< of each cluster, ascending
  /// Where edges have few colours, and nothing else stretches, these are in no cluster: of each colour the
  /// first edge, and the total. Else empty.
  std::vector<uint32_t> colour_starts;
};

/// Passes of bending come before those of stretch and shear, if there are any of these: two colours, as the
/// diagonals of a sheet have, are two passes by themselves, without a stop at each cluster. `rest`: m, where
/// vertices are at rest.
Clusters build_clusters(const ClothConstraints& constraints, std::span<const Vec3> rest);
/// Vertices of constraints become their places among those of the cluster.
void number_locally(Clusters& clusters);

}  // namespace meniscus::cloth
