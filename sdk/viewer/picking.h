// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds what the mouse points at.
#pragma once

#include <optional>

#include "sdk/io/solid_triangles.h"
#include "sdk/viewer/grab.h"
#include "sdk/viewer/orbit.h"
#include "sdk/viewer/snapshot.h"

namespace meniscus::viewer {

/// Finds what the mouse points at.
class Picker {
 public:
  /// Throws what io::solid_triangles throws.
  explicit Picker(const Scene& scene);

  /// The nearest of particles, movable bodies, cloth and ropes, held at the point where the ray meets it.
  /// Nothing if another solid is in front. The ray passes into containers, as the view does.
  std::optional<Grab> pick(const Ray& ray, const Snapshot& snapshot) const;

 private:
  struct Solid {
    std::vector<io::SolidTriangle> triangles;
    Pose pose;           ///< pose of a shape
    bool moves = false;  ///< true: a dynamic body
  };
  std::vector<Solid> shapes_, bodies_;
  float spacing_;
};

}  // namespace meniscus::viewer
