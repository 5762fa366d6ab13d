// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The implementation behind World: its tables, its engine and its read-outs.
#pragma once

#include <meniscus/world.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "sdk/engine/engine.h"
#include "sdk/world/host/log.h"
#include "sdk/world/host/step_budget.h"
#include "sdk/world/recording/recorder.h"
#include "sdk/world/state/snapshot_data.h"
#include "sdk/world/state/world_tables.h"

namespace meniscus {

struct BodyCalls;
struct Definitions;

/// A read-out that is fetched from the device on its first request after a change.
template <class T>
struct CachedReadout {
  struct Array {
    std::vector<T> values;
    std::atomic<uint32_t> holders = 0;  ///< that hold() gave it to and that have not released it
  };
  std::shared_ptr<Array> array = std::make_shared<Array>();
  bool valid = false;

  template <class Fetch>
  std::span<const T> get(size_t count, const Fetch& fetch) {
    if (!valid) {
      if (array->holders.load(std::memory_order_acquire)) array = std::make_shared<Array>();
      array->values.resize(count);
      if (count) fetch(std::span<T>(array->values));
      valid = true;
    }
    return array->values;
  }

  /// Keeps the array as it is until the owner is released, on any thread.
  std::shared_ptr<const void> hold() const {
    array->holders.fetch_add(1, std::memory_order_relaxed);
    const auto release = [held = array](const void*) {
      held->holders.fetch_sub(1, std::memory_order_release);
    };
    return {static_cast<const void*>(array->values.data()), release};
  }
};

struct HookEntry {
  HookId id;  ///< its upper half is the first generation of the world that made it
  Hook hook;
  SubstepCall call;
  std::shared_ptr<const WorldNumber> maker;  ///< of that world: no other gets its number while this is here
};

struct World::Impl : WorldTables {
  explicit Impl(const WorldDef& world_def);
  ~Impl();

  /// `name` is that of the public call.
  template <class Call>
  decltype(auto) run(const Call& call, const char* name = __builtin_FUNCTION());
  template <class Call>
  decltype(auto) run_removal(const Call& call, const char* name = __builtin_FUNCTION());
  template <class Call>
  decltype(auto) run_end_of_step(const Call& call);
  /// run(), for a call that changes the state, with its arguments for the recording.
  template <class Call, class... Args>
  auto recorded(const RecordedAs& as, const Call& call, const Args&... args);
  /// The same for a call that removes.
  template <class Call, class... Args>
  auto recorded_removal(const RecordedAs& as, const Call& call, const Args&... args);
  void note_step(float dt, const StepReport& report);
  void note_state();
  void warn_of_hooks() const;
  void settle();  // carries removals out; if it throws, all are still to be carried out
  pbd::CallMonitor& monitor() { return engine->device().monitor(); }

  EngineDef engine_def();
  void set_materials();
  void upload_materials();
  FluidId create_material(const ParticleMaterial& material);
  void add(FluidId fluid, std::span<const Vec3> positions, std::span<const Vec3> velocities, Vec3 velocity,
           bool may_crowd);
  void add_to(ParticleBatch& batch, FluidId fluid, Vec3 position, Vec3 velocity) const;
  void append(const ParticleBatch& batch);
  void relax_from(size_t slot);  // moves new particles to their rest density; if that fails, there are none
  ShapeEntry make_shape(const ShapeDef& shape, const collision::RigidPlace& place);
  BodyEntry make_body(const BodyDef& body, const collision::RigidPlace& place);
  BodyCalls calls_of(BodyId id);
  SolidShapes solid_shapes() const;
  void solids_changed();
  void note_revision() { solids_revision = ++last_revision; }
  void note_repairs(const SolidPieces& solid);
  void
  upload_solids();  // after solids were created or destroyed: all at once, since one costs as much as all
  /// The engine with all solids uploaded, for queries of solids or contacts. Otherwise it would look among
  /// removed solids.
  Engine& with_solids() { return upload_materials(), upload_solids(), *engine; }
  /// The engine with all that it needs for a step uploaded.
  Engine& with_all() {
    return with_solids(), upload_probes(), upload_sinks(), upload_cloth(), upload_forces(), upload_pistons(),
           *engine;
  }
  SolidContext solid_context() {
    return {*engine, solid_meshes, def.particle_spacing, kernel.h, def.read_file};
  }
  BodyId body_id(uint32_t number) const { return bodies.id(number); }
  ShapeId shape_id(uint32_t number) const { return shapes.id(number); }
  void forget_touches();
  void note_events();
  void note_sleep();
  void forget_solid(const collision::RigidRef& solid);
  void plan_emission(float dt);
  void add_arrivals(const EmitterEntry& emitter, float dt);
  Vec3 carried_velocity(BodyId body, Vec3 p, Quat turned) const;
  double held_steps(const EmitterEntry& emitter, const Departure& departure, float dt) const;
  void emit(float dt, StepReport& report);
  void check_imposed(const EmitterDef& emitter) const;
  void check_solver_pushes(DensitySolver solver) const;
  bool has_imposed() const;
  double most_stroke(const EmitterEntry& emitter, float dt) const;
  double plan_ducts(float dt);
  void upload_pistons();
  void advance_ducts(std::span<const PistonReading> readings, float dt, StepReport& report);
  void pass_layer(EmitterEntry& emitter, EmitterId id);
  void follow_up(EmitterEntry& emitter, float dt);
  void close_duct(EmitterEntry& emitter, EmitterId id);
  std::vector<bool> particles_in(const EmitterEntry& emitter) const;
  void sinks_changed() { sinks_are_on_device = false; }
  void upload_sinks();
  void forces_changed() { forces_are_on_device = false; }
  void upload_forces();
  uint32_t take_sinks();
  void note_removals(const std::vector<bool>& removed);
  void drop_flow_of(BodyId body);
  void probes_changed() { probes_are_on_device = false; }
  void upload_probes();
  void read_probes();
  void state_changed();
  void push_vertices(const VertexRange& range, const char* kind, std::span<const uint32_t> vertices,
                     std::span<const Vec3> impulses);
  /// `others`: where the particles in no slot of these are.
  void place(std::span<const uint32_t> slots, std::span<const Vec3> positions,
             const std::function<std::vector<Vec3>()>& others);
  void set_particle_velocities(std::span<const uint32_t> slots, std::span<const Vec3> values);
  void place_vertices(VertexRange& range, std::span<const Vec3> positions);
  void set_vertex_velocities(VertexRange& range, std::span<const Vec3> velocities);
  void fetch_cloth();   // fetches its latest state to the host
  void upload_cloth();  // uploads it if a call has changed it
  /// Removes points that are nearer than half a spacing to cloth with which the filter collides, or inside of
  /// a closed driven surface.
  void keep_off_cloth(std::vector<Vec3>& points, const CollisionFilter& filter);
  void cloth_changed();
  void set_engine_cloth();  // gives the engine what `uploaded_cloth` has
  /// A rigid world with the solids and joints of the tables, in the places of the layout.
  static void make_rigid(collision::RigidWorld& made, const WorldTables& tables,
                         const collision::RigidLayout& layout);
  void restore(WorldTables&& tables, const Snapshot::Data& data);
  /// Gives the engine and the rigid world the state of the tables. `visit_engine` restores the engine's.
  void restore_engine(const collision::RigidWorld::Snapshot& rigid_state, bool sets_cloth,
                      const std::function<void()>& visit_engine);
  void visit_contents(pbd::StateVisitor& v, collision::RigidWorld::Snapshot& rigid_state, EngineCloth& cloth);
  void fill_from(const std::string& definitions, const pbd::SavedState& saved);
  void make_solids(const Definitions& defs, const collision::RigidLayout& layout);
  void warn_of_overlaps(std::vector<std::string>& warnings);
  void warn_of_places(std::vector<std::string>& warnings);
  void warn_of_drag(std::vector<std::string>& warnings);
  void warn_of_fields(std::vector<std::string>& warnings);
  void log_before_steps();
  void log_step(const StepReport& report);
  void set_hooks(std::vector<HookEntry> all);
  void take_callbacks(const Impl& other);  // hooks with their ids, and the progress call
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
  /// What the world holds: by index of the cloth or rope, its vertices, and the segments of ropes.
  struct HeldParts {
    std::vector<std::vector<bool>> of_cloth, of_rope, clamped;
  };
  HeldParts find_held() const;
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
  void drop(const std::vector<bool>& removed);    // by slot
  void remove(const std::vector<bool>& removed);  // by slot; the engine has already removed them

  DeviceInfo device;
  collision::RigidWorld rigid;  // numbers its fixed solids and bodies as shapes and bodies
  fluid::Kernel kernel{};
  std::unique_ptr<Engine> engine;
  bool lost = false;         // a call failed while it changed the world
  bool is_stepping = false;  // between step_begin() and step_end()
  bool has_begun = false;    // a first step
  float begun_step = 0;      // s, of the step that was begun
  int begun_iterations = 0;  // likewise
  double begin_ms = 0;       // that step_begin() took
  std::chrono::steady_clock::time_point step_start{};
  std::vector<HookEntry> hooks;  // in the order in which they were added
  uint64_t next_hook = (uint64_t{first_generation} << 32) + 1;
  std::function<void(const Progress&)> progress;  // what set_progress() got
  Log log;
  StepBudget budget;
  std::unique_ptr<Recorder> recorder;  // while the world is being recorded
  SolidMeshes solid_meshes;
  // A removal goes through all that is there, as many together do. So they wait for the next other call.
  std::vector<collision::RigidRef> removed_solids;
  std::vector<bool> removed_particles;         // by slot; empty if there are none
  std::vector<collision::RigidRef> forgotten;  // solids that were removed since the last step
  std::vector<uint32_t> takers;                // sinks by slot, where one has taken a particle in this step
  uint64_t last_revision = 0;                  // see solids_revision
  Emission emission;
  float planned_step = 1;    // s, for which strokes of pistons are planned
  bool has_pistons = false;  // on the device
  SnapshotList snapshots;

  DeviceArrays shared_arrays;  // of the last device_arrays()
  CachedReadout<Vec3> positions, velocities;
  CachedReadout<uint32_t> fluid_indices;
  CachedReadout<float> density_errors, full_support, pressures;
  CachedReadout<Ellipsoid> ellipsoids;
  CachedReadout<DiffuseParticle> diffuse;
  EngineMeasure measured;  // measured with density_errors
  // In the user's frame, where that is another one.
  CachedReadout<Vec3> outward_positions;
  CachedReadout<Ellipsoid> outward_ellipsoids;
  CachedReadout<DiffuseParticle> outward_diffuse;
  std::optional<fluid::SurfaceField> surface;  // created on request
  uint32_t shared_by = 0;                      // ranks, of a shared world
  bool holds_back = false;                     // particles, until it is shared: see Engine::hold_back
};

ParticleMaterial material_of(const FluidDef& def);
collision::RigidWorldDef rigid_world_def(const WorldDef& def);
collision::RigidJointDef rigid_joint(const JointDef& def);
collision::RigidBodyDef rigid_body(const BodyEntry& body);
/// Throws Error(invalid_argument) if a baseline is to have another kernel than the one that it is made for.
void check_baseline_kernel(const WorldDef& def);

/// Throws Error(capacity) if a world with that many particles has no room for `added` more. The message names
/// the emitter that wants most of them, if one does.
void check_room(size_t present, double added, std::string_view emitter = {});

/// Makes the engine for the choice of a definition, and fills in which device it runs on.
/// Throws Error(invalid_argument) if it has members of CUDA and is on the CPU.
std::unique_ptr<Engine> make_engine(const EngineDef& def, const WorldDef& world, DeviceInfo& info);

}  // namespace meniscus
