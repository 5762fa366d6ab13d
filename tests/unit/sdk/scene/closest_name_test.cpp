// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Names that were mistyped are corrected, and others are not guessed at.
#include "sdk/scene/closest_name.h"

#include <gtest/gtest.h>

namespace meniscus::tests {
namespace {

TEST(ClosestName, ASlipIsCorrected) {
  EXPECT_EQ(name_hint("fase", {"face", "name"}), "did you mean \"face\"?");
  EXPECT_EQ(name_hint("radii", {"radius", "ratio"}), "did you mean \"radius\"?");
  EXPECT_EQ(name_hint("wendland", {"cubic_spline", "wendland_c2"}), "did you mean \"wendland_c2\"?");
}

TEST(ClosestName, CapitalsDoNotCount) {
  EXPECT_EQ(name_hint("Y", {"x", "y", "z"}), "did you mean \"y\"?");
  EXPECT_EQ(name_hint("RestDensity", {"rest_density", "viscosity"}), "did you mean \"rest_density\"?");
}

TEST(ClosestName, AnotherWordIsNotGuessedAt) {
  EXPECT_EQ(name_hint("ball", {"hull", "sphere"}), "allowed: \"hull\", \"sphere\"");
  EXPECT_EQ(name_hint("position", {"motion", "pose"}), "allowed: \"motion\", \"pose\"");
  EXPECT_EQ(name_hint("w", {"x", "y"}), "allowed: \"x\", \"y\"");
}

}  // namespace
}  // namespace meniscus::tests
