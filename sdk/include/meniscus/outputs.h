// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <meniscus/types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace meniscus {

/// A particle as a piece of its fluid's surface (Yu & Turk 2013): see World::ellipsoids.
struct Ellipsoid {
  Vec3 centre{0, 0, 0};       ///< m
  Vec3 radii{0, 0, 0};        ///< m, along x, y and z of its frame
  Quat rotation{0, 0, 0, 1};  ///< from its frame to the world's
};

/// Where World::write_particles writes to, in the memory of the world's device: that of the GPU on CUDA. One
/// element a particle, in the order of the ids.
struct ParticleArrays {
  Ellipsoid* ellipsoids = nullptr;
  uint32_t* fluids = nullptr;  ///< FluidId::index
};

/// The surface of a fluid, closed: each edge belongs to two triangles.
struct SurfaceMesh {
  std::vector<Vec3> vertices;                      ///< m
  std::vector<Vec3> normals;                       ///< unit, one a vertex, out of the fluid
  std::vector<std::array<uint32_t, 3>> triangles;  ///< corners turn counter-clockwise as seen from outside
};

enum class DiffuseKind : uint32_t { spray, foam, bubble };

/// A piece of air and water: see DiffuseDef.
struct DiffuseParticle {
  Vec3 position;     ///< m
  Vec3 velocity;     ///< m/s
  float life;        ///< s that are left
  DiffuseKind kind;  ///< as of the last step
};

/// The stages of a step, in their order; see stage_name.
enum class Stage { predict, neighbours, contacts, solve, velocity, exchange, finish };
inline constexpr std::size_t stage_count = 7;

const char* stage_name(Stage stage);

/// What one step did and cost.
struct StepReport {
  int substeps = 0;
  int iterations = 0;  ///< per substep
  /// Per substep, on average: fewer where DensitySolverDef::tolerance ends them.
  double density_iterations = 0;
  double ms = 0;  ///< wall clock, host and device
  /// On the device, summed over the substeps. Where there are fluids, a GPU finds contacts while it lists
  /// neighbours: `neighbours` is then both.
  std::array<double, stage_count> stage_ms{};
  double rigid_ms = 0;           ///< of ms, what Bullet took on the host
  uint32_t contacts = 0;         ///< in the last substep
  uint32_t max_neighbours = 0;   ///< the fullest neighbour list that a particle ever needed
  uint32_t removed = 0;          ///< particles that sinks took
  uint32_t emitted = 0;          ///< particles that emitters made
  uint32_t absorbed = 0;         ///< particles that cloth took up
  uint32_t dripped = 0;          ///< particles that fell from it
  uint32_t diffuse = 0;          ///< spray, foam and bubbles, in all
  uint32_t diffuse_refused = 0;  ///< that found no room: see DiffuseDef::capacity
  float max_speed = 0;           ///< m/s, of particles and of vertices of cloth and ropes
};

/// The state of the particles, measured afresh from their positions. Density error is C = ρ/ρ₀ − 1. What says
/// `all` counts vertices of cloth and ropes as well; rigid bodies are in none.
struct Diagnostics {
  std::size_t particles = 0;          ///< of fluids and granular materials
  double density_error_mean = 0;      ///< mean of max(C, 0) over all particles
  double density_error_max = 0;       ///< largest C
  double density_error_interior = 0;  ///< mean of |C| over particles whose support is full
  double neighbours_mean = 0;         ///< particles within the support radius of one
  double kinetic_energy = 0;          ///< J, of all; what is held fast has none
  double potential_energy = 0;        ///< J, of all, in the world's gravity, from the origin; likewise
  float max_speed = 0;                ///< m/s, of all
  std::size_t contacts = 0;           ///< between particles and solids near enough to count in the density
  std::size_t non_finite = 0;         ///< of all
  std::size_t outside = 0;            ///< of all, beyond a container's wall, or inside a solid
};

/// A device as `meniscus devices` lists it.
struct DeviceInfo {
  std::string kind;  ///< "cpu" or "cuda"
  std::string name;
  bool usable = false;
  std::string reason;  ///< why it is not usable
  std::size_t memory_bytes = 0;
};

std::vector<DeviceInfo> list_devices();

/// Arrays of a world on its device, by what they are for.
struct MemoryShare {
  std::string what;
  std::size_t bytes = 0;
};

}  // namespace meniscus
