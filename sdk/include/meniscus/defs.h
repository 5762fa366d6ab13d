// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Definition structs: set the members that differ from the defaults, and pass the struct to World's
// constructor or to a create call. Quantities are in SI units or have none. They keep their meaning when the
// spacing or the time step changes.
#pragma once

#include <meniscus/ids.h>
#include <meniscus/types.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace meniscus {

/// Where a world runs.
enum class DeviceChoice {
  automatic,  ///< CUDA if there is a usable GPU, else the CPU
  cpu,
  cuda,
};

/// Reads a file from where a program keeps its files, such as an archive. It returns the bytes, or none if
/// there is no file of that name. The extension of the name tells the format. It is called within the call
/// that needs the file, on the same thread. What it throws passes through that call.
using FileReader = std::function<std::optional<std::string>(const std::string& name)>;

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

/// How Bullet solves contacts and joints among solids. Stacks with mass ratios up to 1000 need Bullet steps
/// of at most 1 ms and 50 iterations. If a light floating body carries a heavy one, the world's own substeps
/// must be as short. Particles see a body with its own mass, without the bodies that rest on it.
struct RigidSolverDef {
  int substeps = 1;     ///< Bullet steps in a substep, 1 to 1000
  int iterations = 10;  ///< of each, 1 to 10,000
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
};

/// A liquid.
struct FluidDef {
  std::string name = "water";    ///< what World::find_fluid takes
  float rest_density = 1000.0f;  ///< ρ₀, kg/m³, 0.001 to 1e6
  /// μ, Pa·s, 0 to 1e6: implicit, so that any substep is stable. Rigid rotation is not braked. Between two
  /// fluids the harmonic mean acts. Solids and cloth hold the fluid by SurfaceDef::slip_length and
  /// FabricDef::slip_length.
  float dynamic_viscosity = 0.0f;
  /// 1/s: rate at which a particle takes the mean velocity of its neighbours. Its effect vanishes as h². It
  /// acts as a viscosity does, and removes the motion that the density solve leaves in water at rest. In a
  /// pool 0.6 m deep with a spacing of 5 cm, at 4 × 10, the RMS speed is 3.6 % of √(g·H) at 5/s. With 0 it is
  /// 11 %, and more with shorter substeps. The column of hydrostatic.json has 100/s.
  float xsph = 5.0f;
  /// ε, no unit, 0 to 1e6; the force is ε · h · (N × ω). It is no force between pairs, so momentum drifts.
  float vorticity_confinement = 0.0f;
  /// σ, N/m, 0 to 1e6: attraction and curvature (Akinci et al. 2013). The forces are explicit: substeps must
  /// be shorter than √(ρ₀ s³/(2πσ)). Solids and cloth hold fluid against a force that would pull it off them,
  /// and get the opposite force. The same holds for cohesion.
  float surface_tension = 0.0f;
  float cohesion = 0.0f;     ///< N/m, in addition: attraction alone, which holds threads and sheets together
  CollisionFilter filter{};  ///< which solids it collides with
  Vec3 color{0.10f, 0.35f, 0.75f};  ///< linear RGB, 0 to 1
};

/// Sand, gravel and the like: balls of one spacing in diameter that touch with friction and do not rotate
/// (Macklin et al. 2014, Unified Particle Physics, section 6). On solids the friction of the surface counts.
/// Grains do not bounce off one another. In a substep, grains should move no further than half a spacing, or
/// they penetrate one another (see WorldDef::cfl_number). Use 10 iterations. Fewer than 5 make a soft pile.
///
/// In a fluid a grain displaces a spacing cubed. So it floats if it is lighter than the fluid. The viscosity
/// and `xsph` of the fluid drag it along. Densities from a fifth to ten times that of the fluid are tested.
struct GranularDef {
  std::string name = "sand";  ///< what World::find_fluid takes
  float density = 1600.0f;    ///< kg/m³, 0.001 to 1e6, bulk: mass of a grain over a spacing cubed
  /// ≥ 0: tangent of the slope at which a collapsing column comes to rest. Below 0.18 it is that of grains
  /// without friction. A poured heap is up to 5° steeper. The μ of contacts is (friction − 0.18)/1.4, since
  /// balls that do not rotate interlock. Between two materials the geometric mean of their μ counts.
  float friction = 0.6f;
  CollisionFilter filter{};         ///< which solids it collides with
  Vec3 color{0.53f, 0.36f, 0.17f};  ///< linear RGB, 0 to 1
};

/// Which particles World::surface_mesh covers, and how finely.
struct SurfaceMeshDef {
  std::optional<FluidId> fluid{};  ///< or granular material; none: all fluids as one, without grains
  float cell_size = 0.5f;          ///< of marching cubes, spacings, 0.1 to 2
  /// Iso level of the particles' field, 0.2 to 3. At 1 the surface keeps the volume of the fluid, to within
  /// 0.1 spacings of its true place. A smaller level makes it fatter.
  float level = 1.0f;
};

// ---- fixed solids ----

/// Everything with normal · x < offset is solid.
struct PlaneGeometry {
  Vec3 normal{0, 1, 0};  ///< of a length from 1e-6 to 1e18
  float offset = 0;      ///< m
};

/// A solid box about the origin.
struct BoxGeometry {
  Vec3 half_extents{0.5f, 0.5f, 0.5f};  ///< m
};

/// A face of a box, by its axis and side.
enum class Face { x_low, x_high, y_low, y_high, z_low, z_high };

/// A hole in a face of a container, through which fluid leaves. A particle that has left is outside of the
/// container for good. Without a region the whole face is open. The walls around it then continue without
/// end, as in a tall vessel or a channel.
struct Opening {
  Face face = Face::y_high;      ///< the face with the hole
  std::optional<Aabb> region{};  ///< in the container's frame; the extent along the face's normal is ignored
};

/// A box that holds fluid and bodies inside its six faces. Outside of them is solid: for fluid without end,
/// for bodies up to the largest half extent. Use a CollisionFilter for objects beside a container.
struct ContainerGeometry {
  Vec3 half_extents{0.5f, 0.5f, 0.5f};  ///< m, of the inside
  std::vector<Opening> openings{};      ///< at least one face is left
};

/// A solid ball about the origin.
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

/// A closed surface from a mesh file (OBJ, PLY, STL, glTF, FBX, DAE or 3DS), as a signed distance field. The
/// winding number closes holes. The mesh of a dynamic body must have none, unless `repair` is set. For other
/// solids, rays and overlaps, convex parts stand for the mesh of a dynamic body.
struct MeshGeometry {
  std::string file;        ///< its path
  float scale = 1.0f;      ///< metres a file unit; a factor if the file states its unit, as FBX does
  float cell_size = 0.0f;  ///< of the field, m; 0: half a particle_spacing, wider around large meshes
  float max_error = 0.0f;  ///< m; if > 0, the field is refined until its error is no larger
  /// Rebuilds the surface where the mesh has open edges, edges of more than two faces, or faces that cross.
  /// World::mesh_repairs says how well both agree.
  bool repair = false;
  int convex_parts = 32;  ///< of a dynamic body, at most, 1 to 256; 1: the convex hull
  /// In place of the file, which is then a name: vertices in units of `scale`, three of them a triangle.
  std::vector<Vec3> vertices{};
  std::vector<uint32_t> triangles{};  ///< three vertices each
};

/// The convex hull of points. For solids, rays and overlaps it has at most 200 of them, the outermost.
struct HullGeometry {
  std::vector<Vec3> points;  ///< m, at least 4, not in a plane
};

/// Several solids as one. If parts overlap, the mass of both counts.
struct CompoundGeometry {
  std::vector<struct CompoundPart> parts;  ///< the solids
};

/// Heights over a regular grid in x and z, centred at the origin. It is solid below.
struct HeightFieldGeometry {
  int columns = 0;               ///< samples along x, 2 to 32,768
  int rows = 0;                  ///< samples along z, 2 to 32,768
  float cell_size = 0.1f;        ///< m
  std::vector<float> heights{};  ///< m, columns · rows of them, x fastest
};

/// The shape of a solid.
using Geometry =
    std::variant<PlaneGeometry, BoxGeometry, ContainerGeometry, SphereGeometry, CapsuleGeometry,
                 CylinderGeometry, MeshGeometry, HeightFieldGeometry, HullGeometry, CompoundGeometry>;

/// One of the solids of a compound.
struct CompoundPart {
  Geometry geometry = BoxGeometry{};  ///< no plane, container, height field or compound
  Pose pose{};                        ///< in the frame of the compound
};

/// Contact parameters of a solid. Between two solids the geometric mean counts.
struct SurfaceDef {
  float friction = 0.0f;     ///< Coulomb's μ for particles, ≥ 0
  float restitution = 0.0f;  ///< for particles, 0 to 1
  float adhesion = 0.0f;     ///< Pa, ≥ 0: pull on a wet layer of particles
  /// m, ≥ 0: how viscous fluid slips along the surface. Its velocity, continued linearly, is that of the
  /// solid this deep behind the surface. 0: no slip; infinite: free.
  float slip_length = std::numeric_limits<float>::infinity();
  float solid_friction = 0.5f;     ///< Coulomb's μ for solids, ≥ 0
  float solid_restitution = 0.0f;  ///< for solids, 0 to 1
  /// m/s, in the world's frame, of fixed shapes alone: the surface moves along itself like a belt, while the
  /// shape stays. It carries particles and cloth by friction, and viscous fluid by `slip_length`. The part
  /// along the normal does not count. Bodies do not feel it.
  Vec3 belt_velocity{0, 0, 0};
};

/// A solid that does not move.
struct ShapeDef {
  std::string name{};                   ///< what World::find_shape takes
  Geometry geometry = PlaneGeometry{};  ///< what it is
  Pose pose{};                          ///< of the geometry's frame
  SurfaceDef surface{};                 ///< its contacts with particles, cloth and bodies
  CollisionFilter filter{};             ///< what collides with it
};

// ---- fluid volumes ----

/// A box.
struct BoxRegion {
  /// m, before the pose; lower ≤ upper in every component; where they are equal it is empty
  Vec3 lower{-0.5f, -0.5f, -0.5f}, upper{0.5f, 0.5f, 0.5f};  ///< corners
};

/// About the origin, before the pose.
struct BallRegion {
  float radius = 0.5f;  ///< m, > 0
};

/// The inside of a mesh, by its winding number.
struct MeshRegion {
  std::string file;    ///< its path
  float scale = 1.0f;  ///< metres a file unit; a factor if the file states its unit, as FBX does
  /// In place of the file, which is then a name: vertices in units of `scale`, three of them a triangle.
  std::vector<Vec3> vertices{};
  std::vector<uint32_t> triangles{};  ///< three vertices each
};

/// A region that fluid can fill.
using Region = std::variant<BoxRegion, BallRegion, MeshRegion>;

/// How the particles of a volume are placed.
enum class Seeding {
  lattice,     ///< on a cubic lattice, a crystal until motion melts it
  disordered,  ///< without order and at rest density, as in water that has been stirred
};

/// A region that is filled with particles. Those nearer than half a spacing to a solid or cloth that the
/// fluid collides with are left out. So are those nearer than 0.7 spacings to an existing particle. Grains
/// are disordered: further than a spacing from solids, each is moved by up to a quarter of a spacing along
/// each axis.
///
/// With Seeding::disordered, as many particles as the free volume over s³ says fill the region, to 0.1 %
/// where the volume has more than a few thousand. They are relaxed against each other, the region's boundary,
/// solids and existing particles. The same call gives the same positions. For fluids alone.
struct FluidVolumeDef {
  FluidId fluid;                       ///< or granular material
  Region region = BoxRegion{};         ///< what to fill
  Pose pose{};                         ///< of the region
  Vec3 velocity{0, 0, 0};              ///< m/s
  Seeding seeding = Seeding::lattice;  ///< how the particles are placed
};

// ---- probes ----

/// What a probe measures.
enum class ProbeKind {
  point_pressure,  ///< Pa, kernel-weighted mean within a support radius of a point; 0 without fluid
  wall_pressure,   ///< Pa, wall_force on the patch over ProbeDef::area; contains friction, never < 0
  wall_force,      ///< N, vector: the particles' force on a patch of a shape or on all of it
  wall_torque,     ///< N·m, vector: of the same forces, about ProbeDef::point
  point_velocity,  ///< m/s, vector: mean of the particles within a support radius of a point; 0 without any
  point_density,   ///< kg/m³, of all particles within a support radius of a point; less beside walls
  flow,            ///< m³/s through a disc, along its normal
  /// m: height of the free surface over a point, in a column along a normal. The column counts from the point
  /// up to the first layer that is less than half full, so that spray above the pool does not count.
  level,
  fluid_momentum,          ///< kg·m/s, vector
  fluid_angular_momentum,  ///< kg·m²/s, vector, about ProbeDef::point
  fluid_centre,            ///< m, vector: centre of mass; 0 without particles
};

/// A measurement: the mean over the substeps of a step. Forces are averaged as vectors.
struct ProbeDef {
  std::string name{};                          ///< what World::find_probe takes
  ProbeKind kind = ProbeKind::point_pressure;  ///< what it measures
  Vec3 point{0, 0, 0};             ///< m; not of wall_pressure, wall_force, fluid_momentum and fluid_centre
  Vec3 normal{0, 1, 0};            ///< flow and level alone; of a length from 1e-6 to 1e18
  float radius = 0.0f;             ///< m, > 0, of the disc or column; flow and level alone
  std::optional<FluidId> fluid{};  ///< or granular material; none: all. fluid_* alone
  ShapeId shape{};                 ///< wall_* alone
  std::optional<Aabb> patch{};     ///< contacts inside this box count; wall_pressure needs it and its area
  float area = 0.0f;               ///< m², of the patch; wall_pressure alone
};

}  // namespace meniscus
