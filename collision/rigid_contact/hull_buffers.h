// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The hulls of a world in a device's memory, one after the other.
#pragma once

#include "collision/rigid_contact/hull.h"
#include "pbd/device/buffer.h"

namespace meniscus::collision {

class HullBuffers {
 public:
  explicit HullBuffers(pbd::Device& device)
      : ranges_(device, "solid hulls"),
        vertices_(device, "solid hulls"),
        faces_(device, "solid hulls"),
        corners_(device, "solid hulls"),
        edges_(device, "solid hulls") {}

  /// Replaces all hulls. The device must not be reading them. The cube is there if there are others, or if it
  /// is asked for.
  void set(std::span<const std::shared_ptr<const ContactHull>> hulls, bool with_cube = false);
  bool any() const { return ranges_.size() > 1; }
  HullTable table() const {
    return {ranges_.view(), vertices_.view(), faces_.view(), corners_.view(), edges_.view()};
  }
  /// A part's place in table(), from that in the list of hulls.
  static uint32_t number_of(const Convex& shape) {
    return shape.kind == ConvexKind::hull ? shape.table + 1 : 0;
  }

 private:
  pbd::Buffer<HullRange> ranges_;
  pbd::Buffer<Vec3> vertices_;
  pbd::Buffer<HullFace> faces_;
  pbd::Buffer<uint32_t> corners_;
  pbd::Buffer<HullEdge> edges_;
};

}  // namespace meniscus::collision
