// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The cases of `meniscus validate` hold their hard gates: in their quick form, and in the long run in their
// medium one.
#include <tuple>

#include "sdk/validation/cases/registry.h"
#include "tests/validation/measures.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

using Place = std::tuple<validation::Case, pbd::DeviceKind>;

class ValidationCase : public testing::TestWithParam<Place> {
 protected:
  static void expect_held(validation::Resolution resolution) {
    const auto& [chosen, device] = GetParam();
    const validation::Result result = chosen.run({choice_of(device), 0, resolution});
    EXPECT_FALSE(result.gates.empty());
    for (const validation::Gate& gate : result.gates) {
      record(gate.name, gate.value);
      EXPECT_TRUE(std::isfinite(gate.value)) << gate.name;
      if (gate.bar == validation::Bar::target) continue;
      EXPECT_TRUE(gate.holds()) << gate.name << " is " << gate.value << ", not " << gate.low << " to "
                                << gate.high;
    }
    for (const validation::Plot& plot : result.plots) {
      for (const validation::Curve& curve : plot.curves) {
        EXPECT_GE(curve.x.size(), 2u) << curve.name;
        EXPECT_TRUE(std::is_sorted(curve.x.begin(), curve.x.end())) << curve.name;
      }
    }
  }
};

TEST_P(ValidationCase, HoldsItsGates) {
  expect_held(validation::Resolution::quick);
}

TEST_P(ValidationCase, HoldsThemAtMediumResolution) {
  expect_held(validation::Resolution::medium);
}

std::string place_name(const testing::TestParamInfo<Place>& info) {
  std::string name = std::get<0>(info.param).name + "_" + testing::PrintToString(std::get<1>(info.param));
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(On, ValidationCase,
                         testing::Combine(testing::ValuesIn(validation::all_cases()),
                                          testing::ValuesIn(usable_devices())),
                         place_name);

}  // namespace
}  // namespace meniscus::tests
