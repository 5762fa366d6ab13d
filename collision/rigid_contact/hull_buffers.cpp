// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Lays the hulls of a world one after the other.
#include "collision/rigid_contact/hull_buffers.h"

#include <array>

namespace meniscus::collision {

namespace {

const ContactHull& unit_cube() {
  static const ContactHull cube = make_contact_hull(std::array<Vec3, 8>{
      {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}}});
  return cube;
}

template <class T>
void append(std::vector<T>& all, const std::vector<T>& own, uint32_t& first, uint32_t& count) {
  first = static_cast<uint32_t>(all.size());
  count = static_cast<uint32_t>(own.size());
  all.insert(all.end(), own.begin(), own.end());
}

template <class T>
void upload(pbd::Buffer<T>& buffer, const std::vector<T>& all) {
  buffer.resize_discard(all.size());
  buffer.write(all);
}

}  // namespace

void HullBuffers::set(std::span<const std::shared_ptr<const ContactHull>> hulls, bool with_cube) {
  std::vector<HullRange> ranges;
  ContactHull all;
  const auto add = [&](const ContactHull& hull) {
    HullRange r{};
    append(all.vertices, hull.vertices, r.first_vertex, r.vertices);
    append(all.faces, hull.faces, r.first_face, r.faces);
    append(all.corners, hull.corners, r.first_corner, r.corners);
    append(all.edges, hull.edges, r.first_edge, r.edges);
    ranges.push_back(r);
  };
  if (with_cube || !hulls.empty()) add(unit_cube());
  for (const auto& hull : hulls) add(*hull);
  upload(ranges_, ranges);
  upload(vertices_, all.vertices);
  upload(faces_, all.faces);
  upload(corners_, all.corners);
  upload(edges_, all.edges);
}

}  // namespace meniscus::collision
