// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The CPU device gives the same bits with the widest registers that the processor has as with those of the
// baseline.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <numeric>
#include <random>

#include "pbd/device/cpu/cpu_device.h"
#include "tests/bench/harness/solver_bench.h"

namespace meniscus::tests {
namespace {

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

/// Each operation on lanes, its results added up or as a mask.
struct AllOperations {
  static constexpr uint32_t results = 9, lanes = 8;

  pbd::View<const pbd::Vec4> points;
  pbd::View<const float> values;
  pbd::View<const uint32_t> index;
  pbd::View<const uint32_t> own;  // lanes' places in `scattered`
  pbd::View<float> out;
  pbd::View<pbd::Vec4> scattered;

  template <class D>
  void run(uint32_t i) const {
    using Real = typename D::Real;
    const typename D::LaneIndex j{&index[lanes * i]};
    const auto p = gather(points, j);
    const Real v = gather(values, j);
    Real folded = p.w;
    folded += v;
    folded *= p.x - v;
    const uint32_t first = i % (points.count - 32);
    float* to = &out[results * i];
    to[0] = sum(folded);
    to[1] = sum(p.y / (-v));
    to[2] = sum(max(p.x, v));
    to[3] = sum(max(v, p.x));
    to[4] = sum(inverse_sqrt(p.z * p.z));
    to[5] = sum(select_less(p.x, v, p.y, p.z));
    to[6] = static_cast<float>(less_mask(p.x, v));
    to[7] = static_cast<float>(D::Lister::near(points, points[first].xyz(), 4.0f, first, 1 + i % 23));
    to[8] = sum(square_root(p.z * p.z));
    scatter(scattered, typename D::LaneIndex{&own[lanes * i]}, p, i);
  }
};

std::vector<float> all_operations(pbd::CpuDevice::Registers registers) {
  constexpr uint32_t count = 1000;
  std::mt19937 random(3);
  std::normal_distribution<float> normal;
  std::vector<pbd::Vec4> points(count);
  std::vector<float> values(count), out(AllOperations::results * count);
  std::vector<uint32_t> index(AllOperations::lanes * count);
  for (pbd::Vec4& p : points) p = {normal(random), normal(random), normal(random), normal(random)};
  for (float& v : values) v = normal(random);
  for (uint32_t& j : index) j = static_cast<uint32_t>(random() % count);
  std::vector<uint32_t> own(AllOperations::lanes * count);
  std::iota(own.begin(), own.end(), 0u);
  std::vector<pbd::Vec4> scattered(own.size(), pbd::Vec4{1, 2, 3, 4});
  values[7] = std::numeric_limits<float>::quiet_NaN();
  values[8] = std::numeric_limits<float>::infinity();
  values[9] = -0.0f;
  values[10] = std::numeric_limits<float>::denorm_min();
  pbd::CpuDevice device(1, registers);
  device.parallel_for_long("test", count,
                           AllOperations{{points.data(), count},
                                         {values.data(), count},
                                         {index.data(), static_cast<uint32_t>(index.size())},
                                         {own.data(), static_cast<uint32_t>(own.size())},
                                         {out.data(), static_cast<uint32_t>(out.size())},
                                         {scattered.data(), static_cast<uint32_t>(scattered.size())}});
  for (size_t k = 0; k < scattered.size(); ++k) {
    const bool meant = k / AllOperations::lanes >> k % AllOperations::lanes & 1;
    const pbd::Vec4 there = scattered[k], expected = meant ? points[index[k]] : pbd::Vec4{1, 2, 3, 4};
    EXPECT_EQ(there.xyz(), expected.xyz()) << k;
    EXPECT_EQ(there.w, expected.w) << k;
  }
  // What kind of not-a-number comes out is no result.
  for (float& x : out) x = std::isnan(x) ? 0.5f : x;
  return out;
}

TEST(CpuRegisters, EachOperationGivesTheSameBits) {
  const std::vector<float> widest = all_operations(pbd::CpuDevice::Registers::widest);
  const std::vector<float> baseline = all_operations(pbd::CpuDevice::Registers::baseline);
  for (size_t k = 0; k < widest.size(); ++k)
    ASSERT_EQ(std::bit_cast<uint32_t>(widest[k]), std::bit_cast<uint32_t>(baseline[k]))
        << "operation " << k % AllOperations::results << " of " << k / AllOperations::results;
}

/// A shaken block in a corner, of particles of two masses.
DensityCase corner() {
  constexpr float spacing = 0.05f;
  DensityCase c;
  c.support_radius = 2 * spacing;
  c.kernel = fluid::calibrate(spacing, c.support_radius);
  std::mt19937 random(5);
  std::uniform_real_distribution<float> noise(-0.2f, 0.2f);
  for (int n = 0; n < 1000; ++n) {
    const Vec3 cell{0.5f + float(n % 10), 0.5f + float(n / 10 % 10), 0.5f + float(n / 100)};
    const Vec3 moved{noise(random), noise(random), noise(random)};
    c.particles.push_back(pbd::with_w(0.93f * spacing * (cell + moved), n % 3 ? 8 : 80));
  }
  for (Vec3 normal : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    collision::Shape plane;
    plane.size = normal;
    c.planes.push_back(plane);
  }
  c.iterations = 4;
  return c;
}

TEST(CpuRegisters, ASolveGivesTheSameBits) {
  const auto widest = make_cpu_solver_bench(), baseline = make_baseline_solver_bench();
  const DensityCase c = corner();
  const DensitySolution a = widest->solve_density(c), b = baseline->solve_density(c);
  EXPECT_TRUE(same_bits(a.positions, b.positions));
  EXPECT_TRUE(same_bits(a.multipliers, b.multipliers));
  EXPECT_TRUE(same_bits(a.errors, b.errors));
}

TEST(CpuRegisters, ListsAndSmoothedVelocitiesAreTheSame) {
  const auto widest = make_cpu_solver_bench(), baseline = make_baseline_solver_bench();
  SmoothingCase c;
  c.particles = corner().particles;
  c.kernel = corner().kernel;
  fluid::Material material;
  material.xsph = 20;
  material.vorticity_confinement = 0.1f;
  c.materials = {material};
  std::vector<Vec3> points;
  for (const pbd::Vec4& p : c.particles) {
    points.push_back(p.xyz());
    c.groups.push_back(0);
    c.velocities.push_back({p.y, -p.x, p.z * p.y});
  }
  EXPECT_EQ(widest->neighbours(points, 0.1f).of, baseline->neighbours(points, 0.1f).of);
  EXPECT_TRUE(same_bits(widest->smooth(c), baseline->smooth(c)));
}

}  // namespace
}  // namespace meniscus::tests
