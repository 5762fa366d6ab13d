// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
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

  /// The nearest of particles, bodies that can be moved, cloth and ropes, to be held where the ray meets it;
  /// nothing where another solid is in front. One sees into containers, and so does the ray.
  std::optional<Grab> pick(const Ray& ray, const Snapshot& snapshot) const;

 private:
  struct Solid {
    std::vector<io::SolidTriangle> triangles;
    Pose pose;           ///< of shapes
    bool moves = false;  ///< a dynamic body
  };
  std::vector<Solid> shapes_, bodies_;
  float spacing_;
};

}  // namespace meniscus::viewer
