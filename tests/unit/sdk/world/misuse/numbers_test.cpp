// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Each number of each definition, through the call that takes it: out of its range it is refused by its name,
// and the world is as before. Where it is huge and allowed, the world refuses it or stays finite. The numbers
// are those that fields() lists, so a new one is tested without an edit here.
#include <gtest/gtest.h>

#include <memory>
#include <set>

#include "tests/unit/sdk/fields/number_trials.h"
#include "tests/unit/sdk/world/misuse/defs.h"

namespace meniscus::tests {
namespace {

class MisuseNumbersTest : public OnDevice {
 protected:
  std::unique_ptr<MisuseWorld> world_ = std::make_unique<MisuseWorld>(GetParam());
  std::optional<Sight> before_ = Sight(*world_);

  /// Each number once, as long as no trial fails: try_number(definitions, number of one, number, call).
  template <class Try>
  void for_each_number(const Try& try_number) {
    for_each_def_call([&](const char* name, auto defs_of, auto call) {
      SCOPED_TRACE(name);
      std::set<std::string> done;
      auto defs = defs_of(*world_);
      for (std::size_t d = 0; d < defs.size(); ++d) {
        const std::vector<Number> numbers = numbers_of(defs[d], "");
        for (std::size_t k = 0; k < numbers.size(); ++k) {
          if (!done.insert(numbers[k].name).second) continue;
          try_number(numbers[k], [&](double value) {
            auto spoiled = defs_of(*world_);
            numbers_of(spoiled[d], "")[k].set(value);
            call(*world_, spoiled[d]);
          });
          if (HasFatalFailure()) return;
        }
      }
    });
  }

  void expect_unchanged() {
    const bool same = Sight(*world_) == *before_;
    EXPECT_TRUE(same) << "the call was refused, and has changed the world";
    if (!same) restart();
  }

  void restart() {
    world_ = std::make_unique<MisuseWorld>(GetParam());
    before_.emplace(*world_);
  }
};

TEST_P(MisuseNumbersTest, ANumberOutOfItsRangeIsRefusedByName) {
  int tried = 0;
  for_each_number([&](const Number& number, const auto& call) {
    std::vector<double> values = trials(number);
    for (const double value : huge_trials(number)) values.push_back(value);
    for (const double value : values) {
      const bool means_something = std::isinf(value) && value > 0 && number.rule.or_infinite;
      if (is_in(number, value) || means_something) continue;
      SCOPED_TRACE(number.name + " = " + std::to_string(value));
      expect_error(ErrorCode::invalid_argument, number.name, [&] { call(value); });
      expect_unchanged();
      ++tried;
    }
  });
  EXPECT_GT(tried, 900);
}

TEST_P(MisuseNumbersTest, AHugeNumberIsRefusedOrTheWorldStaysFinite) {
  int refused = 0, taken = 0;
  for_each_number([&](const Number& number, const auto& call) {
    for (const double value : huge_trials(number)) {
      if (!is_in(number, value)) continue;
      SCOPED_TRACE(number.name + " = " + std::to_string(value));
      try {
        call(value);
      } catch (const Error& error) {
        const std::string what = error.what();
        EXPECT_GT(what.size(), 20u);
        expect_unchanged();
        ++refused;
        continue;
      }
      for (int k = 0; k < 2; ++k) {
        const Sight sight(*world_);
        try {
          world_->world.step(0.01f);
        } catch (const Error&) {
          expect_same_state(sight, Sight(*world_));
        }
        EXPECT_TRUE(is_finite(*world_));
      }
      restart();
      ++taken;
    }
  });
  RecordProperty("refused", refused);
  RecordProperty("taken", taken);
  EXPECT_GT(refused, 10);
  EXPECT_GT(taken, 100);
}

MENISCUS_ON_EACH_DEVICE(MisuseNumbersTest);

}  // namespace
}  // namespace meniscus::tests
