// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What World's calls do, without the boundary that each public call passes (Impl::run). Calls that need
// another one use it here. They take and return positions in the frame about the origin (origin.h).
#pragma once

#include <functional>
#include <utility>

#include "sdk/world/check/origin.h"
#include "sdk/world/world_impl.h"

namespace meniscus {

/// The calls of World. Each fails before it changes anything, or calls CallMonitor::commit() where its change
/// begins, or restores what it changed.
struct World::Calls {
  const WorldDef& def() const;
  void set_def(const WorldDef& def);
  DeviceInfo device() const;
  float support_radius() const;
  float particle_mass(FluidId id) const;
  FluidId create_fluid(const FluidDef& def);
  void set_fluid(FluidId id, const FluidDef& def);
  FluidId create_granular(const GranularDef& def);
  ShapeId create_shape(const ShapeDef& def);
  void destroy_shape(ShapeId id);
  EmitterId create_emitter(const EmitterDef& def);
  void destroy_emitter(EmitterId id);
  FlowCount emitter_count(EmitterId id) const;
  double emitter_pressure(EmitterId id) const;
  SinkId create_sink(const SinkDef& def);
  void destroy_sink(SinkId id);
  FlowCount sink_count(SinkId id) const;
  ProbeId create_probe(const ProbeDef& def);
  void destroy_probe(ProbeId id);
  BodyId create_body(const BodyDef& def);
  void destroy_body(BodyId id);
  JointId create_joint(const JointDef& def);
  void destroy_joint(JointId id);
  ClothId create_cloth(const ClothDef& def);
  void destroy_cloth(ClothId id);
  RopeId create_rope(const RopeDef& def);
  void destroy_rope(RopeId id);
  AttachmentId create_attachment(const AttachmentDef& def);
  void destroy_attachment(AttachmentId id);
  void set_wind(const WindDef& wind);
  std::size_t add_fluid(const FluidVolumeDef& def);
  ParticleId add_particles(FluidId fluid, std::span<const Vec3> positions,
                           std::span<const Vec3> velocities = {});
  void remove_particles(std::span<const ParticleId> ids);
  void apply_impulses(std::span<const ParticleId> ids, std::span<const Vec3> impulses);
  void relax(int iterations = 50);
  StepReport step(float dt, std::optional<int> iterations = {}) {
    begin(dt, iterations);
    return finish();
  }
  void begin(float dt, std::optional<int> iterations);
  StepReport finish();
  void step_begin(float dt, std::optional<int> iterations);
  StepReport step_end();
  DeviceArrays device_arrays() const;
  HookId add_hook(Hook hook, SubstepCall call);
  void remove_hook(HookId id);
  ForceFieldId create_force_field(const ForceFieldDef& def);
  void set_force_field(ForceFieldId id, const ForceFieldDef& def);
  void destroy_force_field(ForceFieldId id);
  std::vector<ForceFieldId> force_field_ids() const;
  ForceFieldId find_force_field(const std::string& name) const;
  Snapshot snapshot() const;
  void restore(const Snapshot& snapshot);
  void save(const std::string& path) const;
  /// Calls use(visit), where visit(visitor) visits all chunks of a file. It may be called several times.
  using VisitChunks = std::function<void(pbd::StateVisitor&)>;
  void with_chunks(const std::function<void(const VisitChunks&)>& use) const;
  /// All chunks of a file, on the host.
  pbd::SavedState chunks() const;
  std::vector<FluidId> fluid_ids() const;
  std::vector<ShapeId> shape_ids() const;
  std::vector<BodyId> body_ids() const;
  std::vector<JointId> joint_ids() const;
  std::vector<ClothId> cloth_ids() const;
  std::vector<RopeId> rope_ids() const;
  std::vector<AttachmentId> attachment_ids() const;
  std::vector<EmitterId> emitter_ids() const;
  std::vector<SinkId> sink_ids() const;
  std::vector<ProbeId> probe_ids() const;
  FluidId find_fluid(const std::string& name) const;
  ShapeId find_shape(const std::string& name) const;
  BodyId find_body(const std::string& name) const;
  JointId find_joint(const std::string& name) const;
  ClothId find_cloth(const std::string& name) const;
  RopeId find_rope(const std::string& name) const;
  AttachmentId find_attachment(const std::string& name) const;
  EmitterId find_emitter(const std::string& name) const;
  SinkId find_sink(const std::string& name) const;
  ProbeId find_probe(const std::string& name) const;
  double time() const;
  BodyState body_state(BodyId id) const;
  BodyMass body_mass(BodyId id) const;
  double hinge_angle(JointId id) const;
  void set_body_pose(BodyId id, const Pose& pose);
  void set_body_velocity(BodyId id, Vec3 velocity, Vec3 angular_velocity);
  void apply_force(BodyId id, Vec3 force, Vec3 point);
  void apply_force(BodyId id, Vec3 force);
  void apply_torque(BodyId id, Vec3 torque);
  void apply_impulse(BodyId id, Vec3 impulse, Vec3 point);
  void move_body(BodyId id, const Pose& target, float duration);
  std::span<const Vec3> cloth_positions(ClothId id) const;
  std::span<const Vec3> cloth_velocities(ClothId id) const;
  std::span<const Vec3> cloth_normals(ClothId id) const;
  std::span<const uint32_t> cloth_triangles(ClothId id) const;
  std::span<const TexturePoint> cloth_texture(ClothId id) const;
  uint32_t cloth_welded_vertices(ClothId id) const;
  float cloth_bending_fraction(ClothId id) const;
  const std::vector<MeshRepair>& mesh_repairs() const;
  std::span<const float> cloth_strains(ClothId id) const;
  std::span<const float> cloth_wetness(ClothId id) const;
  ClothState cloth_state(ClothId id) const;
  const std::vector<TearEvent>& tear_events() const;
  std::span<const Vec3> rope_positions(RopeId id) const;
  std::span<const Vec3> rope_velocities(RopeId id) const;
  std::span<const Quat> rope_frames(RopeId id) const;
  void apply_impulses(ClothId id, std::span<const uint32_t> vertices, std::span<const Vec3> impulses);
  void apply_impulses(RopeId id, std::span<const uint32_t> vertices, std::span<const Vec3> impulses);
  Vec3 attachment_force(AttachmentId id) const;
  std::vector<uint32_t> attachment_vertices(AttachmentId id) const;
  void set_positions(std::span<const Vec3> positions);
  void set_positions(FluidId fluid, std::span<const Vec3> positions);
  void set_positions(std::span<const ParticleId> ids, std::span<const Vec3> positions);
  void set_velocities(std::span<const Vec3> velocities);
  void set_velocities(FluidId fluid, std::span<const Vec3> velocities);
  void set_velocities(std::span<const ParticleId> ids, std::span<const Vec3> velocities);
  void set_cloth_positions(ClothId id, std::span<const Vec3> positions);
  void set_cloth_velocities(ClothId id, std::span<const Vec3> velocities);
  void set_rope_positions(RopeId id, std::span<const Vec3> positions);
  void set_rope_velocities(RopeId id, std::span<const Vec3> velocities);
  void set_shape_pose(ShapeId id, const Pose& pose);
  void set_filter(FluidId id, const CollisionFilter& filter);
  void set_filter(ShapeId id, const CollisionFilter& filter);
  void set_filter(BodyId id, const CollisionFilter& filter);
  void set_filter(ClothId id, const CollisionFilter& filter);
  void set_filter(RopeId id, const CollisionFilter& filter);
  void set_surface(ShapeId id, const SurfaceDef& surface);
  void set_surface(BodyId id, const SurfaceDef& surface);
  /// The slots of a fluid's particles, ascending.
  std::vector<uint32_t> slots_of(FluidId fluid) const;
  std::vector<ParticleContact> particle_contacts() const;
  std::vector<SolidContact> solid_contacts() const;
  const std::vector<ContactEvent>& contact_events() const;
  const std::vector<SleepEvent>& sleep_events() const;
  const std::vector<FlowEvent>& flow_events() const;
  std::optional<RayHit> cast_ray(Vec3 from, Vec3 to, const QueryTargets& targets = {}) const;
  std::optional<NearestPoint> nearest(Vec3 point, float reach, const QueryTargets& targets = {}) const;
  std::vector<FluidSample> sample_fluid(std::span<const Vec3> points, std::optional<FluidId> fluid) const;
  std::vector<float> solid_distances(std::span<const Vec3> points, float reach,
                                     const CollisionFilter& filter = {}) const;
  Overlaps overlap_ball(Vec3 centre, float radius, const QueryTargets& targets) const;
  Overlaps overlap_box(const Pose& pose, Vec3 half_extents, const QueryTargets& targets) const;
  std::size_t particle_count() const;
  std::span<const ParticleId> ids() const;
  std::span<const Vec3> positions() const;
  std::span<const Vec3> velocities() const;
  std::span<const uint32_t> fluids() const;
  std::span<const float> density_errors() const;
  std::span<const float> pressures() const;
  std::span<const Ellipsoid> ellipsoids() const;
  std::shared_ptr<const void> hold(const void* first) const;
  void write_particles(const ParticleArrays& arrays) const;
  void write_particles(GlParticles& buffers) const;
  SurfaceMesh surface_mesh(const SurfaceMeshDef& def = {}) const;
  std::span<const DiffuseParticle> diffuse() const;
  Diagnostics diagnostics() const;
  double probe(ProbeId id) const;
  Vec3 probe_vector(ProbeId id) const;
  uint64_t state_hash() const;
  std::vector<std::string> warnings() const;
  std::size_t device_bytes() const;
  std::vector<MemoryShare> memory_shares() const;
  MemoryStats memory_stats() const;
  void start_recording(const std::string& path);
  void stop_recording();

  // Arguments in the frame about the origin, and results in that of the user.
  template <class Def>
  Inward<Def> inward(const Def& def) const {
    return {impl_->origin, def};
  }
  InwardPoints inward(std::span<const Vec3> points) const { return {impl_->origin, points}; }
  template <class Result>
  Result outward(Result result) const {
    return impl_->origin.outward(std::move(result));
  }
  std::span<const Vec3> outward_positions() const;
  std::span<const Vec3> outward_positions(ClothId id) const;
  std::span<const Vec3> outward_positions(RopeId id) const;
  std::span<const Ellipsoid> outward_ellipsoids() const;
  std::span<const DiffuseParticle> outward_diffuse() const;

  Impl* impl_;
};

}  // namespace meniscus
