// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The simulation behind a World, with its device hidden. A slot is a particle's place in the user's arrays.
#pragma once

#include <meniscus/hooks.h>
#include <meniscus/host.h>
#include <meniscus/ids.h>
#include <meniscus/outputs.h>

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "sdk/engine/engine_types.h"

namespace meniscus {

/// The particles of one rank of a shared world.
struct OwnParticles {
  std::vector<uint32_t> slots;
  std::vector<Vec3> positions, velocities;  ///< m, m/s
  std::vector<uint32_t> fluids;
  std::vector<float> density_errors;  ///< C = ρ/ρ₀ − 1
  std::vector<float> pressures;       ///< Pa
  std::vector<DiffuseParticle> diffuse;
};

class Engine {
 public:
  virtual ~Engine() = default;

  virtual pbd::Device& device() = 0;
  /// Of the device, for others: see pbd::DeviceAccess. Throws Error(out_of_memory).
  virtual int ordinal() const = 0;
  virtual void* stream() = 0;
  virtual std::shared_ptr<void> allocate_lasting(size_t bytes) = 0;

  /// Sets the parameters of the solvers from the next step on. Kernel, spacing and radii must stay. Set the
  /// cloth anew afterwards.
  virtual void set_solvers(const EngineDef& def) = 0;
  /// The materials, by group.
  virtual void set_materials(std::span<const ParticleMaterial> materials) = 0;
  /// Adds a field, to which shapes refer by its number. With `max_error` > 0 the field is as fine as that
  /// needs, otherwise it has this cell size; both in m.
  virtual uint32_t add_sdf(const collision::TriangleMesh& mesh, float cell_size, float max_error,
                           float margin) = 0;
  virtual uint32_t add_height_field(uint32_t columns, uint32_t rows, float cell_size,
                                    std::span<const float> heights) = 0;
  virtual void remove_sdf(uint32_t number) = 0;
  virtual std::size_t sdf_nodes(uint32_t number) const = 0;
  virtual void remove_height_field(uint32_t number) = 0;
  virtual void set_shapes(const SolidShapes& solids) = 0;
  /// Call it after bodies were placed by a call of the user.
  virtual void place_bodies() = 0;
  /// Force (N) and torque (N·m) of the particles on each body, mean over the last step.
  virtual std::span<const collision::RigidImpulse> body_forces() const = 0;
  /// The contacts of the last substep with an effect, in the order of the slots.
  virtual std::vector<ContactReadout> read_contacts() = 0;
  /// Removes the contacts of a destroyed solid, and their force in body_forces(). The number may be used
  /// again. Changes nothing if it throws.
  virtual void forget_contacts(uint32_t solid, TouchedKind kind) = 0;
  /// The state of all parts on the device (pbd/state/state_visitor.h). To restore it, first set the
  /// materials, shapes and cloth with which it was saved, restore the rigid world, and call place_bodies().
  virtual void visit_state(pbd::StateVisitor& v) = 0;
  virtual void set_sinks(std::span<const Sink> sinks) = 0;
  /// Removes the particles that the sinks take. Returns which are gone, by their former slot; empty if none
  /// is. Counts by sink: a particle counts for the first sink that takes it.
  /// `takers` gets the number of the sink by former slot, if any are gone.
  virtual std::vector<bool> take_sinks(std::span<uint32_t> taken, std::vector<uint32_t>& takers) = 0;
  /// Replaces all force fields. `body_densities` is by body, kg/m³.
  virtual void set_force_fields(std::span<const ForceFieldModel> fields,
                                std::span<const float> body_densities, const VertexVolumes& volumes) = 0;
  virtual void set_probes(std::span<const fluid::Probe> probes) = 0;
  virtual void read_probes(std::span<fluid::ProbeSum> means) = 0;

  /// The points of the cubic lattice with this spacing that lie inside the mesh.
  virtual std::vector<Vec3> fill_mesh(const collision::TriangleMesh& mesh, float spacing) = 0;
  /// Signed distance of each point to the nearest solid with which this filter collides.
  virtual std::vector<float> solid_distances(std::span<const Vec3> points, float reach,
                                             const CollisionFilter& filter) = 0;
  /// The nearest solid within `reach` of a point.
  virtual std::optional<NearestSolid> nearest_solid(Vec3 point, float reach) = 0;

  /// Replaces all cloth and ropes.
  virtual void set_cloth(const EngineCloth& cloth) = 0;
  virtual void set_wind(const cloth::Wind& wind) = 0;
  /// By vertex, m and m/s.
  virtual void read_vertices(std::span<Vec3> positions, std::span<Vec3> velocities) = 0;
  virtual std::vector<cloth::SegmentState> read_segments() = 0;
  /// By held vertex, N·s over the last step.
  virtual std::vector<Vec3> read_reactions() = 0;
  /// By attachment, N·s on its vertex over the last step.
  virtual std::vector<Vec3> read_attachment_impulses() = 0;
  /// Particles that touched absorbent cloth at the last step's end, by slot. Call it before particles are
  /// added or removed.
  virtual std::vector<collision::WettingTouch> read_wetting() = 0;
  /// Sets inverse masses (1/kg) and velocities (m/s) of the vertices from `first` on. Held vertices stay as
  /// they are.
  virtual void weigh_vertices(uint32_t first, std::span<const float> inverse_masses,
                              std::span<const Vec3> velocities) = 0;
  /// Whether an edge exceeded its tear strain in the last step.
  virtual bool found_tears() = 0;
  /// By piece of cloth: see World::cloth_bending_fraction.
  virtual const std::vector<float>& bending_fractions() const = 0;

  virtual uint32_t particle_count() const = 0;
  /// Reserves memory so that this many more can be added or asked about.
  virtual void make_room(uint32_t more) = 0;
  /// Finds whether each arrival has room beside all particles, all solids, and earlier arrivals with room. An
  /// arrival that has waited gives its velocity to particles that are too near, for the next step.
  virtual void find_room(std::span<const Arrival> arrivals, std::vector<uint8_t>& has_room) = 0;
  virtual void append(const ParticleBatch& batch) = 0;
  /// The pistons of the next steps and their particles, by ascending slot. They replace those before.
  virtual void set_pistons(std::span<const Piston> pistons, std::span<const PistonParticle> particles) = 0;
  /// Keeps the particles with keep[slot]; the rest of the slots close up.
  virtual void keep(const std::vector<bool>& keep) = 0;

  /// If the result's summary counts non-finite particles, the state is that before the call.
  EngineStep step(float dt, int iterations) {
    begin_step(dt, iterations);
    return end_step();
  }
  /// The two halves of step(). Nothing else may be called between them but send_step().
  virtual void begin_step(float dt, int iterations) = 0;
  virtual EngineStep end_step() = 0;
  /// Sends the device all of the step that was begun, since the host turns to other work.
  void send_step() { device().send_off(); }
  /// Calls of the user by hook; empty ones are not called.
  virtual void set_hooks(const HookCalls& calls) = 0;
  virtual void relax(float dt, int iterations) = 0;
  /// The same for the particles from a slot on alone. All others stay, and all velocities.
  virtual void relax_from(uint32_t slot, float dt, int iterations) = 0;

  /// Applies impulses (N·s) at once, to fluid particles in these slots, which ascend, or to these vertices.
  virtual void push_particles(std::span<const uint32_t> slots, std::span<const Vec3> impulses) = 0;
  virtual void push_vertices(std::span<const uint32_t> vertices, std::span<const Vec3> impulses) = 0;

  /// Gives fluid particles and grains in these slots, which ascend, other positions (m). They are as new ones
  /// there, and nothing is carried over from the last substep.
  virtual void place_particles(std::span<const uint32_t> slots, std::span<const Vec3> positions) = 0;
  /// Gives them other velocities (m/s).
  virtual void set_particle_velocities(std::span<const uint32_t> slots, std::span<const Vec3> velocities) = 0;

  // Batches of worlds (pbd/worlds.h). By slot, particles of a world follow one another.
  /// The rigid worlds of the bodies.
  virtual collision::RigidWorlds& rigid_worlds() = 0;
  /// Makes so many worlds of the present state, which must be of fluids, grains, fixed shapes, bodies
  /// and cloth. There are as many rigid worlds already, and `solids` are those of all worlds. `cloth` is that
  /// of one. Then steps with particles, vertices or bodies that are not finite are not undone.
  virtual void make_worlds(const SolidShapes& solids, const EngineCloth& cloth,
                           const VertexNumbers& numbers) = 0;
  /// What the next step starts from. It must be the same for all worlds that step.
  virtual LastSubsteps last_substeps() const = 0;
  virtual void continue_from(const LastSubsteps& last) = 0;
  /// By world of a batch: the number of substeps that a step of dt seconds needs. A step takes the largest
  /// number of all worlds that step.
  virtual void find_substeps(float dt, std::span<int> out) = 0;
  /// Call it after bodies of the worlds with chosen ≠ 0 were placed by a call of the user.
  virtual void place_worlds(std::span<const uint32_t> chosen) = 0;
  /// m/s², by world.
  virtual void set_gravities(std::span<const Vec3> gravities) = 0;
  /// Gives the state at make_worlds() to worlds with chosen ≠ 0.
  virtual void reset_worlds(std::span<const uint32_t> chosen) = 0;
  /// Gives them the state before the last step.
  virtual void undo_worlds(std::span<const uint32_t> chosen) = 0;
  /// By world: the number of particles and vertices that are not finite, and one more if a body was not.
  virtual void count_non_finite(std::span<uint32_t> counts) = 0;
  /// By world: hash_particles() of it alone, and the hashes of its vertices.
  virtual void hash_worlds(std::span<uint64_t> hashes) = 0;
  /// The state of all worlds' particles, and the forces on their bodies. A batch that restores it has as many
  /// worlds of the same archetype. Then its bodies are to be placed by place_worlds().
  virtual void visit_worlds(pbd::StateVisitor& v) = 0;
  virtual EngineWorld read_world(uint32_t world) = 0;
  /// Replaces the particles of one world by as many, and the forces of its bodies.
  virtual void write_world(uint32_t world, const EngineWorld& state) = 0;
  /// Whether particles that were placed too dense have not parted yet.
  virtual bool any_crowd() const = 0;
  /// Writes positions and velocities as write_arrays() does, without groups and ids.
  virtual void write_vectors(Vec3* positions, Vec3* velocities) = 0;
  /// The same for vertices.
  virtual void write_vertices(Vec3* positions, Vec3* velocities) = 0;

  // By slot.
  virtual void read_positions(std::span<Vec3> out) = 0;
  virtual void read_velocities(std::span<Vec3> out) = 0;
  virtual void read_fluids(std::span<uint32_t> out) = 0;
  /// The hash sum of all fluid particles, from number, position and velocity; see World::state_hash.
  virtual uint64_t hash_particles() = 0;
  virtual void read_pressures(std::span<float> out, float dt) = 0;
  /// C, and 1 for particles with full support, measured afresh.
  virtual EngineMeasure read_density_errors(std::span<float> error, std::span<float> full) = 0;
  /// Writes ellipsoids and groups, by slot, to the device's own memory. It uses the neighbours of the last
  /// substep if they belong to the present particles. Then it waits neither for other work nor for its own
  /// end.
  virtual void write_particles(const ParticleArrays& arrays) = 0;
  /// Writes positions and velocities, in the user's frame, groups and these ids, by slot, to arrays in the
  /// device's memory. Does not wait for that.
  virtual void write_arrays(const EngineArrays& arrays, std::span<const ParticleId> ids) = 0;
  virtual void read_ellipsoids(std::span<Ellipsoid> out) = 0;
  /// The surface of one material, or of all fluids.
  virtual SurfaceMesh read_surface(const fluid::SurfaceField& field, std::optional<uint32_t> group) = 0;
  virtual uint32_t diffuse_count() const = 0;
  virtual uint32_t diffuse_refused() const = 0;  ///< in the last step
  virtual void read_diffuse(std::span<DiffuseParticle> out) = 0;
  /// Measures all diagnostics that need no neighbours.
  virtual Diagnostics measure(Vec3 gravity) = 0;

  // A shared world (sdk/world/shared/shared_world.h).
  /// Keeps the particles of append() on the host until share(), so that the device gets those of its rank
  /// alone. Nothing but append(), read_positions(), particle_count() and what needs no particles is allowed
  /// until share() or release(). There must be no particles.
  virtual void hold_back() = 0;
  /// Brings them to the device after all.
  virtual void release() = 0;
  virtual uint32_t own_particles() const = 0;  ///< of this rank
  /// Also readies visit_state() for a save.
  virtual std::vector<uint32_t> particles_by_rank() = 0;
  /// All ranks call it at the same time, while none follows: the values of its own particles. `slots` says
  /// which they are.
  virtual OwnParticles read_own_particles() = 0;
  /// Each rank writes its particles into a file that is there: of array k of particle_items
  /// (particle_items.h) behind those of the ranks before it, from offsets[k] on. Returns hashes of the parts,
  /// by array and then by rank. Throws Error(io).
  virtual std::vector<uint64_t> write_particle_items(const std::string& file,
                                                     std::span<const uint64_t> offsets) = 0;

  /// Keeps this rank's particles. All ranks have made the same calls so far. From now on only steps and
  /// read-outs of particles may be called: by rank 0, while the others follow.
  virtual void share(pbd::Ranks& ranks, const pbd::CutPolicy& policy) = 0;
  /// Does what rank 0 asks for, until it ends or pauses that. Returns whether it only pauses.
  virtual bool follow() = 0;
  virtual void pause_following() = 0;
  virtual void end_following() = 0;
};

/// On threads of its own, or in a loop of the user's if there is one.
std::unique_ptr<Engine> make_cpu_engine(const EngineDef& def, int threads, const ParallelFor& loop = {});
/// On the GPU with this ordinal, and on the caller's stream if there is one.
std::unique_ptr<Engine> make_cuda_engine(const EngineDef& def, int ordinal, void* stream);

}  // namespace meniscus
