// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Water on both sides of a taut sheet that parts a tank, held along its top and its bottom: with levels alike
// it stays flat; else it bulges as a membrane does, T w'' = −Δp, with the tension T that its stretch gives.
#include <array>
#include <numeric>

#include "tests/validation/cloth_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float spacing = 0.025f, height = 0.4f, length = 0.3f, half_width = 0.1f;  // m
constexpr float stiffness = 18000, strain = 0.1f;                                   // N/m; of the flat sheet
constexpr int columns = 17, rows = 11;
constexpr double gravity = 9.81, density = 1000;

struct PartedTank {
  World world;
  ClothId cloth;
  std::array<double, 2> volume{};  // m³, of the water on the left and on the right

  PartedTank(pbd::DeviceKind device, float left, float right) : world(world_def(device, spacing)) {
    ShapeDef walls = tank({-length, 0, -half_width}, {length, 1, half_width});
    walls.filter = {1, 1};  // the sheet reaches through the walls beside it
    world.create_shape(walls);
    ClothDef def = sheet(height / (1 + strain), 2.6f * half_width, columns, rows, {0, 0.5f * height, 0});
    def.pose.rotation = about_z(90);
    def.stretch.x = 1 + strain;
    def.fabric.warp_stiffness = stiffness;
    def.fabric.weft_stiffness = stiffness;
    def.self_collision = false;
    def.tethers = false;  // which know of no stretch
    def.filter = {2, 0xffffffffu};
    cloth = world.create_cloth(def);
    world.create_attachment(attach(cloth, column_of(def, 0) + column_of(def, columns - 1)));
    FluidDef water_def;
    water_def.xsph = 50;
    const FluidId water = world.create_fluid(water_def);
    const double cubed = std::pow(double{spacing}, 3);
    volume[0] = cubed * static_cast<double>(
                            world.add_fluid(block(water, {-length, 0, -half_width}, {0, left, half_width})));
    volume[1] = cubed * static_cast<double>(
                            world.add_fluid(block(water, {0, 0, -half_width}, {length, right, half_width})));
  }

  /// By row of height from the floor up, m, the mean over the tank's width: how far the sheet is to the
  /// right.
  std::vector<double> bulge() const {
    std::vector<double> w(columns);
    const auto x = world.cloth_positions(cloth);
    const int beside = 2;  // rows of vertices next to a wall and beyond it
    for (int row = beside; row < rows - beside; ++row) {
      for (int column = 0; column < columns; ++column)
        w[static_cast<size_t>(column)] +=
            double{x[static_cast<size_t>(row * columns + column)].x} / (rows - 2 * beside);
    }
    return w;
  }
  /// The mean over a second, after it has come to rest.
  std::vector<double> bulge_at_rest() {
    run(world, 150, frame);
    std::vector<double> mean(columns);
    for (int k = 0; k < 60; ++k) {
      world.step(frame);
      const std::vector<double> now = bulge();
      for (size_t n = 0; n < mean.size(); ++n) mean[n] += now[n] / 60;
    }
    return mean;
  }
};

/// What the theory says, by finite differences on the sheet's own rows.
class Membrane {
 public:
  explicit Membrane(const std::array<double, 2>& volume) : w_(columns) {
    double tension = double{stiffness} * double{strain};
    for (int round = 0; round < 200; ++round) {
      const double left = level(volume[0], 1), right = level(volume[1], -1);
      std::vector<double> next = deflection(left, right, tension);
      for (size_t n = 0; n < w_.size(); ++n) w_[n] = 0.5 * (w_[n] + next[n]);
      tension = double{stiffness} * ((1 + double{strain}) * drawn_length() / double{height} - 1);
    }
  }
  const std::vector<double>& bulge() const { return w_; }

 private:
  static constexpr double dy = double{height} / (columns - 1);

  /// Where so much water stands, the sheet bulging away from it (`side` 1) or into it (−1).
  double level(double volume, int side) const {
    double filled = 0, y = 0;
    const double area = volume / (2 * double{half_width});
    for (size_t n = 0; n + 1 < w_.size(); ++n) {
      const double slice = dy * (double{length} + side * 0.5 * (w_[n] + w_[n + 1]));
      if (filled + slice >= area) return y + dy * (area - filled) / slice;
      filled += slice;
      y += dy;
    }
    return y + (area - filled) / double{length};
  }
  double drawn_length() const {
    double sum = 0;
    for (size_t n = 0; n + 1 < w_.size(); ++n) sum += std::hypot(dy, w_[n + 1] - w_[n]);
    return sum;
  }
  /// w(0) = w(H) = 0.
  static std::vector<double> deflection(double left, double right, double tension) {
    const auto pressure = [&](double y) {
      return density * gravity * (std::max(0.0, left - y) - std::max(0.0, right - y));
    };
    std::vector<double> w(columns), slope(columns);
    for (size_t n = 0; n + 1 < w.size(); ++n) {
      const double y = dy * static_cast<double>(n);
      slope[n + 1] = slope[n] - dy * pressure(y + 0.5 * dy) / tension;
      w[n + 1] = w[n] + 0.5 * dy * (slope[n] + slope[n + 1]);
    }
    const double end = w.back();
    for (size_t n = 0; n < w.size(); ++n) w[n] -= end * static_cast<double>(n) / (columns - 1);
    return w;
  }

  std::vector<double> w_;
};

double largest(const std::vector<double>& values) {
  return std::transform_reduce(
      values.begin(), values.end(), 0.0, [](double a, double b) { return std::max(a, b); },
      [](double w) { return std::fabs(w); });
}

class ClothMembrane : public OnDevice {};

TEST_P(ClothMembrane, StaysFlatBetweenEqualLevels) {
  PartedTank tank(GetParam(), 0.25f, 0.25f);
  const double off = largest(tank.bulge_at_rest());
  record("off_flat_percent", 100 * off / double{height});
  EXPECT_LT(off, 0.005 * double{height});
}

TEST_P(ClothMembrane, BulgesWithTheDifferenceOfLevels) {
  for (const float right : {0.0f, 0.15f}) {
    PartedTank tank(GetParam(), 0.35f, right);
    const std::vector<double> measured = tank.bulge_at_rest();
    const std::vector<double> theory = Membrane(tank.volume).bulge();
    double worst = 0;
    for (size_t n = 0; n < theory.size(); ++n) worst = std::max(worst, std::fabs(measured[n] - theory[n]));
    const std::string name = right > 0 ? "_over_water" : "_over_air";
    record("bulge" + name, largest(theory));
    record("bulge_error_percent" + name, 100 * (largest(measured) / largest(theory) - 1));
    record("shape_error_percent" + name, 100 * worst / largest(theory));
    EXPECT_GT(largest(theory), 0.03 * double{height});
    EXPECT_LT(worst, 0.1 * largest(theory)) << name;
  }
}

MENISCUS_ON_EACH_DEVICE(ClothMembrane);

}  // namespace
}  // namespace meniscus::tests
