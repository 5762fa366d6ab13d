// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Checks of single arguments, and of definitions of worlds and fluids.
#include "sdk/world/check/check.h"

#include <meniscus/error.h>

#include <cmath>
#include <sstream>

#include "pbd/math/direction.h"

namespace meniscus::check {

void refuse(const char* name, const std::string& value, const std::string& allowed) {
  throw Error(ErrorCode::invalid_argument, std::string(name) + " is " + value + "; it must be " + allowed);
}

std::string text_of(Vec3 v) {
  std::ostringstream text;
  text << "(" << v.x << ", " << v.y << ", " << v.z << ")";
  return text.str();
}

namespace {

template <class T>
[[noreturn]] void refuse(const char* name, const T& value, const std::string& allowed) {
  std::ostringstream text;
  text << value;
  check::refuse(name, text.str(), allowed);
}

template <class T>
std::string range(T lower, T upper) {
  std::ostringstream text;
  text << "from " << lower << " to " << upper;
  return text.str();
}

}  // namespace

void finite(const char* name, float value) {
  if (!std::isfinite(value)) refuse(name, value, "finite");
}

void finite(const char* name, Vec3 value) {
  if (!is_finite(value)) refuse(name, text_of(value), "finite");
}

void direction(const char* name, Vec3 value) {
  if (!pbd::is_direction(value))
    refuse(name, text_of(value), "of a length " + range(pbd::least_direction, pbd::longest_direction));
}

void impulse(const char* name, Vec3 value, float mass) {
  finite(name, value);
  constexpr float most = 1e9f;  // m/s: the squares of what steps make of it are still finite
  if (length(value) <= most * mass) return;
  std::ostringstream allowed;
  allowed << "at most " << most * mass << " N·s, which gives 1e9 m/s";
  refuse(name, text_of(value), allowed.str());
}

void positive(const char* name, float value) {
  if (!std::isfinite(value) || value <= 0) refuse(name, value, "finite and > 0");
}

void density(const char* name, float value) {
  between(name, value, 1e-3f, 1e6f);
}

void at_least(const char* name, float value, float lower) {
  if (!std::isfinite(value) || value < lower)
    refuse(name, value, (std::ostringstream() << "finite and at least " << lower).str());
}

void not_negative(const char* name, float value) {
  if (!std::isfinite(value) || value < 0) refuse(name, value, "finite and ≥ 0");
}

void between(const char* name, float value, float lower, float upper) {
  if (!(value >= lower && value <= upper)) refuse(name, value, range(lower, upper));
}

void between(const char* name, int value, int lower, int upper) {
  if (value < lower || value > upper) refuse(name, value, range(lower, upper));
}

void box(const char* name, const Aabb& value) {
  finite(name, value.lower);
  finite(name, value.upper);
  if (value.lower.x > value.upper.x || value.lower.y > value.upper.y || value.lower.z > value.upper.z) {
    refuse(name, text_of(value.lower) + " to " + text_of(value.upper), "lower ≤ upper on each axis");
  }
}

void pose(const char* name, const Pose& value) {
  finite(name, value.position);
  const Quat q = value.rotation;
  const float norm = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
  if (std::fabs(norm - 1) < 1e-3f) return;
  std::ostringstream turned;
  turned << "turned by a quaternion with a squared length of " << norm;
  refuse(name, turned.str(), "turned by one with 1");
}

void color(const char* name, Vec3 value) {
  for (const float fraction : {value.x, value.y, value.z}) {
    if (!(fraction >= 0 && fraction <= 1)) refuse(name, text_of(value), "from 0 to 1 in each component");
  }
}

namespace {

// Of what acts on fluid, in its unit: beyond, floats do not hold what steps make of it.
constexpr float most_factor = 1e6f;

void range(const char* name, const Range& value) {
  if (!std::isfinite(value.low) || value.low < 0 || !std::isfinite(value.high) || value.high <= value.low) {
    std::ostringstream text;
    text << value.low << " to " << value.high;
    refuse(name, text.str(), "from a value ≥ 0 to a greater one");
  }
}

void diffuse(const DiffuseDef& def) {
  if (def.capacity < 1 || def.capacity > 1u << 26)
    refuse("DiffuseDef::capacity", std::to_string(def.capacity), "from 1 to 67108864");
  not_negative("DiffuseDef::air_rate", def.air_rate);
  not_negative("DiffuseDef::crest_rate", def.crest_rate);
  range("DiffuseDef::air", def.air);
  range("DiffuseDef::crest", def.crest);
  range("DiffuseDef::energy", def.energy);
  range("DiffuseDef::lifetime", def.lifetime);
  not_negative("DiffuseDef::spread", def.spread);
  not_negative("DiffuseDef::drag", def.drag);
  not_negative("DiffuseDef::buoyancy", def.buoyancy);
  between("DiffuseDef::spray_below", def.spray_below, 0.0f, 1.0f);
  between("DiffuseDef::bubbles_above", def.bubbles_above, def.spray_below, 1.0f);
}

}  // namespace

void world(const WorldDef& def) {
  one_of("WorldDef::device", def.device, DeviceChoice::cuda);
  between("WorldDef::threads", def.threads, 0, 1024);
  finite("WorldDef::gravity", def.gravity);
  between("WorldDef::particle_spacing", def.particle_spacing, 1e-4f, 1e3f);  // floats hold the kernel
  between("WorldDef::support_ratio", def.support_ratio, 1.5f, 3.0f);
  between("WorldDef::substeps", def.substeps, 1, 1000);
  between("WorldDef::iterations", def.iterations, 1, 1000);
  not_negative("WorldDef::cfl_number", def.cfl_number);
  between("WorldDef::min_substeps", def.min_substeps, 1, 1000);
  between("WorldDef::max_substeps", def.max_substeps, def.min_substeps, 1000);
  between("WorldDef::contact_radius", def.contact_radius, 0.01f, 1.0f);
  between("ClothSolverDef::over_relaxation", def.cloth.over_relaxation, 1.0f, 1.3f);
  between("ClothSolverDef::warm_start", def.cloth.warm_start, 0.0f, 0.95f);
  between("ClothSolverDef::stretch_rounds", def.cloth.stretch_rounds, 1, 32);
  const DensitySolverDef& d = def.density;
  one_of("DensitySolverDef::solver", d.solver, DensitySolver::grid);
  between("DensitySolverDef::relaxation", d.relaxation, 0.01f, 0.44f);
  between("DensitySolverDef::warm_start", d.warm_start, 0.0f, 0.5f);
  between("DensitySolverDef::spectral_bound", d.spectral_bound, 3.0f, 20.0f);
  not_negative("DensitySolverDef::tolerance", d.tolerance);
  not_negative("DensitySolverDef::compressibility", d.compressibility);
  positive("DensitySolverDef::correction_limit", d.correction_limit);
  between("RigidSolverDef::substeps", def.rigid.substeps, 1, 1000);
  between("RigidSolverDef::iterations", def.rigid.iterations, 1, 10000);
  between("ArtificialPressureDef::strength", d.artificial_pressure.strength, 0.0f, most_factor);
  between("ArtificialPressureDef::exponent", d.artificial_pressure.exponent, 1, 16);
  between("ArtificialPressureDef::distance", d.artificial_pressure.distance, 0.0f, 0.9f);
  if (def.diffuse) diffuse(*def.diffuse);
}

void fluid(const FluidDef& def) {
  density("FluidDef::rest_density", def.rest_density);
  not_negative("FluidDef::viscosity", def.viscosity);
  not_negative("FluidDef::xsph", def.xsph);
  between("FluidDef::vorticity_confinement", def.vorticity_confinement, 0.0f, most_factor);
  between("FluidDef::cohesion", def.cohesion, 0.0f, most_factor);
  between("FluidDef::surface_tension", def.surface_tension, 0.0f, most_factor);
  color("FluidDef::color", def.color);
}

void granular(const GranularDef& def) {
  density("GranularDef::density", def.density);
  not_negative("GranularDef::friction", def.friction);
  color("GranularDef::color", def.color);
}

}  // namespace meniscus::check
