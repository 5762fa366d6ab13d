// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <meniscus/bodies.h>
#include <meniscus/cloth.h>
#include <meniscus/defs.h>
#include <meniscus/error.h>
#include <meniscus/flow.h>
#include <meniscus/ids.h>
#include <meniscus/outputs.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace meniscus {

class GlParticles;

/// One simulated world on one device. Worlds share nothing; a world is used by one thread at a time.
/// Every call may throw Error, and has then changed nothing. Where there is no memory for the tables of
/// shapes, bodies or cloth, the call that next needs them throws, until some are destroyed.
class World {
 public:
  explicit World(const WorldDef& def = {});
  ~World();
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;

  const WorldDef& def() const;
  /// What a world can change while it runs: gravity, substeps, iterations, cfl_number and its limits, and how
  /// density, solids and cloth are solved, from the next step on. Throws Error(invalid_argument), naming it,
  /// where another member is not as it was.
  void set_def(const WorldDef& def);
  /// "cpu" or "cuda", the device's name, and, where `automatic` fell back to the CPU, the reason.
  DeviceInfo device() const;
  float support_radius() const;           ///< h, m
  float particle_mass(FluidId id) const;  ///< kg

  FluidId create_fluid(const FluidDef& def);
  /// From the next step on. Throws Error(invalid_argument) unless it is a fluid, and of the same rest
  /// density.
  void set_fluid(FluidId id, const FluidDef& def);
  FluidId create_granular(const GranularDef& def);
  /// Where its geometry is a mesh, throws Error(io) and Error(mesh) for a file that cannot be used, and
  /// Error(capacity) where MeshGeometry::max_error takes too fine a field.
  ShapeId create_shape(const ShapeDef& def);
  void destroy_shape(ShapeId id);
  /// Throws Error(io) and Error(mesh) where its opening is a mesh whose file cannot be used.
  EmitterId create_emitter(const EmitterDef& def);
  void destroy_emitter(EmitterId id);
  FlowCount emitter_count(EmitterId id) const;
  SinkId create_sink(const SinkDef& def);
  void destroy_sink(SinkId id);
  FlowCount sink_count(SinkId id) const;
  ProbeId create_probe(const ProbeDef& def);
  void destroy_probe(ProbeId id);
  /// Throws Error(mesh) where the mesh of a dynamic body is not a closed, simple surface, and names the face;
  /// and where a body is a needle, with a moment of inertia below a millionth of the largest; and what
  /// create_shape throws for meshes.
  BodyId create_body(const BodyDef& def);
  void destroy_body(BodyId id);  ///< and its joints, attachments, emitters and sinks
  /// Throws Error(not_found) where there is no such body, and Error(invalid_argument) where both are the
  /// same.
  JointId create_joint(const JointDef& def);
  void destroy_joint(JointId id);

  /// Throws Error(mesh) where the mesh is no surface, and names the triangle, edge or vertex, or where it has
  /// a border but is to hold gas; Error(io) where a file cannot be read.
  ClothId create_cloth(const ClothDef& def);
  void destroy_cloth(ClothId id);  ///< and its attachments
  RopeId create_rope(const RopeDef& def);
  void destroy_rope(RopeId id);  ///< and its attachments
  /// Throws Error(not_found) where there is no such cloth, rope or body, and Error(invalid_argument) where no
  /// vertex is in the region or near enough to be sewn.
  AttachmentId create_attachment(const AttachmentDef& def);
  void destroy_attachment(AttachmentId id);
  /// From the next step on. It acts on cloth alone. Without it the air is at rest, and has 1.2 kg/m³.
  void set_wind(const WindDef& wind);

  /// Fills a region; returns how many particles were made. Throws Error(io) and Error(mesh) where the region
  /// is a mesh whose file cannot be used, and Error(capacity) where it holds more than a world does.
  std::size_t add_fluid(const FluidVolumeDef& def);
  /// One particle a position, none left out; velocities may be empty (at rest), else as many. Returns the
  /// first id: the rest follow on.
  ParticleId add_particles(FluidId fluid, std::span<const Vec3> positions,
                           std::span<const Vec3> velocities = {});
  /// Unknown ids are an error.
  void remove_particles(std::span<const ParticleId> ids);
  /// N·s on each, at once. No particle twice; unknown ids are an error.
  void apply_impulses(std::span<const ParticleId> ids, std::span<const Vec3> impulses);
  /// Lets the particles find their rest density with no motion kept: takes the energy out of overlaps. 0 to
  /// 100,000 iterations.
  void relax(int iterations = 50);

  /// Advances by dt seconds, 1e-12 or more; then cloth takes up particles and drips, sinks take some, and
  /// emitters make some. On Error(non_finite) the state is the one before the call.
  StepReport step(float dt);
  double time() const;  ///< s

  // Bodies. What is set or applied counts from the next step on; forces act for that step alone, or, where it
  // fails, for the next one; impulses at once. Points are in the world. A call on a body of the wrong motion
  // is Error(invalid_argument).
  BodyState body_state(BodyId id) const;
  BodyMass body_mass(BodyId id) const;
  double hinge_angle(JointId id) const;  ///< rad, of b (or the world) about a, from the placement at creation
  /// A dynamic body keeps its velocity; a kinematic one stands still from now on.
  void set_body_pose(BodyId id, const Pose& pose);
  void set_body_velocity(BodyId id, Vec3 velocity, Vec3 angular_velocity);  ///< dynamic bodies
  void apply_force(BodyId id, Vec3 force, Vec3 point);      ///< N; dynamic bodies, as the next two
  void apply_torque(BodyId id, Vec3 torque);                ///< N·m
  void apply_impulse(BodyId id, Vec3 impulse, Vec3 point);  ///< N·s
  /// Takes a kinematic body to a pose in `duration` seconds, at an even rate; instead of its keyframes from
  /// now on.
  void move_body(BodyId id, const Pose& target, float duration);

  // Cloth and ropes; see ClothDef for the order of vertices. Spans are valid until the next call that is not
  // const. Tearing adds vertices at the end, and keeps the triangles' order.
  std::span<const Vec3> cloth_positions(ClothId id) const;   ///< m
  std::span<const Vec3> cloth_velocities(ClothId id) const;  ///< m/s
  /// Unit, one a vertex: the mean of its triangles' with the weights of Max (1999), exact on a ball.
  std::span<const Vec3> cloth_normals(ClothId id) const;
  std::span<const uint32_t> cloth_triangles(ClothId id) const;  ///< three vertices each
  std::span<const float> cloth_strains(ClothId id) const;  ///< of each triangle, its largest principal strain
  /// Of each vertex, the fluid that it holds over FabricDef::absorbency; 0 where that is 0.
  std::span<const float> cloth_wetness(ClothId id) const;
  ClothState cloth_state(ClothId id) const;
  const std::vector<TearEvent>& tear_events() const;
  std::span<const Vec3> rope_positions(RopeId id) const;   ///< m
  std::span<const Vec3> rope_velocities(RopeId id) const;  ///< m/s
  std::span<const Quat> rope_frames(RopeId id) const;      ///< of rods, a segment: z along it; of ropes none
  /// N·s on each of these vertices, by number, at once; none of them twice. What an attachment holds to the
  /// world does not move.
  void apply_impulses(ClothId id, std::span<const uint32_t> vertices, std::span<const Vec3> impulses);
  void apply_impulses(RopeId id, std::span<const uint32_t> vertices, std::span<const Vec3> impulses);
  /// N, the sum over the attachment's vertices of what the cloth or rope pulled with in the last step: on the
  /// world or the body. Seams read 0.
  Vec3 attachment_force(AttachmentId id) const;
  std::vector<uint32_t> attachment_vertices(AttachmentId id) const;

  // Contacts and queries, as of the last step.
  std::vector<ParticleContact> particle_contacts() const;  ///< with an impulse; none after a step that failed
  std::vector<SolidContact> solid_contacts() const;        ///< one of each is a body
  const std::vector<ContactEvent>& contact_events() const;
  /// The first solid or particle on the way from `from` to `to`, none where it gets there; a particle is a
  /// ball of half a spacing in radius. Cloth and ropes do not count. A ray that starts in a convex solid
  /// meets it there; a particle that it starts in does not count.
  std::optional<RayHit> cast_ray(Vec3 from, Vec3 to) const;
  /// m, of each point to the surface of the nearest solid that a filter collides with, negative inside;
  /// `reach` where there is none so near. Cloth does not count.
  std::vector<float> solid_distances(std::span<const Vec3> points, float reach,
                                     const CollisionFilter& filter = {}) const;
  Overlaps overlap_ball(Vec3 centre, float radius) const;
  Overlaps overlap_box(const Pose& pose, Vec3 half_extents) const;

  std::size_t particle_count() const;
  // Read-outs, one element a particle in the order of the ids; valid until the next call that is not const.
  std::span<const ParticleId> ids() const;
  std::span<const Vec3> positions() const;        ///< m
  std::span<const Vec3> velocities() const;       ///< m/s
  std::span<const uint32_t> fluids() const;       ///< FluidId::index
  std::span<const float> density_errors() const;  ///< C = ρ/ρ₀ − 1, measured afresh
  /// Pa, of the last substep. With surface tension σ, what holds attracted particles apart is in it: some 1.3
  /// σ over a spacing, everywhere.
  std::span<const float> pressures() const;
  /// The surface of the fluid is around them: flat along it, a ball where a particle is on its own or inside.
  /// Their centres are smoothed. Grains are balls one spacing across.
  std::span<const Ellipsoid> ellipsoids() const;
  /// Ellipsoids and fluids to arrays on the world's own device, for a renderer there; they are there when it
  /// returns. Right after a step the ellipsoids go by the neighbours of its last substep, which cost no
  /// search: at the surface they differ from ellipsoids() by what came within the support radius since.
  /// Throws Error(invalid_argument) where an array is null.
  void write_particles(const ParticleArrays& arrays) const;
  /// The same to buffers of OpenGL's. OpenGL's commands come before or after, as they were given: the driver
  /// may have the host wait for those before; for what the world does here it does not wait, right after a
  /// step. Throws Error(invalid_argument) where the world is on the CPU, or where the buffers have no room
  /// for all particles.
  void write_particles(GlParticles& buffers) const;
  /// The surface around the ellipsoids, by marching cubes on the device. Particles that are further than 2²¹
  /// cells from the origin are left out. Where there are no particles it is empty. Throws
  /// Error(invalid_argument) and Error(not_found); Error(capacity) where so many cells would be needed that
  /// 32 bits do not count them.
  SurfaceMesh surface_mesh(const SurfaceMeshDef& def = {}) const;

  /// Spray, foam and bubbles, in the order of their making; none without WorldDef::diffuse.
  std::span<const DiffuseParticle> diffuse() const;

  Diagnostics diagnostics() const;
  double probe(ProbeId id) const;  ///< unit by its kind; of the last step
  /// The sum, modulo 2^64, of a hash of each particle's, vertex's and body's number and bits (position,
  /// velocity; rotation). Equal states have equal hashes, in whatever order the device holds them.
  uint64_t state_hash() const;
  std::size_t device_bytes() const;  ///< held on the device
  /// The same, by what it is for, the largest first: once all that has changed is on the device, so that it
  /// is what the next step starts with. A step takes more where it finds more neighbours and contacts than
  /// there is room for. Throws Error(out_of_memory) where there is not enough for that.
  std::vector<MemoryShare> memory_shares() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace meniscus
