// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The places of an emitter's opening from which particles leave.
#pragma once

#include <meniscus/flow.h>

#include <vector>

namespace meniscus {

/// A place in an opening that particles leave from, one after another.
struct EmitterSite {
  Vec3 position;   ///< m, in the opening's frame
  Vec3 direction;  ///< unit
};

/// The places from which particles leave: as many as particles at rest density fit side by side.
struct EmitterSites {
  std::vector<EmitterSite> places;
  double area = 0;  ///< m², of the opening
  /// m, between the layers of a full jet: each particle of a layer has the volume spacing³.
  double layer = 0;
};

/// Throws Error(invalid_argument) if the opening is not valid or has room for more than a million places, and
/// what loading a mesh throws.
EmitterSites emitter_sites(const EmitterOpening& opening, float spacing, const FileReader& files = {});

}  // namespace meniscus
