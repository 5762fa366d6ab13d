// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// World: creates, fills, steps and reads one simulation.
#pragma once

#include <meniscus/bodies.h>
#include <meniscus/cloth.h>
#include <meniscus/defs.h>
#include <meniscus/device_arrays.h>
#include <meniscus/error.h>
#include <meniscus/flow.h>
#include <meniscus/force_fields.h>
#include <meniscus/hooks.h>
#include <meniscus/ids.h>
#include <meniscus/outputs.h>
#include <meniscus/queries.h>
#include <meniscus/snapshot.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace meniscus {

class GlParticles;
class Replay;
namespace pbd {
class SavedState;
}

/// One simulated world on one device. Worlds share nothing. Only one thread may use a world at a time. Every
/// call may throw Error and has then changed nothing. Without memory for the tables of shapes, bodies or
/// cloth, the next call that needs them throws, until some are destroyed.
///
/// Missing memory is Error(out_of_memory), on the host as on the device. In few places it can run out while
/// the world already changes. The message then says that the world is lost, and each later call but the
/// destructor throws Error(lost).
class World {
 public:
  explicit World(const WorldDef& def = {});  ///< an empty world
  ~World();
  World(World&&) noexcept;             ///< takes another world, which is then of no use
  World& operator=(World&&) noexcept;  ///< likewise

  const WorldDef& def() const;  ///< as it is now
  /// From the next step on. A running world can change gravity, substeps, iterations, cfl_number with its
  /// limits, step_budget_ms, log, read_file, and the solvers of density, solids and cloth. parallel_for stays
  /// as it is. Throws Error(invalid_argument) and names the
  /// member if another one differs.
  void set_def(const WorldDef& def);
  /// "cpu" or "cuda", the name of the device, and the reason if `automatic` fell back to the CPU.
  DeviceInfo device() const;
  float support_radius() const;           ///< h, m
  float particle_mass(FluidId id) const;  ///< kg

  FluidId create_fluid(const FluidDef& def);  ///< adds no particles
  /// From the next step on. Throws Error(invalid_argument) unless the id is a fluid and the rest density is
  /// the same.
  void set_fluid(FluidId id, const FluidDef& def);
  FluidId create_granular(const GranularDef& def);  ///< adds no grains
  /// For a mesh, throws Error(io) and Error(mesh) if the file cannot be used, and Error(capacity) if
  /// MeshGeometry::max_error needs too fine a field.
  ShapeId create_shape(const ShapeDef& def);
  void destroy_shape(ShapeId id);  ///< its id becomes invalid
  /// Throws Error(io) and Error(mesh) if its opening is a mesh with an unusable file.
  EmitterId create_emitter(const EmitterDef& def);
  void destroy_emitter(EmitterId id);           ///< its particles stay, but for those in a duct
  FlowCount emitter_count(EmitterId id) const;  ///< particles that it made
  /// Pa: the pressure of the fluid on the piston of an imposed emitter, the mean over its opening and the
  /// last step. 0 of a free one.
  double emitter_pressure(EmitterId id) const;
  SinkId create_sink(const SinkDef& def);     ///< acts from the next step on
  void destroy_sink(SinkId id);               ///< its id becomes invalid
  FlowCount sink_count(SinkId id) const;      ///< particles that it removed
  ProbeId create_probe(const ProbeDef& def);  ///< measures from the next step on
  void destroy_probe(ProbeId id);             ///< its id becomes invalid
  /// Throws Error(mesh) if the mesh of a dynamic body is not a closed, simple surface, and names the face.
  /// MeshGeometry::repair makes one of it.
  /// Also throws it if a moment of inertia is below a millionth of the largest. For meshes it throws as
  /// create_shape.
  BodyId create_body(const BodyDef& def);
  void destroy_body(BodyId id);  ///< and its joints, attachments, emitters and sinks
  /// Throws Error(not_found) if a body does not exist, and Error(invalid_argument) if both are the same.
  JointId create_joint(const JointDef& def);
  void destroy_joint(JointId id);  ///< the bodies stay

  /// Throws Error(mesh) if the mesh is no surface, and names the triangle, edge or vertex. Also throws it if
  /// the piece is to hold gas but has a border. Throws Error(io) if a file cannot be read.
  ClothId create_cloth(const ClothDef& def);
  void destroy_cloth(ClothId id);          ///< and its attachments
  RopeId create_rope(const RopeDef& def);  ///< of a rope, or of a rod
  void destroy_rope(RopeId id);            ///< and its attachments
  /// Throws Error(not_found) if a cloth, rope or body does not exist. Throws Error(invalid_argument) if no
  /// vertex is in the region or near enough to be sewn.
  AttachmentId create_attachment(const AttachmentDef& def);
  void destroy_attachment(AttachmentId id);  ///< lets the vertices go
  /// From the next step on. Wind acts on cloth alone. By default the air is at rest and has 1.2 kg/m³.
  void set_wind(const WindDef& wind);

  /// Fills a region and returns the number of new particles. Throws Error(io) and Error(mesh) if the region
  /// is a mesh with an unusable file. Throws Error(capacity) if the region holds more than a world does.
  std::size_t add_fluid(const FluidVolumeDef& def);
  /// Adds one particle at each position. `velocities` is empty (at rest) or has as many elements. Returns the
  /// first id. The others follow it. Throws Error(capacity) if too many are within one support radius.
  ParticleId add_particles(FluidId fluid, std::span<const Vec3> positions,
                           std::span<const Vec3> velocities = {});
  /// An unknown id is an error.
  void remove_particles(std::span<const ParticleId> ids);
  /// N·s on each particle, at once. An unknown or repeated id is an error.
  void apply_impulses(std::span<const ParticleId> ids, std::span<const Vec3> impulses);
  /// Moves the particles to their rest density and keeps no motion. This removes the energy of overlaps. 0 to
  /// 100,000 iterations.
  void relax(int iterations = 50);

  /// Advances by dt seconds, at least 1e-12. Then cloth absorbs particles and drips, sinks remove particles,
  /// and emitters make them. On Error(non_finite) the state is that before the call. `iterations`, 1 to 1000,
  /// replace WorldDef::iterations and the choice of WorldDef::step_budget_ms in this step.
  StepReport step(float dt, std::optional<int> iterations = {});
  double time() const;  ///< s

  /// The whole state: what exists, where it is, and all that the next step reads. Its arrays are copied
  /// within the memory of the device. The world does not change.
  Snapshot snapshot() const;
  /// Goes back to a snapshot of this world, whatever was created, destroyed or set since. Ids are valid as
  /// they were then. What follows is bit for bit what followed the snapshot. Throws Error(invalid_argument)
  /// if the snapshot is empty or of another world.
  void restore(const Snapshot& snapshot);
  /// Writes the whole state to a file (docs/snapshots.md), which appears complete or not at all. Mesh files
  /// of solids are not in it, but their names. Throws Error(io) if the file cannot be written.
  void save(const std::string& path) const;
  /// A new world with the state of a file. For the same program and kind of device it continues bit for bit.
  /// On the other kind, or with another number of threads, it continues as well; another kind of device
  /// rounds differently. Ids have the same indices, but are those of the new world (the *_ids calls list
  /// them). Throws Error(io) with the reason if the file is not complete and unchanged, or is not known to
  /// this program. Also throws what the creation of its solids throws.
  static World load(const std::string& path, const LoadDef& def = {});

  /// A new world with the same state, as if by save and load.
  World clone(const LoadDef& def = {}) const;

  /// Writes all further calls that change the world to a file, and its state at the beginning. After each
  /// step the file has its hash. Replay (recording.h) repeats them. Where the world goes back to a snapshot,
  /// or a relax() is cancelled, the file gets the whole state again. Hooks and what they do are not in it. If
  /// a write fails, the recording ends there, a warning goes to WorldDef::log, and stop_recording() throws
  /// the reason. Throws Error(io) if the file cannot be made, and Error(invalid_argument) if the world is
  /// being recorded already.
  void start_recording(const std::string& path);
  /// Ends the recording. Without it the file is good but has no end. Throws Error(io) if not all could be
  /// written, and Error(invalid_argument) if nothing is being recorded.
  void stop_recording();

  // What exists, in the order of the indices of ids. The find calls return the first of that name, and throw
  // Error(not_found) if there is none.
  std::vector<FluidId> fluid_ids() const;                       ///< by index
  std::vector<ShapeId> shape_ids() const;                       ///< by index
  std::vector<BodyId> body_ids() const;                         ///< by index
  std::vector<JointId> joint_ids() const;                       ///< by index
  std::vector<ClothId> cloth_ids() const;                       ///< by index
  std::vector<RopeId> rope_ids() const;                         ///< by index
  std::vector<AttachmentId> attachment_ids() const;             ///< by index
  std::vector<EmitterId> emitter_ids() const;                   ///< by index
  std::vector<SinkId> sink_ids() const;                         ///< by index
  std::vector<ProbeId> probe_ids() const;                       ///< by index
  FluidId find_fluid(const std::string& name) const;            ///< the first
  ShapeId find_shape(const std::string& name) const;            ///< the first
  BodyId find_body(const std::string& name) const;              ///< the first
  JointId find_joint(const std::string& name) const;            ///< the first
  ClothId find_cloth(const std::string& name) const;            ///< the first
  RopeId find_rope(const std::string& name) const;              ///< the first
  AttachmentId find_attachment(const std::string& name) const;  ///< the first
  EmitterId find_emitter(const std::string& name) const;        ///< the first
  SinkId find_sink(const std::string& name) const;              ///< the first
  ProbeId find_probe(const std::string& name) const;            ///< the first
  /// Ends the long call that runs, or else the next one. It throws Error(cancelled) within about a second,
  /// and nothing has changed. But relax() keeps the iterations that are done. Any thread may call this, and
  /// signal handlers. Long calls are step, relax, diagnostics, read-outs that search neighbours, and calls
  /// that fit a field to a mesh. On a GPU they end between substeps.
  void cancel() noexcept;
  /// `report` is called by long calls, at most ten times a second, on the thread of the call. It must use no
  /// call of this world but cancel().
  void set_progress(std::function<void(const Progress&)> report);
  /// What a user probably does not intend, one sentence each, as the world stands now: overlaps, cloth and
  /// bodies outside of a container, drag on what falls, fields with many cells, and places too far from
  /// WorldDef::origin for the precision of floats.
  std::vector<std::string> warnings() const;

  // Bodies. Values that are set count from the next step on. Forces act for that step alone, or for the next
  // one if it fails. Impulses act at once. Points are in the world's frame. A call on a body of the wrong
  // motion throws Error(invalid_argument).
  BodyState body_state(BodyId id) const;  ///< after the last step
  BodyMass body_mass(BodyId id) const;    ///< of dynamic bodies
  /// Of shapes and bodies that were created so far, in that order.
  const std::vector<MeshRepair>& mesh_repairs() const;
  double hinge_angle(JointId id) const;  ///< rad, of b (or the world) about a, from the pose at creation
  /// A dynamic body keeps its velocity. A kinematic one then stands still.
  void set_body_pose(BodyId id, const Pose& pose);
  void set_body_velocity(BodyId id, Vec3 velocity, Vec3 angular_velocity);  ///< dynamic bodies
  void apply_force(BodyId id, Vec3 force, Vec3 point);      ///< N; dynamic bodies, as the next two
  void apply_force(BodyId id, Vec3 force);                  ///< N, at the centre of mass
  void apply_torque(BodyId id, Vec3 torque);                ///< N·m
  void apply_impulse(BodyId id, Vec3 impulse, Vec3 point);  ///< N·s
  /// Moves a kinematic body to a pose in `duration` seconds at a constant rate. This replaces its keyframes.
  void move_body(BodyId id, const Pose& target, float duration);

  // Cloth and ropes. The geometries in cloth.h state the order of vertices. Spans are valid until the next
  // non-const call. Tearing adds vertices at the end and keeps the order of triangles.
  std::span<const Vec3> cloth_positions(ClothId id) const;   ///< m
  std::span<const Vec3> cloth_velocities(ClothId id) const;  ///< m/s
  /// Unit, one a vertex: the mean over its triangles with the weights of Max (1999), exact on a ball.
  std::span<const Vec3> cloth_normals(ClothId id) const;
  std::span<const uint32_t> cloth_triangles(ClothId id) const;  ///< three vertices each
  /// Texture coordinates, one a corner of cloth_triangles(). Those of a file are its own, and triangles in
  /// memory and files without any have none. A sheet has u along x and v along z. A tube has u around its
  /// axis and v upwards, and its bottom has u along x and v along z. A sphere has longitude and latitude.
  std::span<const TexturePoint> cloth_texture(ClothId id) const;
  /// How many vertices of its file were merged into others (ClothFile::weld).
  uint32_t cloth_welded_vertices(ClothId id) const;
  /// Of the bending stiffness of its fabric, the least part that substeps have resolved since any cloth was
  /// last created, changed or torn. It is 1 but for stiff cloth of fine or thin triangles, which needs
  /// shorter substeps. It does not tell of dihedral bending.
  float cloth_bending_fraction(ClothId id) const;
  std::span<const float> cloth_strains(ClothId id) const;  ///< largest principal strain of each triangle
  /// For each vertex: the fluid that it holds over FabricDef::absorbency, or 0 if that is 0.
  std::span<const float> cloth_wetness(ClothId id) const;
  ClothState cloth_state(ClothId id) const;                ///< after the last step
  const std::vector<TearEvent>& tear_events() const;       ///< of the last step
  std::span<const Vec3> rope_positions(RopeId id) const;   ///< m
  std::span<const Vec3> rope_velocities(RopeId id) const;  ///< m/s
  std::span<const Quat> rope_frames(RopeId id) const;  ///< one a segment of a rod, z along it; ropes: none
  /// N·s on each of these vertices, by number, at once. No number may repeat. A vertex that is attached to
  /// the world does not move.
  void apply_impulses(ClothId id, std::span<const uint32_t> vertices, std::span<const Vec3> impulses);
  /// Likewise.
  void apply_impulses(RopeId id, std::span<const uint32_t> vertices, std::span<const Vec3> impulses);
  /// N, the force of the cloth or rope on the world or the body in the last step, summed over the vertices of
  /// the attachment. Seams read 0.
  Vec3 attachment_force(AttachmentId id) const;
  std::vector<uint32_t> attachment_vertices(AttachmentId id) const;  ///< by number

  // State that is set from outside. Read-outs show it at once, and the next step starts from it. There is one
  // value for each particle or vertex: any other number, a value that is not finite, or one beyond 1e9 m or
  // m/s throws Error(invalid_argument). New positions are like those of a new thing. No impulse results from
  // the way there, but overlaps with solids are resolved at their usual speed. Bodies at rest near it wake
  // once particles or vertices push them.
  /// m, of all particles, in the order of ids(). Velocities stay. Density multipliers of all particles start
  /// from 0, and emitters no longer hold the moved particles. Throws Error(capacity) as add_particles.
  void set_positions(std::span<const Vec3> positions);
  void set_positions(FluidId fluid, std::span<const Vec3> positions);  ///< those of one fluid or material
  /// Those of these particles. An unknown or repeated id is an error.
  void set_positions(std::span<const ParticleId> ids, std::span<const Vec3> positions);
  void set_velocities(std::span<const Vec3> velocities);                 ///< m/s; multipliers stay
  void set_velocities(FluidId fluid, std::span<const Vec3> velocities);  ///< likewise
  void set_velocities(std::span<const ParticleId> ids, std::span<const Vec3> velocities);  ///< likewise
  /// m, of all vertices. Velocities stay. A vertex that is attached to the world is held where it now is. One
  /// that is attached to a body is drawn back to its place there. All cloth and ropes of the world start
  /// without multipliers, self-contact lists and stick anchors, as after the creation of cloth.
  void set_cloth_positions(ClothId id, std::span<const Vec3> positions);
  void set_cloth_velocities(ClothId id, std::span<const Vec3> velocities);  ///< m/s; multipliers stay
  /// Likewise. The frames of a rod turn with its segments, by the smallest rotation.
  void set_rope_positions(RopeId id, std::span<const Vec3> positions);
  void set_rope_velocities(RopeId id, std::span<const Vec3> velocities);  ///< m/s; multipliers stay
  /// Wakes bodies that touched the shape. What the shape now covers is pushed out, as after its creation. To
  /// carry things along, use a kinematic body. Contact events tell of the change after the next step.
  void set_shape_pose(ShapeId id, const Pose& pose);
  /// What the fluid or granular material collides with. Cloth starts as in set_cloth_positions.
  void set_filter(FluidId id, const CollisionFilter& filter);
  void set_filter(ShapeId id, const CollisionFilter& filter);  ///< wakes what touches it
  void set_filter(BodyId id, const CollisionFilter& filter);   ///< likewise
  void set_filter(ClothId id, const CollisionFilter& filter);  ///< cloth starts as in set_cloth_positions
  void set_filter(RopeId id, const CollisionFilter& filter);   ///< likewise
  void set_surface(ShapeId id, const SurfaceDef& surface);     ///< wakes what touches it
  void set_surface(BodyId id, const SurfaceDef& surface);      ///< likewise

  // Contacts and queries, as of the last step.
  std::vector<ParticleContact> particle_contacts() const;  ///< those with an impulse; none if the step failed
  std::vector<SolidContact> solid_contacts() const;        ///< at least one of each pair is a body
  const std::vector<ContactEvent>& contact_events() const;  ///< of the last step
  const std::vector<SleepEvent>& sleep_events() const;      ///< of the last step, by body
  const std::vector<FlowEvent>& flow_events() const;        ///< of the last step, those of sinks first
  /// The first thing between `from` and `to`, or none. A particle is a ball with a radius of half a spacing.
  /// A ray that starts in a convex solid hits it there. A particle or rope around the start does not count.
  std::optional<RayHit> cast_ray(Vec3 from, Vec3 to, const QueryTargets& targets = {}) const;
  /// The nearest place on a surface within `reach` (m) of a point, or none. A particle is a ball with a
  /// radius of half a spacing. Of equally near places the first counts, in the order of QueryTargets.
  std::optional<NearestPoint> nearest(Vec3 point, float reach, const QueryTargets& targets = {}) const;
  /// Density and velocity of the fluid at points, from the present positions; of one fluid or granular
  /// material, or of all fluids and grains. Probes measure the same within a step.
  std::vector<FluidSample> sample_fluid(std::span<const Vec3> points,
                                        std::optional<FluidId> fluid = {}) const;
  /// m, from each point to the surface of the nearest solid that the filter collides with, negative inside.
  /// It is `reach` if no solid is nearer. Cloth does not count.
  std::vector<float> solid_distances(std::span<const Vec3> points, float reach,
                                     const CollisionFilter& filter = {}) const;
  Overlaps overlap_ball(Vec3 centre, float radius, const QueryTargets& targets = {}) const;  ///< m
  /// m
  Overlaps overlap_box(const Pose& pose, Vec3 half_extents, const QueryTargets& targets = {}) const;

  std::size_t particle_count() const;  ///< of fluids and grains
  // Read-outs, one element a particle, in the order of the ids. Valid until the next non-const call.
  std::span<const ParticleId> ids() const;        ///< in ascending order
  std::span<const Vec3> positions() const;        ///< m
  std::span<const Vec3> velocities() const;       ///< m/s
  std::span<const uint32_t> fluids() const;       ///< FluidId::index
  std::span<const float> density_errors() const;  ///< C = ρ/ρ₀ − 1, at the present positions
  /// Pa, of the last substep. With surface tension σ it contains the pressure that keeps attracted particles
  /// apart: about 1.3 σ over a spacing, everywhere.
  std::span<const float> pressures() const;
  /// Ellipsoids whose outsides form the surface of the fluid. They are flat along it, and balls for lone and
  /// inner particles. Their centres are smoothed. Grains are balls with a diameter of one spacing.
  std::span<const Ellipsoid> ellipsoids() const;
  /// Keeps one of these read-outs, from positions() to ellipsoids(), or diffuse(), as it is while the result
  /// lives. The world writes later values elsewhere. `first` is the address of its first element. Throws
  /// Error(not_found) if no such read-out begins there. The result may outlive the world, and any thread may
  /// release it.
  std::shared_ptr<const void> hold(const void* first) const;
  /// Writes ellipsoids, fluids and velocities to arrays on the world's own device, for a renderer there. The
  /// arrays are complete when the call returns. Right after a step, ellipsoids use the neighbours of the last
  /// substep, which cost no search. At the surface they differ from ellipsoids() by particles that have come
  /// within the support radius since. Throws Error(invalid_argument) if ellipsoids or fluids are null.
  void write_particles(const ParticleArrays& arrays) const;
  /// Writes the same to OpenGL buffers. OpenGL commands keep their order relative to this call. The driver
  /// may make the host wait for earlier commands. Right after a step the host does not wait for the world's
  /// own work. Throws Error(invalid_argument) if the world is on the CPU, or if the buffers have no room for
  /// all particles.
  void write_particles(GlParticles& buffers) const;
  /// The surface around the ellipsoids, by marching cubes on the device. Particles further than 2²¹ cells
  /// from WorldDef::origin are left out. Without particles the mesh is empty. Throws Error(invalid_argument)
  /// and Error(not_found). Throws Error(capacity) if the cells need more than 32 bits to count.
  SurfaceMesh surface_mesh(const SurfaceMeshDef& def = {}) const;

  /// Spray, foam and bubbles, in the order of their creation. None without WorldDef::diffuse.
  std::span<const DiffuseParticle> diffuse() const;

  Diagnostics diagnostics() const;      ///< measured from the present positions
  double probe(ProbeId id) const;       ///< of the last step; the kind has the unit. Of a vector, its length
  Vec3 probe_vector(ProbeId id) const;  ///< of a kind with vectors; 0 of the others
  /// The sum, modulo 2⁶⁴, of a hash of each particle, vertex and body: its number and the bits of position,
  /// velocity and rotation. Equal states have equal hashes, whatever the order on the device.
  uint64_t state_hash() const;
  std::size_t device_bytes() const;  ///< held on the device
  /// The same by purpose, the largest first. All changes are uploaded before, so this is the memory with
  /// which the next step starts. A step takes more if it finds more neighbours or contacts than there is room
  /// for. Throws Error(out_of_memory) if there is not enough for the upload.
  std::vector<MemoryShare> memory_shares() const;
  MemoryStats memory_stats() const;  ///< bytes and counts of allocations, without an upload

  // ---- other physics on a world ----

  ForceFieldId create_force_field(const ForceFieldDef& def);  ///< acts from the next step on
  /// From the next step on. Its kind may change as well.
  void set_force_field(ForceFieldId id, const ForceFieldDef& def);
  void destroy_force_field(ForceFieldId id);                     ///< its id becomes invalid
  std::vector<ForceFieldId> force_field_ids() const;             ///< by index
  ForceFieldId find_force_field(const std::string& name) const;  ///< the first

  /// The particles of fluids and grains in the memory of the world's device, without a copy to the host. The
  /// work that fills the arrays is on DeviceArray::stream when this returns (device_arrays.h).
  DeviceArrays device_arrays() const;

  /// The two halves of step(). Until step_end() the device works, and the caller may do other work. Only
  /// cancel(), set_progress(), step_end() and the destructor are allowed in between. Others throw
  /// Error(invalid_argument) with their name. With bodies the host waits within step_begin() for each
  /// substep. On the CPU all substeps are done there. StepReport::ms contains the caller's work.
  void step_begin(float dt, std::optional<int> iterations = {});
  /// Ends the step that step_begin() began. Throws as step() does; the state is then that before
  /// step_begin().
  StepReport step_end();

  /// Calls `call` at this point of each substep, from the next step on, after those that were added before.
  /// See hooks.h for what it may do. Snapshots do not contain it. Throws Error(invalid_argument) if it is
  /// empty.
  HookId add_hook(Hook hook, SubstepCall call);
  void remove_hook(HookId id);  ///< throws Error(not_found) if it is not there

 private:
  friend class Replay;
  friend class SharedWorld;
  friend class WorldBatch;
  struct Impl;
  struct Calls;
  static std::unique_ptr<Impl> make(const WorldDef& def);
  static World made_from(const std::string& definitions, const pbd::SavedState& saved, const LoadDef& def);

  explicit World(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace meniscus
