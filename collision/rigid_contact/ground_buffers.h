// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The grounds of a world in a device's memory, one after the other.
#pragma once

#include <memory>
#include <span>

#include "collision/rigid_contact/ground.h"
#include "pbd/device/buffer.h"

namespace meniscus::collision {

class GroundBuffers {
 public:
  explicit GroundBuffers(pbd::Device& device)
      : ranges_(device, "solid meshes"),
        nodes_(device, "solid meshes"),
        triangles_(device, "solid meshes"),
        seams_(device, "solid meshes") {}

  /// Replaces all grounds, unless they are the same as before. The device must not be reading them.
  void set(std::span<const std::shared_ptr<const ContactGround>> grounds);
  bool any() const { return !grounds_.empty(); }
  GroundTable table() const { return {ranges_.view(), nodes_.view(), triangles_.view(), seams_.view()}; }

 private:
  std::vector<std::shared_ptr<const ContactGround>> grounds_;
  pbd::Buffer<GroundRange> ranges_;
  pbd::Buffer<BvhNode> nodes_;
  pbd::Buffer<Triangle> triangles_;
  pbd::Buffer<TriangleSeams> seams_;
};

}  // namespace meniscus::collision
