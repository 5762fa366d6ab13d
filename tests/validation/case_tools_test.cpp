// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What the cases of `meniscus validate` are judged and described by: curves, gates, names, and the page.
#include <gtest/gtest.h>
#include <meniscus/error.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "sdk/validation/cases/registry.h"
#include "sdk/validation/curves.h"
#include "sdk/validation/page.h"
#include "tests/expect_error.h"

namespace meniscus::validation {
namespace {

namespace fs = std::filesystem;

Curve sampled(double (*f)(double), double end, int count) {
  Curve curve{"f"};
  for (int k = 0; k <= count; ++k) curve.add(end * k / count, f(end * k / count));
  return curve;
}

TEST(ValidationCurves, AreInterpolatedBothWays) {
  const Curve line = sampled([](double x) { return 3 - 2 * x; }, 1, 4);
  EXPECT_NEAR(value_at(line, 0.3), 2.4, 1e-12);
  EXPECT_NEAR(value_at(line, 2), -1, 1e-12);
  EXPECT_NEAR(x_at(line, 2.4), 0.3, 1e-12);
}

TEST(ValidationCurves, TellErrorsAndShifts) {
  const Curve line = sampled([](double x) { return 1 + x; }, 4, 8);
  const Curve readings{"r", {1, 2, 3}, {2.2, 3.3, 4.4}, true};
  EXPECT_NEAR(rms_relative_error(line, readings), 1 - 1 / 1.1, 1e-12);
  const Curve late{"l", {1.25, 2.25}, {2, 3}, true};
  EXPECT_NEAR(best_shift(line, late, 0.5), -0.25, 1e-3);
  EXPECT_NEAR(rms_relative_error(line, late, -0.25), 0, 1e-12);
}

TEST(ValidationCurves, TellThePeriod) {
  EXPECT_NEAR(period_of(sampled([](double x) { return std::sin(5 * x); }, 10, 2000)), 2 * M_PI / 5, 1e-4);
  EXPECT_TRUE(std::isnan(period_of(sampled([](double x) { return x; }, 1, 10))));
}

TEST(ValidationCurves, FitAWaveThatDiesOut) {
  const Curve curve = sampled(
      [](double x) { return 0.3 + std::exp(-0.7 * x) * std::cos(5 * x + 1) + 0.01 * std::sin(40 * x); }, 3,
      200);
  const DampedWave wave = fitted_wave(curve, 1.1);
  EXPECT_NEAR(wave.period, 2 * M_PI / 5, 0.005);
  EXPECT_NEAR(wave.damping, 0.7 / 5, 0.005);
}

TEST(ValidationGates, HoldWithinTheirInterval) {
  Result result;
  result.about_zero("low", "%", -3.1, 3, Bar::hard);
  result.at_most("held", "%", 3, 3, Bar::hard);
  result.within("nan", "", std::nan(""), 0, 1, Bar::target);
  EXPECT_FALSE(result.gates[0].holds());
  EXPECT_TRUE(result.gates[1].holds());
  EXPECT_FALSE(result.gates[2].holds());
  EXPECT_FALSE((Record{{}, result, 0, {}}.passes()));
  result.gates[0].bar = Bar::target;
  EXPECT_TRUE((Record{{}, result, 0, {}}.passes()));
  EXPECT_FALSE((Record{{}, result, 0, "out of memory"}.passes()));
}

TEST(ValidationCases, AreDescribedAndNamedOnce) {
  std::set<std::string> names;
  for (const Case& c : all_cases()) {
    EXPECT_TRUE(names.insert(c.name).second) << c.name;
    EXPECT_FALSE(c.title.empty() || c.set_up.empty() || c.reference.empty()) << c.name;
  }
}

TEST(ValidationCases, AreChosenByName) {
  const std::vector<Case> chosen = chosen_cases({"sloshing", "marin"});
  ASSERT_EQ(chosen.size(), 2u);
  EXPECT_EQ(chosen.front().name, "marin");
  EXPECT_EQ(chosen_cases({}).size(), all_cases().size());
  tests::expect_error(ErrorCode::invalid_argument, "sloshing", [] { chosen_cases({"slosing"}); });
}

TEST(ValidationPage, TellsWhatIsHeldAndWhatIsNot) {
  const fs::path page = fs::path(testing::TempDir()) / "validation_page" / "report.md";
  fs::create_directories(page.parent_path());
  Record good{{"good", "Good case", "Set up so.", "By theory.", {}}, {}, 1, {}};
  good.result.at_most("error", "%", 1, 2, Bar::hard);
  good.result.plots = {{"Plot", "x", "y", {{"line", {0, 1}, {0, -1}}, {"dots", {0.5}, {2}, true}}}};
  Record bad{{"bad", "Bad case", "Set up so.", "By theory.", {}}, {}, 1, {}};
  bad.result.about_zero("error", "%", -9, 5, Bar::target, "It is coarse.");
  write_page(page, {"a device", "quick", "abc", {"A gate is missing."}}, {good, bad});

  std::ifstream in(page);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  for (const char* part :
       {"a device", "`abc`", "- [Good case](#good)", "Bad case: error is -9 %, not ± 5 %. It is coarse.",
        "![Plot](report/good.svg)", "| error | 1 % | ≤ 2 % | gate | held |"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in\n" << text;
  EXPECT_TRUE(fs::exists(page.parent_path() / "report" / "good.svg"));
  const auto figures = nlohmann::json::parse(std::ifstream(page.parent_path() / "report" / "figures.json"));
  EXPECT_EQ(figures["cases"][1]["gates"][0]["value"], -9);
  EXPECT_FALSE(figures["cases"][1]["gates"][0]["holds"]);
  EXPECT_EQ(figures["cases"][0]["plots"][0]["curves"][1]["y"][0], 2);
}

}  // namespace
}  // namespace meniscus::validation
