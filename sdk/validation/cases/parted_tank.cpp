// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Water on both sides of a taut sheet that parts a tank, held along its top and its bottom.
#include "sdk/validation/cases/parted_tank.h"

#include <algorithm>
#include <cmath>

#include "sdk/validation/cases/cloth_parts.h"

namespace meniscus::validation {
namespace {

constexpr float height = PartedTank::height, spacing = 0.025f, length = 0.3f, half_width = 0.1f;  // m
constexpr float stiffness = 18000, strain = 0.1f;  // N/m; of the flat sheet
constexpr int columns = 17, rows = 11;
constexpr double gravity = 9.81, density = 1000;

WorldDef with_spacing(WorldDef def) {
  def.particle_spacing = spacing;
  return def;
}

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

}  // namespace

PartedTank::PartedTank(WorldDef base, float left, float right) : world(with_spacing(base)) {
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
  world.create_attachment(held(cloth, columns_of(def, {0, columns - 1})));
  FluidDef water_def;
  water_def.xsph = 50;
  const FluidId water = world.create_fluid(water_def);
  const double cubed = std::pow(double{spacing}, 3);
  volume[0] = cubed * static_cast<double>(
                          world.add_fluid(block(water, {-length, 0, -half_width}, {0, left, half_width})));
  volume[1] = cubed * static_cast<double>(
                          world.add_fluid(block(water, {0, 0, -half_width}, {length, right, half_width})));
}

std::vector<double> PartedTank::bulge() const {
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

std::vector<double> PartedTank::bulge_at_rest() {
  run_steps(world, 150, cloth_frame);
  std::vector<double> mean(columns);
  for (int k = 0; k < 60; ++k) {
    world.step(cloth_frame);
    const std::vector<double> now = bulge();
    for (size_t n = 0; n < mean.size(); ++n) mean[n] += now[n] / 60;
  }
  return mean;
}

std::vector<double> exact_bulge(const std::array<double, 2>& volume) {
  return Membrane(volume).bulge();
}

double largest(const std::vector<double>& values) {
  double most = 0;
  for (double w : values) most = std::max(most, std::fabs(w));
  return most;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (std::size_t n = 0; n < a.size(); ++n) most = std::max(most, std::fabs(a[n] - b[n]));
  return most;
}

}  // namespace meniscus::validation
