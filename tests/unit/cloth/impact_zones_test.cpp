// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The last rounds of the fail-safe, in which all vertices of cloth make their own motion.
#include "cloth/self_contact/impact_zones.h"

#include <gtest/gtest.h>

#include <vector>

namespace meniscus::cloth::self_contact_kernels {
namespace {

using pbd::Vec4;

template <class T>
View<T> view(std::vector<T>& values) {
  return {values.data(), static_cast<uint32_t>(values.size())};
}

/// One vertex that has moved from 0 to 1 m, in a round that found pairs, in a frame at rest.
struct Bench {
  std::vector<Vec4> previous{{0, 0, 0, 1}}, position{{1, 0, 0, 1}}, delta{{0, 0, 0, 1}}, ways{{0, 0, 0, 0}};
  std::vector<Vec4> spheres{{0, 0, 0, 10}}, solved{{1, 0, 0, 1}}, motion{{0, 0, 0, 0}};
  std::vector<uint32_t> of_piece{0}, piece{0}, label{0}, mark{0}, anchor{ImpactZones::itself}, fraction{0};
  std::vector<uint32_t> counters = std::vector<uint32_t>(counter_count, 0), contact_start{0, 0};

  void move(uint32_t round) {
    counters[crossings + round] = 1;
    MoveImpactZones kernel{};
    kernel.cloth.previous = view(previous);
    kernel.cloth.kept.spheres = view(spheres);
    kernel.cloth.frames = {view(motion), view(of_piece), view(piece)};
    kernel.contacts.start = view(contact_start);
    kernel.position = view(position);
    kernel.accumulated_delta = view(delta);
    kernel.impact_zones.label = view(label);
    kernel.impact_zones.mark = view(mark);
    kernel.impact_zones.anchor = view(anchor);
    kernel.own_motion = {view(solved), view(fraction)};
    kernel.cloth.of_world.vertices = 1;
    kernel.ways = view(ways);
    kernel.all_counters = view(counters);
    kernel.round = round;
    kernel(0);
  }
};

TEST(MoveImpactZonesTest, TheLastRoundsTakeBackTheMotionOfCloth) {
  for (const uint32_t round : {most_rounds - 2, most_rounds - 1}) {
    Bench bench;
    bench.move(round);
    EXPECT_EQ(bench.position[0].xyz(), (Vec3{0, 0, 0})) << round;
    EXPECT_EQ(bench.delta[0].xyz(), (Vec3{-1, 0, 0})) << round;
  }
}

TEST(MoveImpactZonesTest, TheLastRoundsLeaveTheVerticesOfRopes) {
  for (const uint32_t round : {most_rounds - 2, most_rounds - 1}) {
    Bench bench;
    bench.piece = {no_index};
    bench.move(round);
    EXPECT_EQ(bench.position[0].xyz(), (Vec3{1, 0, 0})) << round;
    EXPECT_EQ(bench.delta[0].xyz(), (Vec3{0, 0, 0})) << round;
  }
}

}  // namespace
}  // namespace meniscus::cloth::self_contact_kernels
