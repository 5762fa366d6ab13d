// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Definition structs: fill in what differs from the default, pass to World's constructor and create calls.
// Every quantity is in SI units or has none, and keeps its meaning when the spacing or the time step changes.
#pragma once

#include <meniscus/ids.h>
#include <meniscus/types.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace meniscus {

enum class DeviceChoice {
  automatic,  ///< CUDA where a usable GPU is found, else the CPU
  cpu,
  cuda,
};

/// How the density multipliers are found.
enum class DensitySolver {
  jacobi,     ///< damped Jacobi on accumulated multipliers
  chebyshev,  ///< the same steps, accelerated by Chebyshev's weights: fewer iterations for the same error
  grid,  ///< once a substep a multigrid solve on a coarse grid, which reaches any depth; then Chebyshev's,
         ///< without a warm start
};

/// Tensile-instability repulsion of Macklin & Müller 2013, eq. 13, as a pressure of strength · ρ₀ · |g| · h.
struct ArtificialPressureDef {
  float strength = 0.0f;  ///< k, no unit, 0 to 1e6; the paper's look comes at about 0.1
  int exponent = 4;       ///< n, 1 to 16
  float distance = 0.2f;  ///< Δq, as a fraction of the support radius, 0 to 0.9
};

struct DensitySolverDef {
  DensitySolver solver = DensitySolver::chebyshev;
  float relaxation = 0.3f;      ///< Jacobi's damping ω, 0.01 to 0.44
  float warm_start = 0.4f;      ///< share of the last substep's multipliers to start from, 0 to 0.5
  float spectral_bound = 4.5f;  ///< largest eigenvalue that Chebyshev's weights expect, 3 to 20
  /// Mean of max(C, 0) over all particles of fluids, C = ρ/ρ₀ − 1, ≥ 0, at which a substep's density solve
  /// ends. WorldDef::iterations is then the most that it may take, and what all other constraints have. At
  /// least one iteration is made, except with `grid`, which may need none. 0: as many as WorldDef says.
  float tolerance = 0.0f;
  float compressibility = 0.0f;    ///< 1/Pa, ≥ 0, the inverse bulk modulus; 0 is incompressible
  float correction_limit = 0.25f;  ///< largest correction of one iteration, in particle spacings, > 0
  ArtificialPressureDef artificial_pressure{};
};

/// How Bullet solves contacts and joints among solids. Stacks of mass ratios up to 1000 want Bullet's steps
/// of at most 1 ms and 50 iterations. Afloat, where a light body bears a heavy one, the world's own substeps
/// must be so short too: particles know a body by its own mass, and not by what rests on it.
struct RigidSolverDef {
  int substeps = 1;     ///< Bullet's steps in a substep, 1 to 1000
  int iterations = 10;  ///< of each, 1 to 10,000
};

/// How cloth is solved. Small steps do more for it than iterations.
struct ClothSolverDef {
  float over_relaxation = 1.2f;  ///< ω of stretch and shear, 1 to 1.3
  /// Share of what edges outside chains, such as diagonals, last pushed or pulled with, to start from; 0 to
  /// 0.95. With more of it, shear is as stiff as it should be in fewer substeps, and fine sheets take longer
  /// to come to rest. Pieces near fluid or dynamic bodies start from nothing, whatever this is, as what they
  /// pulled with does not fit what they bear next.
  float warm_start = 0.7f;
  /// How many times a substep's last iteration goes over stretch and shear, 1 to 32. Where cloth drapes over
  /// solids, several do for lengths what as many times the substeps would, and cost less. Long substeps bear
  /// few: a sheet of 250² vertices that falls on a ball bears 8 with 8 substeps a frame, and bursts with 16.
  int stretch_rounds = 1;

  friend bool operator==(const ClothSolverDef&, const ClothSolverDef&) = default;
};

/// Where something begins, and where it is in full.
struct Range {
  float low, high;

  friend bool operator==(const Range&, const Range&) = default;
};

/// Spray, foam and bubbles where the fluid is wild (Ihmsen et al. 2012), for the eye: they have no effect on
/// it. A particle of fluid makes (air_rate · a + crest_rate · c) · e of them a second, where a, c and e go
/// from 0 to 1 over the ranges `air`, `crest` and `energy`. They know solids, but no cloth, and no sinks.
struct DiffuseDef {
  /// Most of them at once, 1 to 2²⁶, each of 104 bytes on the device, for which there is room from the start.
  /// When there are as many, no more are made: StepReport::diffuse_refused counts them.
  uint32_t capacity = 1u << 18;
  float air_rate = 200.0f;     ///< 1/s, ≥ 0, where air is trapped
  float crest_rate = 200.0f;   ///< 1/s, ≥ 0, where waves break
  Range air{0.6f, 2.4f};       ///< m/s: mean speed at which neighbours meet
  Range crest{0.2f, 0.8f};     ///< mean bend of the surface, no unit: 0 where it is flat
  Range energy{0.5f, 8.0f};    ///< J/kg, half of the speed squared
  Range lifetime{1.0f, 4.0f};  ///< s, of each, at random
  float spread = 0.1f;         ///< of speed, sideways, ≥ 0, when they are made
  float drag = 40.0f;          ///< 1/s, ≥ 0: rate at which a bubble takes the fluid's velocity
  float buoyancy = 2.0f;       ///< of a bubble, in gravities, ≥ 0: it rises at buoyancy · g / drag
  // How much fluid is around, of what there is inside of it:
  float spray_below = 0.15f;   ///< spray is among less than this, 0 to 1
  float bubbles_above = 0.7f;  ///< bubbles are among more than this, spray_below to 1; foam is in between

  friend bool operator==(const DiffuseDef&, const DiffuseDef&) = default;
};

struct WorldDef {
  DeviceChoice device = DeviceChoice::automatic;
  int threads = 0;                 ///< of the CPU device, at most 1024; 0: one a core
  Vec3 gravity{0, -9.81f, 0};      ///< m/s²
  float particle_spacing = 0.05f;  ///< s, m: the rest distance between fluid particles, 1e-4 to 1e3
  float support_ratio = 2.0f;      ///< support radius h over spacing, 1.5 to 3
  int substeps = 4;                ///< per step, 1 to 1000, when cfl_number is 0
  int iterations = 10;             ///< per substep, 1 to 1000
  /// When > 0: substeps are chosen so that nothing moves further than this · h in one.
  float cfl_number = 0.0f;
  int min_substeps = 1;   ///< fewest of that choice, 1 to 1000
  int max_substeps = 16;  ///< most of it, min_substeps to 1000
  /// Distance at which a particle's centre stops at a surface, in spacings, 0.01 to 1.
  float contact_radius = 0.5f;
  DensitySolverDef density{};
  RigidSolverDef rigid{};
  ClothSolverDef cloth{};
  std::optional<DiffuseDef> diffuse{};  ///< none: there is none of it
};

struct FluidDef {
  std::string name = "water";
  float rest_density = 1000.0f;  ///< ρ₀, kg/m³, 0.001 to 1e6
  /// Kinematic, m²/s, ≥ 0. In a substep of length hₜ velocities are evened out by 1 − exp(−22 ν hₜ/h²), so
  /// that no more than h²/(22 hₜ) acts, however much is asked for: shorter substeps bear more. It is the
  /// plain Laplacian of velocity: where a surface is free it brakes what turns as a whole, a drop of radius R
  /// at some 4 ν/R².
  float viscosity = 0.0f;
  /// 1/s: rate at which a particle takes its neighbours' mean velocity; vanishes as h². It brakes as
  /// `viscosity`, and takes what motion the density's solve leaves: how calm water at rest is, is a matter of
  /// it. In a pool .6 m deep of particles of 5 cm, at 4 × 10, the RMS speed is 3.6 % of √(g·H) at 5/s; with
  /// none at all it is 11 %, and more with shorter substeps. The column of hydrostatic.json has 100/s.
  float xsph = 5.0f;
  /// ε, no unit, 0 to 1e6; the force is ε · h · (N × ω). It is no force between pairs: momentum drifts with
  /// it.
  float vorticity_confinement = 0.0f;
  /// σ, N/m, 0 to 1e6: attraction and curvature (Akinci et al. 2013). Explicit: substeps shorter than √(ρ₀
  /// s³/(2πσ)). What would pull fluid off a solid or cloth, these hold, and are pulled as much. So it is with
  /// cohesion.
  float surface_tension = 0.0f;
  float cohesion =
      0.0f;  ///< N/m, likewise, on top: attraction alone, which holds threads and sheets together
  CollisionFilter filter{};         ///< which solids it collides with
  Vec3 color{0.10f, 0.35f, 0.75f};  ///< linear RGB, 0 to 1
};

/// Sand, gravel and the like: balls of one spacing in diameter, which touch one another with friction and do
/// not turn (Macklin et al. 2014, Unified Particle Physics, section 6). They meet solids with the surface's
/// own friction, and do not bounce off one another. No substep should be so long that grains move further in
/// it than half a spacing, or they get into one another (see WorldDef::cfl_number); 10 iterations are right,
/// fewer than 5 make a soft pile.
///
/// In a fluid a grain displaces a spacing cubed. So it floats where it is lighter than the fluid, and the
/// fluid's viscosity and `xsph` drag it along. Densities of a fifth to ten times the fluid's are tested.
struct GranularDef {
  std::string name = "sand";
  float density = 1600.0f;  ///< kg/m³, 0.001 to 1e6, bulk: a grain's mass over a spacing cubed
  /// Tangent of the slope at which a column that collapses comes to rest, ≥ 0; below 0.18, that of grains
  /// without friction. A heap that is poured is up to 5° steeper. The contacts' own μ is less, (friction −
  /// 0.18)/1.4, as balls that do not turn interlock; of two materials that touch, the geometric mean of these
  /// counts.
  float friction = 0.6f;
  CollisionFilter filter{};         ///< which solids it collides with
  Vec3 color{0.53f, 0.36f, 0.17f};  ///< linear RGB, 0 to 1
};

/// How finely, and of what, World::surface_mesh makes a surface.
struct SurfaceMeshDef {
  std::optional<FluidId> fluid{};  ///< or granular material; none: all fluids as one, without grains
  float cell_size = 0.5f;          ///< of marching cubes, spacings, 0.1 to 2
  /// Of the field that the particles make, 0.2 to 3: at 1 the surface keeps the fluid's volume, to within .1
  /// spacings of where it is; less is fatter.
  float level = 1.0f;
};

// ---- solids that do not move ----

/// Everything with normal · x < offset is solid.
struct PlaneGeometry {
  Vec3 normal{0, 1, 0};  ///< of a length from 1e-6 to 1e18
  float offset = 0;      ///< m
};

struct BoxGeometry {
  Vec3 half_extents{0.5f, 0.5f, 0.5f};  ///< m
};

enum class Face { x_low, x_high, y_low, y_high, z_low, z_high };

/// A hole in a container's face, through which fluid leaves: what has passed it is outside of the container
/// for good. Without corners the face is not there at all, and the walls around it go on without end, as
/// those of a tall vessel or of a channel.
struct Opening {
  Face face = Face::y_high;
  std::optional<Aabb> region{};  ///< in the container's frame; the extent along the face's normal is ignored
};

/// A box seen from inside: its six faces hold fluid and bodies in. Outside of them is solid: for fluid
/// without end, for bodies as far as the largest half extent. What stands beside it may be kept apart by a
/// CollisionFilter.
struct ContainerGeometry {
  Vec3 half_extents{0.5f, 0.5f, 0.5f};  ///< m, of the inside
  std::vector<Opening> openings{};
};

struct SphereGeometry {
  float radius = 0.5f;  ///< m
};

/// Along y; half_height is half of the distance between the two centres.
struct CapsuleGeometry {
  float radius = 0.5f;       ///< m
  float half_height = 0.5f;  ///< m
};

/// Along y.
struct CylinderGeometry {
  float radius = 0.5f;       ///< m
  float half_height = 0.5f;  ///< m
};

/// A closed surface from any file that assimp reads, as a signed distance field. Holes are closed by the
/// winding number; the mesh of a dynamic body must have none. For other solids, rays and overlaps a dynamic
/// body's mesh is its convex hull.
struct MeshGeometry {
  std::string file;
  float scale =
      1.0f;  ///< metres a file unit; where the file says how long its unit is, as FBX does, a factor
  float cell_size = 0.0f;  ///< of the field, m; 0: half of the particle spacing
  float max_error = 0.0f;  ///< m; when > 0, the field is as fine as it takes to be off by no more
};

/// The convex hull of points. For solids, rays and overlaps, of 200 of them at most, those furthest out.
struct HullGeometry {
  std::vector<Vec3> points;  ///< m, at least 4, not in a plane
};

/// Several solids as one. Where parts overlap, the mass of both counts.
struct CompoundGeometry {
  std::vector<struct CompoundPart> parts;
};

/// Heights over a regular grid in x and z, centred at the origin; solid below.
struct HeightFieldGeometry {
  int columns = 0;               ///< samples along x, 2 to 32,768
  int rows = 0;                  ///< samples along z, 2 to 32,768
  float cell_size = 0.1f;        ///< m
  std::vector<float> heights{};  ///< m, columns · rows of them, x fastest
};

using Geometry =
    std::variant<PlaneGeometry, BoxGeometry, ContainerGeometry, SphereGeometry, CapsuleGeometry,
                 CylinderGeometry, MeshGeometry, HeightFieldGeometry, HullGeometry, CompoundGeometry>;

struct CompoundPart {
  Geometry geometry = BoxGeometry{};  ///< no plane, container, height field or compound
  Pose pose{};
};

/// How a solid's surface treats particles, and other solids. Of two solids that touch, the geometric mean
/// counts.
struct SurfaceDef {
  float friction = 0.0f;           ///< Coulomb's μ for particles, ≥ 0
  float restitution = 0.0f;        ///< for particles, 0 to 1
  float adhesion = 0.0f;           ///< Pa, ≥ 0: the pull on a wet layer of particles, per area
  float solid_friction = 0.5f;     ///< Coulomb's μ for solids, ≥ 0
  float solid_restitution = 0.0f;  ///< for solids, 0 to 1
};

struct ShapeDef {
  std::string name;
  Geometry geometry = PlaneGeometry{};
  Pose pose{};
  SurfaceDef surface{};
  CollisionFilter filter{};
};

// ---- fluid volumes ----

struct BoxRegion {
  Vec3 lower{-0.5f, -0.5f, -0.5f}, upper{0.5f, 0.5f, 0.5f};  ///< m, before the pose
};

/// About the origin, before the pose.
struct BallRegion {
  float radius = 0.5f;  ///< m, > 0
};

/// The inside of a mesh, by its winding number.
struct MeshRegion {
  std::string file;
  float scale =
      1.0f;  ///< metres a file unit; where the file says how long its unit is, as FBX does, a factor
};

using Region = std::variant<BoxRegion, BallRegion, MeshRegion>;

/// A region filled with particles on a cubic lattice. Points nearer than half a spacing to a solid or cloth
/// that the fluid collides with, and points nearer to a particle that is already there than 0.7 spacings, are
/// left out. Grains are put in disorder: further than a spacing from solids, each is moved by up to a quarter
/// of one along each axis.
struct FluidVolumeDef {
  FluidId fluid;
  Region region = BoxRegion{};
  Pose pose{};
  Vec3 velocity{0, 0, 0};  ///< m/s
};

// ---- probes ----

enum class ProbeKind {
  point_pressure,  ///< Pa, mean of the fluid within a support radius of a point, by kernel; 0 where is none
  wall_pressure,   ///< Pa, wall_force on the patch over ProbeDef::area: friction counts, and it is never < 0
  wall_force,      ///< N, magnitude of the particles' force on a patch of a shape, or on the whole of it
};

/// Measured as the mean over the substeps of a step; of forces, as vectors.
struct ProbeDef {
  std::string name;
  ProbeKind kind = ProbeKind::point_pressure;
  Vec3 point{0, 0, 0};          ///< point_pressure alone
  ShapeId shape{};              ///< wall_pressure and wall_force
  std::optional<Aabb> patch{};  ///< contacts inside this box count; wall_pressure needs it, and its area
  float area = 0.0f;            ///< m², of the patch; wall_pressure alone
};

}  // namespace meniscus
