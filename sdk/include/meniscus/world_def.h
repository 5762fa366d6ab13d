// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The definition of a world and of its solvers. Units as in defs.h.
#pragma once

#include <meniscus/host.h>
#include <meniscus/types.h>

#include <cstdint>
#include <optional>

namespace meniscus {

/// Where a world runs.
enum class DeviceChoice {
  automatic,  ///< CUDA if there is a usable GPU, else the CPU
  cpu,
  cuda,
};

/// The method that solves for the density multipliers.
enum class DensitySolver {
  jacobi,     ///< damped Jacobi on accumulated multipliers
  chebyshev,  ///< Jacobi with Chebyshev's weights: fewer iterations for the same error
  grid,  ///< a multigrid solve on a coarse grid once a substep, for any depth; then `chebyshev` without a
         ///< warm start
  // Methods of others, for comparison: docs/methods/baselines.md. They solve for fluids and rigid bodies
  // alone.
  pcisph,  ///< predictive-corrective SPH (Solenthaler & Pajarola 2009)
  wcsph,   ///< weakly compressible SPH (Becker & Teschner 2007); it chooses its own substeps
  dfsph,   ///< divergence-free SPH (Bender & Koschier 2015)
};

/// A method of others. It takes no cloth, ropes, grains or periodic axes, and the kernel `poly6_spiky` alone.
constexpr bool is_baseline(DensitySolver solver) {
  return solver >= DensitySolver::pcisph;
}

/// The pair of smoothing kernels W and ∇W (docs/methods/kernels.md). The choice also fixes the particle
/// volume and the scales of pressure, surface tension and the solver.
enum class SmoothingKernel {
  poly6_spiky,   ///< poly6 for sums, spiky for gradients (Macklin & Müller 2013)
  wendland_c2,   ///< Wendland's C2 kernel for both: calm water at rest without xsph
  cubic_spline,  ///< the cubic B-spline for both (Monaghan 1992)
};

/// What the order of sums over neighbours and contacts, and choices like it, may depend on
/// (docs/methods/sums.md).
enum class Sums {
  automatic,  ///< on the number of particles and on the extent of all, for speed
  fixed,  ///< on what a particle meets alone: the bits of its motion do not depend on the rest of the world
};

/// Repulsion against tensile instability (Macklin & Müller 2013, eq. 13). Its pressure is
/// strength · ρ₀ · |g| · h.
struct ArtificialPressureDef {
  float strength = 0.0f;  ///< k, no unit, 0 to 1e6; about 0.1 looks as in the paper
  int exponent = 4;       ///< n, 1 to 16
  float distance = 0.2f;  ///< Δq, as a fraction of the support radius, 0 to 0.9
};

/// How the density of fluids is solved.
struct DensitySolverDef {
  DensitySolver solver = DensitySolver::chebyshev;  ///< the method
  float relaxation = 0.3f;                          ///< Jacobi's damping ω, 0.01 to 0.44
  float warm_start = 0.4f;      ///< fraction of the last substep's multipliers to start from, 0 to 0.5
  float spectral_bound = 4.5f;  ///< largest eigenvalue that Chebyshev's weights expect, 3 to 20
  /// ≥ 0: mean of max(C, 0) over all fluid particles, C = ρ/ρ₀ − 1, at which the density solve of a substep
  /// ends. WorldDef::iterations is then its maximum. All other constraints still have that number. There is
  /// at least one iteration, except with `grid`, which may need none. 0: always WorldDef::iterations; with
  /// `pcisph` and `dfsph` the tolerances of their authors.
  float tolerance = 0.0f;
  /// 1/Pa, ≥ 0, the inverse bulk modulus; 0 is incompressible. With `wcsph` 0 means a speed of sound of ten
  /// times the fluid's greatest speed. `pcisph` and `dfsph` take 0 alone.
  float compressibility = 0.0f;
  float correction_limit = 0.25f;  ///< largest correction of one iteration, in particle spacings, > 0
  /// With `pcisph`, `wcsph` and `dfsph`: spacings that the fastest particle may move in a substep, 0 to 10.
  /// A step has more substeps than WorldDef::substeps where it would move further. 0: no such bound.
  float courant_number = 0.4f;
  ArtificialPressureDef artificial_pressure{};  ///< of fluids
};

/// What solves contacts among solids.
enum class RigidSolver {
  bullet,  ///< Bullet, on one core of the host
  device,  ///< the device of the world, in small steps. It has all solids but cylinders, also fixed and
           ///< kinematic ones, and no joints: docs/methods/rigid-contacts.md
};

/// How contacts and joints among solids are solved. With `bullet`, stacks with mass ratios up to 1000 need
/// steps of at most 1 ms and 50 iterations. If a light floating body carries a heavy one, the world's own
/// substeps must be as short. Particles see a body with its own mass, without the bodies that rest on it.
struct RigidSolverDef {
  int substeps = 1;  ///< steps of the bodies in a substep, 1 to 1000
  /// 1 to 10,000: iterations of each. With `device`, how often a step visits each contact, twice in each of
  /// its small steps.
  int iterations = 10;
  RigidSolver solver = RigidSolver::bullet;  ///< the method; a world keeps it
};

/// How cloth is solved. Short substeps help it more than iterations.
struct ClothSolverDef {
  float over_relaxation = 1.2f;  ///< ω of stretch and shear, 1 to 1.3
  /// 0 to 0.95: fraction of the last multipliers that edges outside chains, such as diagonals, start from.
  /// With a larger fraction shear reaches its stiffness in fewer substeps, but fine sheets take longer to
  /// come to rest. Pieces near fluid or dynamic bodies always start from 0, because their last multipliers do
  /// not fit the next load.
  float warm_start = 0.7f;
  /// 1 to 32: how often the last iteration of a substep solves stretch and shear. For cloth that drapes over
  /// solids, several rounds hold lengths as well as so many times the substeps, and cost less. Long substeps
  /// allow few: a sheet of 250² vertices that falls on a ball at 8 substeps a frame is stable with 8 rounds
  /// and bursts with 16.
  int stretch_rounds = 1;

  friend bool operator==(const ClothSolverDef&, const ClothSolverDef&) = default;
};

/// A ramp from 0 at `low` to 1 at `high`, or the interval of a random value.
struct Range {
  float low, high;  ///< the two ends

  friend bool operator==(const Range&, const Range&) = default;
};

/// Spray, foam and bubbles in agitated fluid (Ihmsen et al. 2012). They have no effect on the fluid. A fluid
/// particle makes (air_rate · a + crest_rate · c) · e of them a second. a, c and e rise from 0 to 1 over the
/// ranges `air`, `crest` and `energy`. They collide with solids, but ignore cloth and sinks.
struct DiffuseDef {
  /// 1 to 2²⁶: maximum number at once. Their memory, 104 bytes each on the device, is reserved at the start.
  /// Those that exceed it are not made. StepReport::diffuse_refused counts them.
  uint32_t capacity = 1u << 18;
  float air_rate = 200.0f;     ///< 1/s, ≥ 0, for trapped air
  float crest_rate = 200.0f;   ///< 1/s, ≥ 0, for breaking waves
  Range air{0.6f, 2.4f};       ///< m/s: mean speed at which neighbours approach
  Range crest{0.2f, 0.8f};     ///< mean curvature of the surface, no unit: 0 on a plane
  Range energy{0.5f, 8.0f};    ///< J/kg, half of the speed squared
  Range lifetime{1.0f, 4.0f};  ///< s, of each, at random
  float spread = 0.1f;         ///< ≥ 0: sideways speed at creation, as a fraction of the speed
  float drag = 40.0f;          ///< 1/s, ≥ 0: rate at which a bubble takes the fluid's velocity
  float buoyancy = 2.0f;       ///< of a bubble, in gravities, ≥ 0: it rises at buoyancy · g / drag
  // The amount of fluid around a diffuse particle, over the amount inside a fluid:
  float spray_below = 0.15f;   ///< below this it is spray, 0 to 1
  float bubbles_above = 0.7f;  ///< above this it is a bubble, spray_below to 1; in between it is foam

  friend bool operator==(const DiffuseDef&, const DiffuseDef&) = default;
};

/// The ends of an axis along which the world repeats itself.
struct PeriodicExtent {
  float low = 0, high = 0;  ///< m

  friend bool operator==(const PeriodicExtent&, const PeriodicExtent&) = default;
};

/// The axes along which the world repeats itself: fluid that leaves at one end enters at the other. An extent
/// is at least 4 support radii long. Such a world takes fluids and fixed shapes, sinks and most probes.
/// Bodies, cloth, ropes, grains, emitters, diffuse particles and all solvers but `jacobi` and `chebyshev` are
/// refused. All particles are between the ends, to rounding. A shape near an end acts at the other as well.
struct PeriodicDef {
  std::optional<PeriodicExtent> x{}, y{}, z{};  ///< none: the axis has no end

  friend bool operator==(const PeriodicDef&, const PeriodicDef&) = default;
};

/// A world and its solvers.
struct WorldDef {
  DeviceChoice device = DeviceChoice::automatic;  ///< where it runs
  int threads = 0;  ///< threads of the CPU device, at most 1024; 0: one for each core
  /// m: the world computes with positions relative to this point. Calls take and return positions as always.
  /// A scene far from zero names a point in its middle, and is then as precise as one at zero. Arguments and
  /// read-outs are floats, and are rounded to 1 mm at 10 km.
  Vec3 origin{0, 0, 0};
  Vec3 gravity{0, -9.81f, 0};      ///< m/s²
  float particle_spacing = 0.05f;  ///< s, m: the rest distance between fluid particles, 1e-4 to 1e3
  float support_ratio = 2.0f;      ///< support radius h over spacing, 1.5 to 3
  SmoothingKernel kernel = SmoothingKernel::poly6_spiky;  ///< smoothing kernels of density and pressure
  /// Per step, 1 to 1000, when cfl_number is 0. A minimum while a fast body is near cloth: it then takes up
  /// to 256, as StepReport::substeps tells.
  int substeps = 4;
  int iterations = 10;  ///< per substep, 1 to 1000
  /// If > 0, the number of substeps is chosen so that nothing moves further than this · h in a substep.
  float cfl_number = 0.0f;
  int min_substeps = 1;   ///< minimum of that choice, 1 to 1000
  int max_substeps = 16;  ///< maximum of that choice, min_substeps to 1000
  /// Distance from a surface at which the centre of a particle stops, in spacings, 0.01 to 1.
  float contact_radius = 0.5f;
  DensitySolverDef density{};           ///< of fluids
  RigidSolverDef rigid{};               ///< of contacts and joints among solids
  ClothSolverDef cloth{};               ///< of cloth
  std::optional<DiffuseDef> diffuse{};  ///< none: no diffuse particles
  PeriodicDef periodic{};               ///< axes along which the world repeats itself
  /// Which GPU, by its CUDA ordinal, ≥ 0; left out, the first. Refused where the world is on the CPU.
  std::optional<int> cuda_device{};
  /// A cudaStream_t of that GPU, made by the caller, that must outlive the world. All work of the world is
  /// ordered with it. The legacy default stream is refused, as no graph can be captured on it. Null: a stream
  /// of the world's own. It is neither in scene files nor in snapshots. Refused where the world is on the
  /// CPU.
  void* cuda_stream = nullptr;
  /// Reads the mesh files that definitions name, and the files that these refer to; none: the file system.
  FileReader read_file{};
  /// Gets notes and warnings: the device, repairs of meshes, what World::warnings finds before the first
  /// step, and what a step leaves out, each once. None: nobody gets them. Not in files.
  LogSink log{};
  /// Runs the loops of the CPU device in place of threads of its own; `threads` must then be 0. With bodies,
  /// one more thread of the library works beside them. A GPU does not use it. Not in files.
  ParallelFor parallel_for{};
  /// ms, ≥ 0: if > 0, the wall clock time that a step may take. A step then makes 1 to `iterations`
  /// iterations, as the times of the step before suggest; the first one makes all. StepReport::iterations has
  /// the choice, and World::step repeats it. Results then depend on how fast the machine is.
  float step_budget_ms = 0.0f;
  /// `fixed`: fluid moves with the same bits whatever else is in the world, in a world of another extent, and
  /// in a batch. cfl_number, density.tolerance, viscosity and the pressure grid still look at all fluid.
  Sums sums = Sums::automatic;
};

}  // namespace meniscus
