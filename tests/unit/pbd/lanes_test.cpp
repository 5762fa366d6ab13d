// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Each operation on eight lanes against the same one on each of them.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "pbd/device/cpu/cpu_device.h"

namespace meniscus::pbd {
namespace {

using Eight = std::array<float, Lanes::count>;

Lanes lanes(const Eight& v) {
  return {Float4{v[0], v[1], v[2], v[3]}, Float4{v[4], v[5], v[6], v[7]}};
}

Eight eight(Lanes v) {
  return {v.low[0], v.low[1], v.low[2], v.low[3], v.high[0], v.high[1], v.high[2], v.high[3]};
}

Eight random_eight(std::mt19937& random, float lower = -10, float upper = 10) {
  Eight v;
  for (float& x : v) x = std::uniform_real_distribution<float>(lower, upper)(random);
  return v;
}

// Equal bits, not equal values: that is what keeps a run the same on every processor.
template <class Operation>
void expect_lanewise(Lanes found, const Eight& a, const Eight& b, const Operation& operation) {
  const Eight result = eight(found);
  for (uint32_t k = 0; k < Lanes::count; ++k) {
    EXPECT_EQ(std::bit_cast<uint32_t>(result[k]), std::bit_cast<uint32_t>(float{operation(a[k], b[k])}))
        << "lane " << k << " of " << a[k] << " and " << b[k];
  }
}

TEST(Lanes, ArithmeticIsThatOfEachLane) {
  std::mt19937 random(1);
  for (int n = 0; n < 100; ++n) {
    const Eight a = random_eight(random), b = random_eight(random);
    const Lanes x = lanes(a), y = lanes(b);
    expect_lanewise(x + y, a, b, [](float p, float q) { return p + q; });
    expect_lanewise(x - y, a, b, [](float p, float q) { return p - q; });
    expect_lanewise(x * y, a, b, [](float p, float q) { return p * q; });
    expect_lanewise(x / y, a, b, [](float p, float q) { return p / q; });
    expect_lanewise(-x, a, b, [](float p, float) { return -p; });
    expect_lanewise(max(x, y), a, b, [](float p, float q) { return max(p, q); });
    Lanes added = x, multiplied = x;
    expect_lanewise(added += y, a, b, [](float p, float q) { return p + q; });
    expect_lanewise(multiplied *= y, a, b, [](float p, float q) { return p * q; });
  }
}

TEST(Lanes, InverseSquareRootIsTheScalarOne) {
  std::mt19937 random(2);
  for (int n = 0; n < 1000; ++n) {
    const Eight a = random_eight(random, 1e-12f, 2);
    expect_lanewise(inverse_sqrt(lanes(a)), a, a, [](float p, float) { return inverse_sqrt(p); });
  }
}

TEST(Lanes, UnitPartIsTheScalarOne) {
  std::mt19937 random(6);
  for (int n = 0; n < 200; ++n) {
    Eight a = random_eight(random, -2, 1);
    a[static_cast<size_t>(n % 8)] = n % 2 ? 0.0f : std::numeric_limits<float>::quiet_NaN();
    expect_lanewise(unit_part(lanes(a)), a, a, [](float p, float) { return unit_part(p); });
  }
}

TEST(Lanes, SelectAndMaskCompareEachLane) {
  std::mt19937 random(3);
  for (int n = 0; n < 200; ++n) {
    Eight a = random_eight(random), b = random_eight(random);
    a[static_cast<size_t>(n % 8)] = b[static_cast<size_t>(n % 8)];  // equal is not less
    const uint32_t mask = less_mask(lanes(a), lanes(b));
    for (uint32_t k = 0; k < Lanes::count; ++k) EXPECT_EQ(mask >> k & 1, less_mask(a[k], b[k]));
    EXPECT_EQ(mask >> Lanes::count, 0u);
    expect_lanewise(select_less(lanes(a), lanes(b), Lanes(1.0f), Lanes(2.0f)), a, b,
                    [](float p, float q) { return select_less(p, q, 1.0f, 2.0f); });
  }
}

TEST(Lanes, NotANumberIsNeverLessAndGivesWayInMax) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(less_mask(Lanes(nan), Lanes(1.0f)), 0u);
  EXPECT_EQ(less_mask(Lanes(1.0f), Lanes(nan)), 0u);
  EXPECT_EQ(eight(max(Lanes(nan), Lanes(1.0f))), eight(Lanes(1.0f)));
  EXPECT_EQ(max(nan, 1.0f), 1.0f);
}

TEST(Lanes, TheSumRunsOverAFixedTree) {
  std::mt19937 random(4);
  for (int n = 0; n < 100; ++n) {
    const Eight v = random_eight(random);
    const float expected = ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
    EXPECT_EQ(std::bit_cast<uint32_t>(sum(lanes(v))), std::bit_cast<uint32_t>(expected));
  }
}

TEST(Lanes, GatherPutsElementsIntoTheirLanes) {
  std::vector<Vec4> vectors;
  std::vector<float> scalars;
  for (int i = 0; i < 40; ++i) {
    const float x = static_cast<float>(i);
    vectors.push_back({x, x + 100, x + 200, x + 300});
    scalars.push_back(-x);
  }
  const uint32_t at[8] = {39, 0, 7, 7, 22, 13, 1, 30};
  const Vec4Of<Lanes> v = gather(View<const Vec4>{vectors.data(), 40}, LaneIndex{at});
  const Vec4Of<Lanes> run = load_run(View<const Vec4>{vectors.data(), 40}, 11, static_cast<Lanes*>(nullptr));
  for (uint32_t k = 0; k < 8; ++k) {
    const Vec4 one = vectors[at[k]], next = vectors[11 + k];
    EXPECT_EQ(eight(v.x)[k], one.x);
    EXPECT_EQ(eight(v.y)[k], one.y);
    EXPECT_EQ(eight(v.z)[k], one.z);
    EXPECT_EQ(eight(v.w)[k], one.w);
    EXPECT_EQ(eight(run.x)[k], next.x);
    EXPECT_EQ(eight(run.w)[k], next.w);
    EXPECT_EQ(eight(gather(View<const float>{scalars.data(), 40}, LaneIndex{at}))[k], scalars[at[k]]);
  }
}

}  // namespace
}  // namespace meniscus::pbd
