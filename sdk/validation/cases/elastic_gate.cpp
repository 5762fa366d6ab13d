// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Water flows out under a rubber gate that it bends: Antoci et al. 2007.
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <string>

#include "sdk/validation/cases/cases.h"
#include "sdk/validation/cases/cloth_parts.h"
#include "sdk/validation/curves.h"

namespace meniscus::validation {
namespace {

constexpr float length = 0.079f, thickness = 0.005f, density = 1100, gap = 0.0025f;  // m, kg/m³; of the gate
constexpr float column_width = 0.1f, column_height = 0.14f, channel = 0.4f;          // m
constexpr double until = 0.37;                                                       // s

/// m over s, of the free end.
struct Motion {
  Curve x, y;
};

const Motion& readings() {
  static const Motion motion{{"Antoci et al. 2007",
                              {.044, .084, .121, .162, .203, .240, .322, .361},
                              {12.9e-3, 33.9e-3, 43.8e-3, 46.0e-3, 44.0e-3, 42.8e-3, 39.7e-3, 36.9e-3},
                              true},
                             {"Antoci et al. 2007",
                              {.042, .083, .122, .163, .202, .244, .323, .362},
                              {0.6e-3, 9.6e-3, 14.9e-3, 17.1e-3, 16.5e-3, 13.8e-3, 11.9e-3, 10.9e-3},
                              true}};
  return motion;
}

/// The gate is a sheet in the plane x = 0, clamped half a square above its free length.
ClothDef gate(float modulus, float half_depth, int squares) {
  const float side = length / (float(squares) + 0.5f), top = gap + length + 0.5f * side;
  const float height = float(squares + 1) * side;
  const int rows = 2 * static_cast<int>(1.3f * half_depth / side) + 1;
  ClothDef def = sheet(height, float(rows - 1) * side, squares + 2, rows, {0, top - 0.5f * height, 0});
  def.pose.rotation = about_z(90);
  FabricDef& fabric = def.fabric;
  fabric.density = density * thickness;
  fabric.warp_stiffness = fabric.weft_stiffness = modulus * thickness;
  fabric.shear_stiffness = modulus * thickness / 3;
  fabric.bending_stiffness = modulus * thickness * thickness * thickness / 12;
  fabric.thickness = thickness;
  fabric.stretch_damping = fabric.bending_damping = fabric.drag = fabric.lift = 0;
  def.self_collision = def.tethers = false;
  def.filter = {2, 0xffffffffu};
  return def;
}

Motion swing(const Settings& settings, float modulus) {
  const float spacing = settings.choose(0.005f, 0.0025f, 0.00125f), half_depth = 4 * spacing;
  World world(settings.world(spacing));
  ShapeDef walls = tank({-column_width, 0, -half_depth}, {channel, 0.3f, half_depth});
  const float clamp = gap + length, wall = 0.3f - clamp;
  ShapeDef above = shape(BoxGeometry{{0.01f, 0.5f * wall, half_depth}}, {0.01f, clamp + 0.5f * wall, 0});
  walls.filter = above.filter = {1, 1};  // the sheet reaches into the walls beside it and above it
  world.create_shape(walls);
  world.create_shape(above);
  const int squares = settings.choose(10, 16, 24);
  const ClothDef def = gate(modulus, half_depth, squares);
  const ClothId cloth = world.create_cloth(def);
  world.create_attachment(held(cloth, columns_of(def, {squares, squares + 1})));
  world.add_fluid(
      block(world.create_fluid({}), {-column_width, 0, -half_depth}, {0, column_height, half_depth}));
  const float frame = settings.choose(0.004f, 0.002f, 0.002f);
  const std::vector<uint32_t> free_end = columns_of(def, {0});
  const Vec3 start = mean_of(world.cloth_positions(cloth), free_end);
  const std::string name = fmt::format("E = {:g} MPa", 1e-6 * double{modulus});
  Motion motion{{name, {0}, {0}}, {name, {0}, {0}}};
  while (world.time() < until) {
    world.step(frame);
    const Vec3 moved = mean_of(world.cloth_positions(cloth), free_end) - start;
    motion.x.add(world.time(), double{moved.x});
    motion.y.add(world.time(), double{moved.y});
  }
  return motion;
}

struct Peak {
  double time = 0, value = 0;
};

Peak peak_of(const Curve& curve) {
  const auto at = std::max_element(curve.y.begin(), curve.y.end()) - curve.y.begin();
  const auto k = static_cast<std::size_t>(at);
  return {curve.x[k], curve.y[k]};
}

Result result_of(const Settings& settings) {
  Result result;
  const Motion& expected = readings();
  Plot x{"Free end, along the flow", "time (s)", "displacement (m)", {}};
  Plot y{"Free end, upwards", "time (s)", "displacement (m)", {}};
  const Motion main = swing(settings, 10e6f);
  const Peak most = peak_of(main.x), rise = peak_of(main.y);
  const char* early = "The gate swings back too early, whichever E is taken. The reason is not known.";
  result.about_zero("peak along the flow over the experiment's less 1", "%",
                    100 * (most.value / peak_of(expected.x).value - 1), 15, Bar::target,
                    "The finer the particles, the less the gate bends. The reason is not known.");
  result.about_zero("time of that peak less the experiment's", "s", most.time - peak_of(expected.x).time,
                    0.03, Bar::target, early);
  result.about_zero("peak upwards over the experiment's less 1", "%",
                    100 * (rise.value / peak_of(expected.y).value - 1), 15, Bar::target, early);
  x.curves.push_back(main.x);
  y.curves.push_back(main.y);
  for (const float modulus : {7.8e6f, 12e6f}) {
    if (settings.resolution == Resolution::quick) break;
    const Motion other = swing(settings, modulus);
    result.tell("peak along the flow over the experiment's less 1, " + other.x.name, "%",
                100 * (peak_of(other.x).value / peak_of(expected.x).value - 1));
    x.curves.push_back(other.x);
    y.curves.push_back(other.y);
  }
  x.curves.push_back(expected.x);
  y.curves.push_back(expected.y);
  result.plots = {x, y};
  return result;
}

}  // namespace

Case elastic_gate() {
  return {
      "elastic-gate", "Dam break with an elastic gate: Antoci et al.",
      "Water 0.14 m deep and 0.1 m wide flows out under a rubber gate of 79 × 5 mm that is clamped at its "
      "top. "
      "The gate is a sheet with E = 10 MPa, ρ = 1100 kg/m³ and a bending stiffness of E t³/12, without "
      "damping. "
      "The channel is eight spacings wide. Steps are 2 ms long with four substeps, at quick resolution 4 ms.",
      "C. Antoci, M. Gallati & S. Sibilla, Numerical simulation of fluid–structure interaction by SPH, "
      "Comput. Struct. 85 (2007). E is disputed: 7.8 to 12 MPa are told beside it. Their own SPH is 9 % "
      "above "
      "the experiment along the flow, and 14 % upwards.",
      result_of};
}

}  // namespace meniscus::validation
