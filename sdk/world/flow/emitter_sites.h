// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <meniscus/flow.h>

#include <vector>

namespace meniscus {

/// A place in an opening that particles leave from, one after another.
struct EmitterSite {
  Vec3 position;   ///< m, in the opening's frame
  Vec3 direction;  ///< unit
};

/// Where particles leave from: as many places as particles at rest density have room side by side.
struct EmitterSites {
  std::vector<EmitterSite> places;
  double area = 0;  ///< m², of the opening
  /// m, between the layers of a full jet: a particle of each takes up the volume spacing³.
  double layer = 0;
};

/// Throws Error: invalid_argument where the opening is not sound or has room for more than a million places,
/// and what loading a mesh throws.
EmitterSites emitter_sites(const EmitterOpening& opening, float spacing);

}  // namespace meniscus
