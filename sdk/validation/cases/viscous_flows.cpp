// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Flows of Couette, Poiseuille, and Taylor & Green, against their solutions.
#include <cmath>
#include <string>

#include "sdk/validation/cases/cases.h"
#include "sdk/validation/cases/periodic_flow.h"
#include "sdk/validation/parts.h"

namespace meniscus::validation {
namespace {

Plot profile_plot(const char* title, const Curve& measured, double (*exact)(double)) {
  Curve theory{"theory"};
  for (int k = 0; k <= 40; ++k)
    theory.add(double{channel_height} * k / 40, exact(double{channel_height} * k / 40));
  return {title, "distance from the lower wall (m)", "velocity (m/s)", {theory, measured}};
}

Result couette_result(const Settings& settings) {
  const ProfileFit fit = couette_flow(settings.world(1), settings.choose(8, 16, 32));
  Result result;
  result.at_most("profile, relative L2 error", "%", 100 * fit.error, 3, Bar::hard);
  result.plots = {profile_plot("Couette's profile", fit.measured, couette_velocity)};
  return result;
}

Result poiseuille_result(const Settings& settings) {
  const ProfileFit fit = poiseuille_flow(settings.world(1), settings.choose(10, 16, 32));
  Result result;
  const char* thin =
      "Stirred fluid that moves slowly has up to 5 % less viscosity than it should, most of all "
      "beside walls.";
  result.at_most("profile, relative L2 error", "%", 100 * fit.error, 6, Bar::hard, thin);
  result.at_most("profile, relative L2 error", "%", 100 * fit.error, 3, Bar::target, thin);
  result.about_zero("flow over that of theory less 1", "%", 100 * (fit.scale - 1), 6, Bar::hard, thin);
  result.at_most("shape of the profile, relative L2 error", "%", 100 * fit.shape, 2.5, Bar::hard);
  result.plots = {profile_plot("Poiseuille's profile", fit.measured, poiseuille_velocity)};
  return result;
}

Result taylor_green_result(const Settings& settings) {
  const float spacing = settings.choose(0.05f, 0.05f, 0.02f);
  Result result;
  Plot plot{"Amplitude of the vortices", "2 ν k² t", "amplitude over the first", {}};
  const std::vector<float> all{0.01f, 0.02f, 0.05f};
  const std::vector<float> viscosities = settings.choose<std::vector<float>>({0.05f}, all, all);
  const std::vector<VortexDecay> decays = taylor_green(settings.world(spacing), viscosities);
  for (std::size_t n = 0; n < decays.size(); ++n) {
    VortexDecay decay = decays[n];
    const std::string name = "ν = 0.0" + std::to_string(std::lround(100 * viscosities[n])) + " m²/s";
    result.about_zero("rate of decay over that of theory less 1, " + name, "%", 100 * (decay.rate - 1), 5,
                      Bar::hard);
    decay.amplitude.name = name;
    plot.curves.push_back(decay.amplitude);
  }
  Curve theory{"theory", {}, {}, true};
  for (int k = 0; k <= 8; ++k) theory.add(0.1 * k, std::exp(-0.1 * k));
  plot.curves.push_back(theory);
  result.plots = {plot};
  return result;
}

}  // namespace

Case couette() {
  return {"couette", "Couette: a wall drags viscous fluid along",
          "Fluid of 0.1 m²/s between two walls without slip 0.4 m apart, of which one moves at 0.5 m/s. The "
          "world "
          "is periodic along the walls. The profile is a mean over 20 frames, in layers of a spacing.",
          "Navier–Stokes: a linear profile.", couette_result};
}

Case poiseuille() {
  return {"poiseuille", "Poiseuille: a force drives viscous fluid",
          "Fluid of 0.1 m²/s between two walls at rest without slip 0.4 m apart, after it was stirred. A "
          "body force "
          "would drive 0.5 m/s in the middle. The profile is a mean over 20 frames, in layers of a spacing.",
          "Navier–Stokes: a parabola.", poiseuille_result};
}

Case taylor_green_vortices() {
  return {
      "taylor-green", "Decay of vortices: Taylor & Green",
      "Four vortices in a periodic square of 1 m, in fluid that was stirred. The Reynolds number of a period "
      "is 20, for each of three viscosities.",
      "G. I. Taylor & A. E. Green, Proc. R. Soc. A 158 (1937): the amplitude decays with 2 ν k².",
      taylor_green_result};
}

}  // namespace meniscus::validation
