// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Values that a step and the read-outs return: reports, surfaces, diagnostics, devices, memory.
#pragma once

#include <meniscus/types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace meniscus {

/// A particle as a part of the surface of its fluid (Yu & Turk 2013): see World::ellipsoids.
struct Ellipsoid {
  Vec3 centre{0, 0, 0};       ///< m
  Vec3 radii{0, 0, 0};        ///< m, along x, y and z of its frame
  Quat rotation{0, 0, 0, 1};  ///< from its frame to the world's
};

/// The arrays that World::write_particles writes, in the memory of the world's device. On CUDA that is the
/// memory of the GPU. One element a particle, in the order of the ids.
struct ParticleArrays {
  Ellipsoid* ellipsoids = nullptr;  ///< the surface of each particle
  uint32_t* fluids = nullptr;       ///< FluidId::index
  Vec3* velocities = nullptr;       ///< m/s; null: they are not written
};

/// A mesh file whose surface was rebuilt: see MeshGeometry::repair.
struct MeshRepair {
  std::string file;            ///< its path
  float cell_size = 0;         ///< m: no part of either surface is further from the other
  float deviation = 0;         ///< m, the largest distance from the old outer surface to the new one
  double volume_before = 0;    ///< m³, inside the outer surface of the file; fans close its holes
  double volume = 0;           ///< m³, of the new surface
  std::size_t open_edges = 0;  ///< of the file
  std::size_t odd_edges = 0;   ///< of the file, with more than two faces or two that disagree
  std::size_t crossings = 0;   ///< of the file, pairs of faces that cross
};

/// How far a long call is: see World::set_progress.
struct Progress {
  const char* what = "";  ///< the task, as in "step"
  double fraction = 0;    ///< of it, that is done
};

/// The surface of a fluid, closed: each edge belongs to two triangles.
struct SurfaceMesh {
  std::vector<Vec3> vertices;                      ///< m
  std::vector<Vec3> normals;                       ///< unit, one a vertex, out of the fluid
  std::vector<std::array<uint32_t, 3>> triangles;  ///< counter-clockwise as seen from outside
  /// m/s, one a vertex: the mean of the particles there, by their parts of the field. Each component is at
  /// most 8192 m/s.
  std::vector<Vec3> velocities;
};

/// A place in a texture; (0, 0) is its lower left corner, and (1, 1) its upper right.
struct TexturePoint {
  float u, v;  ///< to the right, and up
};

/// What a diffuse particle is.
enum class DiffuseKind : uint32_t { spray, foam, bubble };

/// A particle of spray, foam or a bubble: see DiffuseDef.
struct DiffuseParticle {
  Vec3 position;     ///< m
  Vec3 velocity;     ///< m/s
  float life;        ///< s, remaining
  DiffuseKind kind;  ///< as of the last step
};

/// The stages of a step, in their order; see stage_name.
enum class Stage { predict, neighbours, contacts, solve, velocity, exchange, finish };
inline constexpr std::size_t stage_count = 7;

/// The name of a stage, as in "predict".
const char* stage_name(Stage stage);

/// What exceeded a fixed size in a step, summed over its substeps. The step goes on without the excess.
struct Overflows {
  /// Particles near more than three layers of cloth. They touch the nearest three.
  uint32_t cloth_layers = 0;
  /// Contacts of particles with more than 32 vertices of cloth in reach. At most 32 of these share them.
  uint32_t cloth_vertices = 0;
  /// Particles that six rounds of the fail-safe did not keep from passing through cloth.
  uint32_t fluid_failsafe = 0;
  /// Substeps in which 32 rounds of the fail-safe did not keep cloth apart. All cloth stays where it was.
  uint32_t cloth_failsafe = 0;
  /// Particles from emitters that keep their velocity for 255 steps, in which they do not get far enough.
  uint32_t emitter_hold = 0;
};

/// Counts and times of one step.
struct StepReport {
  int substeps = 0;    ///< made; more than WorldDef::substeps while a fast body is near cloth
  int iterations = 0;  ///< per substep; fewer than WorldDef::iterations with WorldDef::step_budget_ms
  /// Per substep, on average. DensitySolverDef::tolerance can end them early.
  double density_iterations = 0;
  double ms = 0;  ///< wall clock, host and device
  /// On the device, summed over the substeps. With fluids, a GPU finds contacts while it lists neighbours.
  /// `neighbours` then contains both.
  std::array<double, stage_count> stage_ms{};
  double rigid_ms = 0;           ///< time of Bullet on the host, contained in ms
  uint32_t contacts = 0;         ///< in the last substep
  uint32_t max_neighbours = 0;   ///< the longest neighbour list that any particle has needed so far
  uint32_t removed = 0;          ///< particles that sinks removed
  uint32_t emitted = 0;          ///< particles that emitters made
  double emission_refused = 0;   ///< m³, that emitters were to make in this step, and that found no room
  uint32_t absorbed = 0;         ///< particles that cloth absorbed
  uint32_t dripped = 0;          ///< particles that dripped from cloth
  uint32_t diffuse = 0;          ///< all spray, foam and bubbles
  uint32_t diffuse_refused = 0;  ///< those that were not made for lack of room: see DiffuseDef::capacity
  float max_speed = 0;           ///< m/s, of particles and of vertices of cloth and ropes
  Overflows overflows;           ///< what exceeded a fixed size
};

/// The state of the particles, measured from their present positions. The density error is C = ρ/ρ₀ − 1.
/// "Of all" means particles and the vertices of cloth and ropes. Rigid bodies do not count.
struct Diagnostics {
  std::size_t particles = 0;          ///< of fluids and granular materials
  double density_error_mean = 0;      ///< mean of max(C, 0) over all particles
  double density_error_max = 0;       ///< largest C
  double density_error_interior = 0;  ///< mean of |C| over particles with a full support
  double neighbours_mean = 0;         ///< particles within the support radius of one
  double kinetic_energy = 0;          ///< J, of all; vertices that are held have none
  double potential_energy = 0;        ///< J, of all, in the world's gravity, relative to WorldDef::origin;
                                      ///< likewise
  float max_speed = 0;                ///< m/s, of all
  std::size_t contacts = 0;           ///< between particles and solids near enough to count in the density
  std::size_t non_finite = 0;         ///< of all
  std::size_t outside = 0;            ///< of all, beyond the wall of a container or inside a solid
  /// Particles of fluids with more than three walls in reach. The nearest three complete their density.
  std::size_t wall_overflows = 0;
};

/// A device as `meniscus devices` lists it.
struct DeviceInfo {
  std::string kind;              ///< "cpu" or "cuda"
  std::string name;              ///< of the processor
  bool usable = false;           ///< whether worlds can run there
  std::string reason;            ///< why it is not usable
  std::size_t memory_bytes = 0;  ///< of its memory
};

/// All devices of this machine, the CPU last.
std::vector<DeviceInfo> list_devices();

/// Memory from one allocator.
struct MemoryUse {
  std::size_t bytes = 0;       ///< held now
  std::size_t peak_bytes = 0;  ///< most ever held
  uint64_t allocations = 0;    ///< so far; constant over a step that needs no more room
};

/// What a world has taken from its allocators. Tables of the host, such as definitions and Bullet's, come
/// from the heap of the program and are not counted.
struct MemoryStats {
  MemoryUse device;  ///< arrays on the device, with those of snapshots; on the CPU they are host memory
  MemoryUse shared;  ///< host memory that the device reads and writes as well
};

/// Memory of the arrays of a world on its device, by purpose.
struct MemoryShare {
  std::string what;       ///< their purpose
  std::size_t bytes = 0;  ///< their size
};

}  // namespace meniscus
