// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The implementation behind World: its tables, its engine and its read-outs.
#pragma once

#include <meniscus/world.h>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "sdk/engine/engine.h"
#include "sdk/world/check/id_table.h"
#include "sdk/world/cloth/cloth_table.h"
#include "sdk/world/crowding.h"
#include "sdk/world/flow/world_flow.h"
#include "sdk/world/solids/world_shapes.h"

namespace meniscus {

/// A read-out that is fetched from the device on its first request after a change.
template <class T>
struct CachedReadout {
  std::shared_ptr<std::vector<T>> values = std::make_shared<std::vector<T>>();
  bool valid = false;

  template <class Fetch>
  std::span<const T> get(size_t count, const Fetch& fetch) {
    if (!valid) {
      // World::hold() gives the array to others, who may release it on another thread.
      if (values.use_count() > 1) values = std::make_shared<std::vector<T>>();
      std::atomic_thread_fence(std::memory_order_acquire);
      values->resize(count);
      if (count) fetch(std::span<T>(*values));
      valid = true;
    }
    return *values;
  }
};

struct ShapeEntry {
  std::string name;
  Pose pose;
  SolidPieces solid;
  std::optional<Vec3> inside;  ///< m, half extents, of a container
};

struct BodyEntry {
  std::string name;
  BodyMotion motion = BodyMotion::dynamic;
  SolidPieces solid;
  Pose principal;  ///< the frame that the rigid world moves, in the geometry's frame
  BodyMass mass;
  float linear_damping = 0;
};

struct World::Impl {
  explicit Impl(const WorldDef& world_def);

  template <class Call>
  decltype(auto) run(const Call& call);
  pbd::CallMonitor& monitor() { return engine->device().monitor(); }

  EngineDef engine_def();
  float air_density = 1.2f;  // kg/m³, of the wind
  void set_materials();
  void upload_materials();
  FluidId create_material(const ParticleMaterial& material);
  void add(FluidId fluid, std::span<const Vec3> positions, std::span<const Vec3> velocities, Vec3 velocity,
           bool may_crowd);
  void add_to(ParticleBatch& batch, FluidId fluid, Vec3 position, Vec3 velocity) const;
  void append(const ParticleBatch& batch);
  void relax_from(size_t slot);  // moves new particles to their rest density; if that fails, there are none
  void solids_changed();
  void note_repairs(const SolidPieces& solid);
  void
  upload_solids();  // after solids were created or destroyed: all at once, since one costs as much as all
  /// The engine with all solids uploaded, for queries of solids or contacts. Otherwise it would look among
  /// removed solids.
  Engine& with_solids() { return upload_materials(), upload_solids(), *engine; }
  /// The engine with solids and cloth uploaded.
  Engine& with_all() { return with_solids(), upload_probes(), upload_sinks(), upload_cloth(), *engine; }
  SolidContext solid_context() { return {*engine, solid_meshes, def.particle_spacing, kernel.h}; }
  BodyId body_id(uint32_t number) const { return bodies.id(number); }
  ShapeId shape_id(uint32_t number) const { return shapes.id(number); }
  void note_events();
  void forget_touches(bool is_body, uint32_t number);  // removes those of a destroyed object
  void plan_emission(float dt);
  void add_arrivals(const EmitterEntry& emitter, float dt);
  Vec3 carried_velocity(BodyId body, Vec3 p, Quat turned) const;
  double held_steps(const EmitterEntry& emitter, const Departure& departure, float dt) const;
  void emit(float dt, StepReport& report);
  void sinks_changed() { sinks_are_on_device = false; }
  void upload_sinks();
  uint32_t take_sinks();
  void drop_flow_of(BodyId body);
  void probes_changed() { probes_are_on_device = false; }
  void upload_probes();
  void read_probes();
  void state_changed();
  void push_vertices(const VertexRange& range, const char* kind, std::span<const uint32_t> vertices,
                     std::span<const Vec3> impulses);
  void fetch_cloth();   // fetches its latest state to the host
  void upload_cloth();  // uploads it if a call has changed it
  /// Removes points that are nearer than half a spacing to cloth with which the filter collides.
  void keep_off_cloth(std::vector<Vec3>& points, const CollisionFilter& filter);
  void cloth_changed();
  void warn_of_overlaps(std::vector<std::string>& warnings);
  void warn_of_places(std::vector<std::string>& warnings);
  void warn_of_drag(std::vector<std::string>& warnings);
  void warn_of_fields(std::vector<std::string>& warnings);
  void tear_cloth();
  void note_cloth_step(float dt);
  struct WetPiece;
  double particle_mass(FluidId fluid) const;  // kg
  void plan_dripping();
  void wet_cloth(float dt, StepReport& report);
  uint32_t take_up(std::span<const collision::WettingTouch> touches, std::vector<WetPiece>& wet);
  uint32_t drip(Vec3 down, std::vector<WetPiece>& wet);
  void weigh(const VertexRange& range);
  void read_reactions();    // of the last step, to the attachments, while they match those on the device
  void forget_reactions();  // after a step that failed
  std::string name_particle(uint32_t slot) const;
  std::vector<bool> held_vertices(ClothId cloth) const;
  std::vector<bool> held_vertices(RopeId rope) const;
  const VertexRange& range_of(const AttachmentDef& def) const;
  /// Throws Error(capacity) if there is no room for another piece of cloth or rope.
  void check_pieces() const;
  /// Throws if the density solver does not allow these.
  void check_solver_allows(const char* what) const;
  /// Throws if the world has anything that baselines do not allow.
  void check_baseline_suits() const;
  /// Destroys the attachments for which this returns true.
  template <class Gone>
  void drop_attachments(const Gone& gone);
  void drop_attachments_of(BodyId body);
  void remove(const std::vector<bool>& removed);  // by slot; the engine has already removed them

  WorldDef def;
  DeviceInfo device;
  collision::RigidWorld rigid;  // numbers its fixed solids and bodies as shapes and bodies
  fluid::Kernel kernel{};
  std::unique_ptr<Engine> engine;
  bool lost = false;  // a call failed while it changed the world
  double time = 0;
  float last_substep = 0;

  const WorldNumber world_number;
  const uint32_t first_generation = world_number.first_generation();
  IdTable<FluidId, ParticleMaterial> fluids{"fluid", first_generation};  // and granular materials
  IdTable<ShapeId, ShapeEntry> shapes{"shape", first_generation};
  IdTable<BodyId, BodyEntry> bodies{"body", first_generation};
  IdTable<JointId, JointDef> joints{"joint", first_generation};
  SolidMeshes solid_meshes;
  std::vector<MeshRepair> mesh_repairs;
  bool solids_are_on_device = true;            // shapes and bodies
  std::vector<collision::RigidTouch> touches;  // after the last step
  std::vector<ContactEvent> events;            // of the last step
  IdTable<EmitterId, EmitterEntry> emitters{"emitter", first_generation};
  IdTable<SinkId, SinkEntry> sinks{"sink", first_generation};
  bool sinks_are_carried = false;  // a body carries at least one sink
  std::vector<uint32_t> taken;     // by sink, in the last step
  Emission emission;
  IdTable<ProbeId, ProbeDef> probes{"probe", first_generation};
  // Each creation that uploads all before it would make many of them quadratic. So the next use uploads.
  bool materials_are_on_device = false, probes_are_on_device = false, sinks_are_on_device = true;
  std::vector<fluid::ProbeSum> probe_sums;    // in the order of the probes
  std::vector<fluid::ProbeSum> probe_values;  // by the index of their ids

  IdTable<ClothId, ClothEntry> cloths{"cloth", first_generation};
  IdTable<RopeId, RopeEntry> ropes{"rope", first_generation};
  IdTable<AttachmentId, AttachmentEntry> attachments{"attachment", first_generation};
  bool cloth_is_on_device = true;       // all of it, in its present state
  bool cloth_is_on_host = true;         // its latest state
  uint32_t vertex_count = 0;            // on the device
  std::vector<ClothId> pieces;          // on the device, by number; ropes have no id here
  std::vector<uint32_t> held;           // vertices on the device, ascending
  std::vector<ClothId> touched_pieces;  // the pieces of the last step
  bool reactions_known = true;
  uint32_t planned_drips = 0;    // number of drips with room in this step
  float last_step = 0;           // s
  std::vector<TearEvent> tears;  // of the last step

  Crowding crowding;
  ParticleId next_id = 0;
  std::vector<ParticleId> ids;  // by slot, ascending

  CachedReadout<Vec3> positions, velocities;
  CachedReadout<uint32_t> fluid_indices;
  CachedReadout<float> density_errors, full_support, pressures;
  CachedReadout<Ellipsoid> ellipsoids;
  CachedReadout<DiffuseParticle> diffuse;
  EngineMeasure measured;                      // measured with density_errors
  std::optional<fluid::SurfaceField> surface;  // created on request
};

ParticleMaterial material_of(const FluidDef& def);
/// Throws Error(invalid_argument) if a baseline is to have another kernel than the one that it is made for.
void check_baseline_kernel(const WorldDef& def);

/// Throws Error(capacity) if a world with that many particles has no room for `added` more. The message names
/// the emitter that wants most of them, if one does.
void check_room(size_t present, double added, std::string_view emitter = {});

/// Makes the engine for a choice of device, and fills in which device it runs on.
std::unique_ptr<Engine> make_engine(const EngineDef& def, DeviceChoice choice, int threads, DeviceInfo& info);

}  // namespace meniscus
