// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Lays the grounds of a world one after the other.
#include "collision/rigid_contact/ground_buffers.h"

#include <algorithm>

namespace meniscus::collision {

void GroundBuffers::set(std::span<const std::shared_ptr<const ContactGround>> grounds) {
  if (std::ranges::equal(grounds, grounds_)) return;
  std::vector<GroundRange> ranges;
  uint32_t nodes = 0, triangles = 0;
  for (const auto& ground : grounds) {
    ranges.push_back({nodes, static_cast<uint32_t>(ground->nodes.size()), triangles,
                      static_cast<uint32_t>(ground->triangles.size())});
    nodes += ranges.back().nodes;
    triangles += ranges.back().triangles;
  }
  grounds_.clear();
  ranges_.resize_discard(ranges.size());
  nodes_.resize_discard(nodes);
  triangles_.resize_discard(triangles);
  seams_.resize_discard(triangles);
  ranges_.write(ranges);
  for (size_t i = 0; i < ranges.size(); ++i) {
    nodes_.write(grounds[i]->nodes, ranges[i].first_node);
    triangles_.write(grounds[i]->triangles, ranges[i].first_triangle);
    seams_.write(grounds[i]->seams, ranges[i].first_triangle);
  }
  grounds_.assign(grounds.begin(), grounds.end());
}

}  // namespace meniscus::collision
