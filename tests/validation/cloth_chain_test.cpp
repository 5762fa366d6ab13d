// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A chain between two points 1 m apart hangs as a catenary. Its parameter a is from sinh(1/2a) = L/2a: the
// sag is a (cosh(1/2a) − 1), and at its ends it is atan sinh(1/2a) steep.
#include "sdk/validation/cases/hanging_chain.h"
#include "tests/validation/cloth_worlds.h"

namespace meniscus::tests {
namespace {

using validation::Catenary;

constexpr float lengths[] = {1.2f, 2};  // m

void expect_catenary(const Catenary& found) {
  const Catenary exact = validation::exact_catenary(found.length);
  record("sag_of_" + std::to_string(found.length), found.sag);
  record("angle_of_" + std::to_string(found.length), found.end_angle);
  EXPECT_NEAR(found.sag, exact.sag, 0.01f * exact.sag) << "length " << found.length;
  EXPECT_NEAR(found.end_angle, exact.end_angle, 0.01f * exact.end_angle) << "length " << found.length;
}

class ClothChain : public OnDevice {};

// The loss of long substeps brings a rope without air to rest.
TEST_P(ClothChain, ARopeHangsAsACatenary) {
  for (float length : lengths) {
    for (int substeps : {1, 4})
      expect_catenary(validation::hang_rope(world_def(GetParam(), 0.05f), length, substeps));
  }
}

// Starts straight and compressed, with substeps of half a millisecond. The air is so dense that the strip
// sinks into its shape. Otherwise it may turn once about itself on the way, and then it hangs flatter by 1.4
// %.
TEST_P(ClothChain, AStripOfClothHangsAsACatenary) {
  for (float length : lengths) expect_catenary(validation::hang_strip(world_def(GetParam(), 0.05f), length));
}

MENISCUS_ON_EACH_DEVICE(ClothChain);

}  // namespace
}  // namespace meniscus::tests
