// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// For C: worlds, their objects, steps and diagnostics.
#pragma once

#include <meniscus/c/defs.h>

#ifdef __cplusplus
extern "C" {
#endif

/// A simulated world on one device: meniscus::World.
typedef struct MeniscusWorld MeniscusWorld;

/// Makes a world. A null definition means the defaults. Destroy it with meniscus_world_destroy().
MENISCUS_C_API MeniscusStatus meniscus_world_create(const MeniscusDef* def, MeniscusWorld** world);
/// Destroys a world and its arrays. Null is allowed.
MENISCUS_C_API void meniscus_world_destroy(MeniscusWorld* world);
/// Makes a copy of the definition of the world. Destroy it with meniscus_def_destroy().
MENISCUS_C_API MeniscusStatus meniscus_def(const MeniscusWorld* world, MeniscusDef** def);
/// Changes the definition from the next step on: World::set_def.
MENISCUS_C_API MeniscusStatus meniscus_set_def(MeniscusWorld* world, const MeniscusDef* def);

/// A device. The texts are valid as arrays are.
typedef struct MeniscusDeviceInfo {
  uint32_t size;          ///< of this struct
  int32_t usable;         ///< 0 or 1
  const char* kind;       ///< "cpu" or "cuda"
  const char* name;       ///< of the processor
  const char* reason;     ///< why it is not usable, or why the world fell back to the CPU
  uint64_t memory_bytes;  ///< of its memory
} MeniscusDeviceInfo;

/// The device of a world.
MENISCUS_C_API MeniscusStatus meniscus_device(MeniscusWorld* world, MeniscusDeviceInfo* info);
/// The device with this number, from 0 on. MENISCUS_NOT_FOUND if there is none. Texts are valid until the
/// next call on this thread.
MENISCUS_C_API MeniscusStatus meniscus_list_device(size_t number, MeniscusDeviceInfo* info);
/// h, m.
MENISCUS_C_API MeniscusStatus meniscus_support_radius(const MeniscusWorld* world, float* radius);
/// kg, of one particle of a fluid or granular material.
MENISCUS_C_API MeniscusStatus meniscus_particle_mass(const MeniscusWorld* world, MeniscusId fluid,
                                                     float* mass);

/// Creates the object that a definition describes: a fluid, granular material, shape, body, joint, cloth,
/// rope, attachment, emitter, sink, probe or force field.
MENISCUS_C_API MeniscusStatus meniscus_create(MeniscusWorld* world, const MeniscusDef* def, MeniscusId* id);
/// Destroys an object of any kind but a fluid. What depends on it is destroyed as in C++.
MENISCUS_C_API MeniscusStatus meniscus_destroy(MeniscusWorld* world, MeniscusId id);
/// Changes a fluid from the next step on: World::set_fluid.
MENISCUS_C_API MeniscusStatus meniscus_set_fluid(MeniscusWorld* world, MeniscusId fluid,
                                                 const MeniscusDef* def);
/// Changes a force field from the next step on: World::set_force_field.
MENISCUS_C_API MeniscusStatus meniscus_set_force_field(MeniscusWorld* world, MeniscusId field,
                                                       const MeniscusDef* def);
/// Changes the wind from the next step on.
MENISCUS_C_API MeniscusStatus meniscus_set_wind(MeniscusWorld* world, const MeniscusDef* wind);

/// Fills a region. `count` is the number of new particles and may be null.
MENISCUS_C_API MeniscusStatus meniscus_add_fluid(MeniscusWorld* world, const MeniscusDef* volume,
                                                 size_t* count);
/// Adds one particle at each position, m. `velocities`, m/s, may be null: then they are at rest. `first` is
/// the first new id and may be null. The other ids follow it.
MENISCUS_C_API MeniscusStatus meniscus_add_particles(MeniscusWorld* world, MeniscusId fluid,
                                                     const MeniscusVec3* positions,
                                                     const MeniscusVec3* velocities, size_t count,
                                                     uint64_t* first);
/// Removes particles. An unknown id is an error.
MENISCUS_C_API MeniscusStatus meniscus_remove_particles(MeniscusWorld* world, const uint64_t* ids,
                                                        size_t count);
/// N·s on each particle, at once. An unknown or repeated id is an error.
MENISCUS_C_API MeniscusStatus meniscus_apply_particle_impulses(MeniscusWorld* world, const uint64_t* ids,
                                                               const MeniscusVec3* impulses, size_t count);
/// Moves the particles to their rest density and keeps no motion. 0 to 100,000 iterations.
MENISCUS_C_API MeniscusStatus meniscus_relax(MeniscusWorld* world, int iterations);

/// Counts and times of one step: meniscus::StepReport.
typedef struct MeniscusStepReport {
  uint32_t size;                      ///< of this struct
  int32_t substeps;                   ///< made
  int32_t iterations;                 ///< per substep
  uint32_t contacts;                  ///< in the last substep
  double density_iterations;          ///< per substep, on average
  double ms;                          ///< wall clock, host and device
  double stage_ms[7];                 ///< on the device, for each stage: see meniscus_stage_name()
  double rigid_ms;                    ///< time of Bullet on the host, contained in ms
  double emission_refused;            ///< m³, that found no room
  uint32_t max_neighbours;            ///< the longest neighbour list so far
  uint32_t removed;                   ///< particles that sinks removed
  uint32_t emitted;                   ///< particles that emitters made
  uint32_t absorbed;                  ///< particles that cloth absorbed
  uint32_t dripped;                   ///< particles that dripped from cloth
  uint32_t diffuse;                   ///< all spray, foam and bubbles
  uint32_t diffuse_refused;           ///< those that were not made for lack of room
  float max_speed;                    ///< m/s
  uint32_t cloth_layer_overflows;     ///< Overflows::cloth_layers
  uint32_t cloth_vertex_overflows;    ///< Overflows::cloth_vertices
  uint32_t fluid_failsafe_overflows;  ///< Overflows::fluid_failsafe
  uint32_t cloth_failsafe_overflows;  ///< Overflows::cloth_failsafe
  uint32_t emitter_hold_overflows;    ///< this and the four above: meniscus::Overflows
} MeniscusStepReport;

/// Advances by dt seconds, at least 1e-12. `report` may be null. After MENISCUS_NON_FINITE the state is that
/// before the call.
MENISCUS_C_API MeniscusStatus meniscus_step(MeniscusWorld* world, float dt, MeniscusStepReport* report);
/// Begins a step. Until meniscus_step_end() other calls of this world but meniscus_cancel() are
/// MENISCUS_INVALID_ARGUMENT: World::step_begin.
MENISCUS_C_API MeniscusStatus meniscus_step_begin(MeniscusWorld* world, float dt);
/// Ends the step that was begun. `report` may be null.
MENISCUS_C_API MeniscusStatus meniscus_step_end(MeniscusWorld* world, MeniscusStepReport* report);
/// meniscus_step() and meniscus_step_begin() with a number of iterations, 1 to 1000, in place of those of the
/// definition and of WorldDef::step_budget_ms.
MENISCUS_C_API MeniscusStatus meniscus_step_iterated(MeniscusWorld* world, float dt, int iterations,
                                                     MeniscusStepReport* report);
/// Likewise.
MENISCUS_C_API MeniscusStatus meniscus_step_begin_iterated(MeniscusWorld* world, float dt, int iterations);
/// The name of a stage of a step, or null from number 7 on.
MENISCUS_C_API const char* meniscus_stage_name(size_t stage);
/// s.
MENISCUS_C_API MeniscusStatus meniscus_time(const MeniscusWorld* world, double* time);
/// Ends the long call that runs, or else the next one, with MENISCUS_CANCELLED. Any thread and signal
/// handlers may call it.
MENISCUS_C_API MeniscusStatus meniscus_cancel(MeniscusWorld* world);
/// `report` is called by long calls, at most ten times a second, with the task and the fraction of it that
/// is done. It may only call meniscus_cancel(). Null ends the reports.
MENISCUS_C_API MeniscusStatus meniscus_set_progress(
    MeniscusWorld* world, void (*report)(const char* what, double fraction, void* user), void* user);
/// What a user probably does not intend, one sentence each: World::warnings.
MENISCUS_C_API MeniscusStatus meniscus_warnings(MeniscusWorld* world, const char* const** texts,
                                                size_t* count);

/// The number of particles that an emitter made or a sink removed.
MENISCUS_C_API MeniscusStatus meniscus_flow_count(const MeniscusWorld* world, MeniscusId id,
                                                  uint32_t* last_step, uint64_t* total);
/// Pa: the mean pressure on the piston of an imposed emitter in the last step; 0 of a free one.
MENISCUS_C_API MeniscusStatus meniscus_emitter_pressure(const MeniscusWorld* world, MeniscusId id,
                                                        double* pressure);
/// The value of a probe in the last step. The value of a vector is its length.
MENISCUS_C_API MeniscusStatus meniscus_probe(const MeniscusWorld* world, MeniscusId id, double* value);
/// The vector of a probe; 0 for kinds without vectors.
MENISCUS_C_API MeniscusStatus meniscus_probe_vector(const MeniscusWorld* world, MeniscusId id,
                                                    MeniscusVec3* value);

/// The state of the particles: meniscus::Diagnostics.
typedef struct MeniscusDiagnostics {
  uint32_t size;                  ///< of this struct
  float max_speed;                ///< m/s
  uint64_t particles;             ///< of fluids and granular materials
  double density_error_mean;      ///< mean of max(C, 0), C = ρ/ρ₀ − 1
  double density_error_max;       ///< largest C
  double density_error_interior;  ///< mean of |C| over particles with a full support
  double neighbours_mean;         ///< particles within the support radius of one
  double kinetic_energy;          ///< J
  double potential_energy;        ///< J, relative to the origin
  uint64_t contacts;              ///< between particles and solids
  uint64_t non_finite;            ///< of particles and vertices
  uint64_t outside;               ///< beyond the wall of a container or inside a solid
  uint64_t wall_overflows;        ///< particles with more than three walls in reach
} MeniscusDiagnostics;

/// Measures the state from the present positions.
MENISCUS_C_API MeniscusStatus meniscus_diagnostics(const MeniscusWorld* world,
                                                   MeniscusDiagnostics* diagnostics);
/// A hash of positions, velocities and rotations. Equal states have equal hashes.
MENISCUS_C_API MeniscusStatus meniscus_state_hash(const MeniscusWorld* world, uint64_t* hash);
/// Bytes held on the device.
MENISCUS_C_API MeniscusStatus meniscus_device_bytes(const MeniscusWorld* world, uint64_t* bytes);

/// Memory of a world on its device for one purpose.
typedef struct MeniscusMemoryShare {
  const char* what;  ///< their purpose
  uint64_t bytes;    ///< their size
} MeniscusMemoryShare;

/// The memory by purpose, the largest first.
MENISCUS_C_API MeniscusStatus meniscus_memory_shares(MeniscusWorld* world, const MeniscusMemoryShare** shares,
                                                     size_t* count);

/// Memory from one allocator: meniscus::MemoryUse.
typedef struct MeniscusMemoryUse {
  uint64_t bytes;        ///< held now
  uint64_t peak_bytes;   ///< most ever held
  uint64_t allocations;  ///< so far
} MeniscusMemoryUse;

/// What a world has taken from its allocators: meniscus::MemoryStats.
typedef struct MeniscusMemoryStats {
  uint32_t size;             ///< of this struct
  MeniscusMemoryUse device;  ///< arrays on the device
  MeniscusMemoryUse shared;  ///< host memory that the device reads and writes as well
} MeniscusMemoryStats;

/// Reads the accounts of the allocators.
MENISCUS_C_API MeniscusStatus meniscus_memory_stats(const MeniscusWorld* world, MeniscusMemoryStats* stats);

#ifdef __cplusplus
}
#endif
