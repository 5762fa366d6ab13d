// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The world itself and its solvers.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "sdk/fields/names.h"
#include "sdk/fields/values.h"

namespace meniscus {

constexpr auto names_of(DeviceChoice) {
  return std::array{Named{"auto", DeviceChoice::automatic}, Named{"cpu", DeviceChoice::cpu},
                    Named{"cuda", DeviceChoice::cuda}};
}
constexpr auto names_of(DensitySolver) {
  return std::array{Named{"jacobi", DensitySolver::jacobi}, Named{"chebyshev", DensitySolver::chebyshev},
                    Named{"grid", DensitySolver::grid},     Named{"pcisph", DensitySolver::pcisph},
                    Named{"wcsph", DensitySolver::wcsph},   Named{"dfsph", DensitySolver::dfsph}};
}
constexpr auto names_of(RigidSolver) {
  return std::array{Named{"bullet", RigidSolver::bullet}, Named{"device", RigidSolver::device}};
}
constexpr auto names_of(SmoothingKernel) {
  return std::array{Named{"poly6_spiky", SmoothingKernel::poly6_spiky},
                    Named{"wendland_c2", SmoothingKernel::wendland_c2},
                    Named{"cubic_spline", SmoothingKernel::cubic_spline}};
}

constexpr auto names_of(Sums) {
  return std::array{Named{"auto", Sums::automatic}, Named{"fixed", Sums::fixed}};
}

template <class V>
void fields(V& v, ArtificialPressureDef& d) {
  v("strength", d.strength, between(0, 1e6), "",
    "k of Macklin & Müller 2013, eq. 13; about 0.1 for their look");
  v("exponent", d.exponent, between(1, 16), "", "n");
  v("distance", d.distance, between(0, 0.9), "", "Δq, as a fraction of the support radius");
}

template <class V>
void fields(V& v, DensitySolverDef& d) {
  v("solver", d.solver, any_value, "",
    "how the fluid's pressure is found; pcisph, wcsph and dfsph are methods of others, for comparison");
  v("relaxation", d.relaxation, between(0.01, 0.44), "", "damping ω of the Jacobi solver");
  v("warm_start", d.warm_start, between(0, 0.5), "", "share of the last substep's multipliers to start from");
  v("spectral_bound", d.spectral_bound, between(3, 20), "",
    "largest eigenvalue that Chebyshev's weights expect");
  v("tolerance", d.tolerance, not_negative, "",
    "mean of max(ρ/ρ₀ − 1, 0) at which a substep's density solve ends; 0: after all iterations");
  v("compressibility", d.compressibility, not_negative, "1/Pa", "inverse bulk modulus; 0 is incompressible");
  v("correction_limit", d.correction_limit, positive, "spacings", "largest correction of one iteration");
  v("courant_number", d.courant_number, between(0, 10), "spacings",
    "with pcisph, wcsph and dfsph: largest motion of the fastest particle in a substep; 0: no such bound");
  v("artificial_pressure", d.artificial_pressure, any_value, "", "repulsion against clumping at the surface");
  v.check(d.compressibility == 0 || !is_baseline(d.solver) || d.solver == DensitySolver::wcsph,
          "compressibility must be 0 with the solvers pcisph and dfsph, which are incompressible",
          "compressibility", d.compressibility);
  v.check(d.artificial_pressure.strength == 0 || !is_baseline(d.solver),
          "artificial_pressure.strength must be 0 with the solvers pcisph, wcsph and dfsph",
          "artificial_pressure", d.artificial_pressure.strength);
}

template <class V>
void fields(V& v, RigidSolverDef& d) {
  v("substeps", d.substeps, between(1, 1000), "", "steps of the bodies in a substep");
  v("iterations", d.iterations, between(1, 10000), "", "solver iterations of each");
  v("solver", d.solver, any_value, "",
    "what solves contacts among solids: Bullet on one core, or the device, without joints and cylinders");
}

template <class V>
void fields(V& v, ClothSolverDef& d) {
  v("over_relaxation", d.over_relaxation, between(1, 1.3), "", "ω of stretch and shear");
  v("warm_start", d.warm_start, between(0, 0.95), "",
    "share of what edges outside chains last pushed or pulled with, to start from: more makes shear stiffer "
    "in few substeps, and fine sheets slower to come to rest");
  v("stretch_rounds", d.stretch_rounds, between(1, 32), "",
    "how many times a substep's last iteration goes over stretch and shear: cheaper than substeps where "
    "cloth drapes");
}

template <class V>
void fields(V& v, DiffuseDef& d) {
  v("capacity", d.capacity, between(1, 1 << 26), "", "most at once");
  v("air_rate", d.air_rate, not_negative, "1/s", "that a particle of fluid makes where air is trapped");
  v("crest_rate", d.crest_rate, not_negative, "1/s", "that a particle of fluid makes where waves break");
  v("air", d.air, any_value, "m/s", "mean speed at which neighbours meet");
  v("crest", d.crest, any_value, "", "mean bend of the surface");
  v("energy", d.energy, any_value, "J/kg", "half of the speed squared");
  v("lifetime", d.lifetime, any_value, "s", "of each, at random");
  v("spread", d.spread, not_negative, "", "of speed, sideways, when they are made");
  v("drag", d.drag, not_negative, "1/s", "rate at which a bubble takes the fluid's velocity");
  v("buoyancy", d.buoyancy, not_negative, "gravities", "of a bubble");
  v("spray_below", d.spray_below, between(0, 1), "", "spray is among less fluid than this share");
  v("bubbles_above", d.bubbles_above, between(0, 1), "", "bubbles are among more; foam is in between");
  v.check(d.spray_below <= d.bubbles_above, "spray_below must not be above bubbles_above", "bubbles_above",
          d.bubbles_above);
}

template <class V>
void fields(V& v, PeriodicExtent& d) {
  v("low", d.low, required(any_value), "m", "where the axis begins");
  v("high", d.high, required(any_value), "m", "where it begins again");
  v.check(d.low < d.high && std::isfinite(d.high - d.low), "high must be above low, by a finite extent",
          "high", d.high);
}

template <class V>
void fields(V& v, PeriodicDef& d) {
  v("x", d.x, any_value, "", "ends of the x axis; left out, it has none");
  v("y", d.y, any_value, "", "ends of the y axis; left out, it has none");
  v("z", d.z, any_value, "", "ends of the z axis; left out, it has none");
}

/// Checks the extent of one axis against the support radius.
template <class V>
void check_extent(V& v, const WorldDef& d, const std::optional<PeriodicExtent>& extent, const char* axis) {
  constexpr float rounding = 0.999f;
  const float least = 4 * d.support_ratio * d.particle_spacing;
  v.check(!extent || extent->high - extent->low >= rounding * least,
          std::string("periodic.") + axis + " must be at least 4 support radii long, " +
              std::to_string(least) + " m");
}

/// Checks that a world with periodic axes has nothing that knows of no seams.
template <class V>
void check_periodic(V& v, const WorldDef& d) {
  check_extent(v, d, d.periodic.x, "x");
  check_extent(v, d, d.periodic.y, "y");
  check_extent(v, d, d.periodic.z, "z");
  if (d.periodic == PeriodicDef{}) return;
  v.check(!d.diffuse, "a world with periodic axes has no diffuse particles");
  v.check(d.density.solver != DensitySolver::grid && !is_baseline(d.density.solver),
          "a world with periodic axes is solved by jacobi or chebyshev alone");
}

template <class V>
void fields(V& v, WorldDef& d) {
  v("device", d.device, any_value, "", "where to run; auto takes a usable GPU, else the CPU");
  v("threads", d.threads, between(0, 1024), "", "of the CPU device; 0 is one a core");
  v("origin", d.origin, any_value, "m",
    "about which the world computes: a scene far from zero is then as precise as one beside it");
  v("gravity", d.gravity, any_value, "m/s²", "acceleration of everything");
  v("particle_spacing", d.particle_spacing, between(1e-4, 1e3), "m", "rest distance between fluid particles");
  v("support_ratio", d.support_ratio, between(1.5, 3), "", "support radius over spacing");
  v("kernel", d.kernel, any_value, "", "smoothing kernels of density and pressure");
  v("substeps", d.substeps, between(1, 1000), "",
    "substeps of a frame, where cfl_number is 0; more while a fast body is near cloth");
  v("iterations", d.iterations, between(1, 1000), "", "solver iterations of a substep");
  v("cfl_number", d.cfl_number, not_negative, "support radii",
    "when above 0, substeps are chosen so that nothing moves further than this in one");
  v("min_substeps", d.min_substeps, between(1, 1000), "", "fewest substeps that cfl_number may choose");
  v("max_substeps", d.max_substeps, between(1, 1000), "", "most substeps that cfl_number may choose");
  v("contact_radius", d.contact_radius, between(0.01, 1), "spacings",
    "distance from a surface at which a particle's centre stops");
  v("density", d.density, any_value, "", "the density constraint");
  v("rigid", d.rigid, any_value, "", "how contacts and joints among solids are solved");
  v("cloth", d.cloth, any_value, "", "how cloth is solved");
  v("diffuse", d.diffuse, any_value, "", "spray, foam and bubbles; left out, there are none");
  v("periodic", d.periodic, any_value, "",
    "axes along which the world repeats itself; it then takes fluids and fixed shapes alone");
  v("cuda_device", d.cuda_device, not_negative, "", "ordinal of the GPU; left out, the first");
  v("step_budget_ms", d.step_budget_ms, not_negative, "ms",
    "time that a step may take: iterations are left out to keep it, so results depend on the machine; 0: "
    "none");
  v("sums", d.sums, any_value, "",
    "fixed: the bits of a motion do not depend on the rest of the world; auto is faster for few particles");
  check_periodic(v, d);
  v.check(!d.parallel_for || d.threads == 0, "threads must be 0 with parallel_for, which has its own",
          "threads", d.threads);
  v.check(d.min_substeps <= d.max_substeps, "min_substeps must not be above max_substeps", "max_substeps",
          d.max_substeps);
}

}  // namespace meniscus
