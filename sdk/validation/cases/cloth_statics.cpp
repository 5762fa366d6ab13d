// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cloth and rods against the heavy elastica, and cloth on a slope against Coulomb's law.
#include <cmath>
#include <string>
#include <vector>

#include "sdk/validation/cases/cases.h"
#include "sdk/validation/cases/cloth_parts.h"
#include "sdk/validation/cases/strips.h"

namespace meniscus::validation {
namespace {

struct Load {
  float load;   ///< B = w L³/EI
  double drop;  ///< of the tip, over the length
};
constexpr Load loads[] = {{1, 0.1235}, {2, 0.2385}, {10, 0.7002}, {20, 0.8299}};

/// m: how far the tip of a rod drops that is 1 m long beyond its clamp, at the defaults of a world.
double rod_drop(const WorldDef& base, float load) {
  constexpr int segments = 20;
  constexpr float side = 1.0f / segments;
  World world(base);
  RopeDef def;
  def.bends_and_twists = true;
  def.points = {{-side, 0, 0}, {1, 0, 0}};
  def.segments = segments + 1;
  // w L³/EI with w = ρ g π r², I = π r⁴/4.
  def.youngs_modulus = def.density * 9.81f * 4 / (load * def.radius * def.radius);
  const RopeId id = world.create_rope(def);
  AttachmentDef clamp = held(id, {0, 1});
  clamp.clamped = true;
  world.create_attachment(clamp);
  double mean = 0;
  constexpr int last = 120;
  run_steps(world, 1800, cloth_frame);
  for (int k = 0; k < last; ++k) {
    world.step(cloth_frame);
    mean -= double{world.rope_positions(id).back().y} / last;
  }
  return mean;
}

Result elastica_result(const Settings& settings) {
  const bool quick = settings.resolution == Resolution::quick;
  const WorldDef def = settings.world(0.05f);
  Result result;
  Curve exact{"theory", {}, {}, true}, rods{"rod, defaults"}, strips{"cloth"};
  for (const Load& l : loads) {
    if (quick && l.load < 10) continue;
    exact.add(double{l.load}, l.drop);
    rods.add(double{l.load}, rod_drop(def, l.load));
    const std::string name = ", B = " + std::to_string(int(l.load));
    result.about_zero("drop of a rod over that of theory less 1" + name, "%",
                      100 * (rods.y.back() / l.drop - 1), 5, Bar::target);
    strips.add(double{l.load}, strip_drop(def, l.load, settings.choose(10, 10, 20), BendingModel::isometric));
    result.about_zero("drop of cloth over that of theory less 1" + name, "%",
                      100 * (strips.y.back() / l.drop - 1), 5, Bar::hard);
  }
  result.plots = {{"Drop of the tip", "load B = w L³/EI", "drop over length", {rods, strips, exact}}};
  return result;
}

Result friction_result(const Settings& settings) {
  Result result;
  for (float friction : {0.2f, 0.5f, 0.8f}) {
    const auto critical = static_cast<float>(std::atan(double{friction}) * 180 / M_PI);
    const std::string name = ", μ = 0." + std::to_string(std::lround(10 * friction));
    result.at_most("slide 2° below atan μ" + name, "mm",
                   1000 * slide(settings.world(0.05f), friction, critical - 2), 0.1, Bar::hard);
    const double moved = slide(settings.world(0.05f), friction, critical + 2);
    result.about_zero("slide 2° above atan μ over Coulomb's less 1" + name, "%",
                      100 * (moved / exact_slide(friction, critical + 2) - 1), 20, Bar::hard);
  }
  return result;
}

}  // namespace

Case elastica() {
  return {
      "elastica", "Heavy elastica of rods and cloth",
      "A rod of 20 segments and a strip of cloth of 10 or 20 squares, 1 m long beyond a clamp, bend under "
      "their "
      "own weight. The rod has the defaults of a world, 4 substeps of 10 iterations. Its drop is a mean over "
      "2 s after 30 s. The strip has 40 substeps for 10 squares, and 160 for 20.",
      "EI θ'' = −w (L − s) cos θ, solved by shooting: drops of .1235, .2385, .7002 and .8299 of the length "
      "at B "
      "= w L³/EI = 1, 2, 10 and 20.",
      elastica_result};
}

Case friction() {
  return {
      "friction", "Friction of cloth on a slope",
      "A sheet of 0.5 × 0.5 m lies on a slope 2° less steep, and 2° steeper, than the angle of friction. The "
      "slide is that in the second from half a second on.",
      "Coulomb: it holds up to atan μ, and slides with g (sin α − μ cos α) beyond.", friction_result};
}

}  // namespace meniscus::validation
