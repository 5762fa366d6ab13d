// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The public calls of World, each through the boundary.
#include "sdk/world/world_calls.h"

#include <utility>

#include "sdk/world/world_boundary.h"

namespace meniscus {

std::unique_ptr<World::Impl> World::make(const WorldDef& def) {
  return pbd::with_host_memory([&] { return std::make_unique<Impl>(def); });
}

World::World(const WorldDef& def) : impl_(make(def)) {}
World::World(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
World::~World() {
  if (!impl_) return;
  const pbd::CudaScope scope(impl_->device.kind == "cuda" ? impl_->engine->ordinal() : -1);
  impl_.reset();
}
World::World(World&&) noexcept = default;
World& World::operator=(World&& other) noexcept {
  if (this != &other) const World gone(std::exchange(impl_, std::move(other.impl_)));
  return *this;
}

void World::cancel() noexcept {
  impl_->engine->device().monitor().cancel();
}

void World::set_progress(std::function<void(const Progress&)> report) {
  impl_->engine->device().monitor().set_progress(std::move(report));
}

const WorldDef& World::def() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.def(); });
}
void World::set_def(const WorldDef& def) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.set_def(def); });
}
DeviceInfo World::device() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.device(); });
}
float World::support_radius() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.support_radius(); });
}
float World::particle_mass(FluidId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.particle_mass(id); });
}
FluidId World::create_fluid(const FluidDef& def) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.create_fluid(def); });
}
void World::set_fluid(FluidId id, const FluidDef& def) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.set_fluid(id, def); });
}
FluidId World::create_granular(const GranularDef& def) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.create_granular(def); });
}
ShapeId World::create_shape(const ShapeDef& def) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.create_shape(w.inward(def)); });
}
void World::destroy_shape(ShapeId id) {
  return impl_->run_removal([&](auto w) -> decltype(auto) { return w.destroy_shape(id); });
}
EmitterId World::create_emitter(const EmitterDef& def) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.create_emitter(w.inward(def)); });
}
void World::destroy_emitter(EmitterId id) {
  return impl_->run_removal([&](auto w) -> decltype(auto) { return w.destroy_emitter(id); });
}
FlowCount World::emitter_count(EmitterId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.emitter_count(id); });
}
double World::emitter_pressure(EmitterId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.emitter_pressure(id); });
}
SinkId World::create_sink(const SinkDef& def) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.create_sink(w.inward(def)); });
}
void World::destroy_sink(SinkId id) {
  return impl_->run_removal([&](auto w) -> decltype(auto) { return w.destroy_sink(id); });
}
FlowCount World::sink_count(SinkId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.sink_count(id); });
}
ProbeId World::create_probe(const ProbeDef& def) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.create_probe(w.inward(def)); });
}
void World::destroy_probe(ProbeId id) {
  return impl_->run_removal([&](auto w) -> decltype(auto) { return w.destroy_probe(id); });
}
BodyId World::create_body(const BodyDef& def) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.create_body(w.inward(def)); });
}
void World::destroy_body(BodyId id) {
  return impl_->run_removal([&](auto w) -> decltype(auto) { return w.destroy_body(id); });
}
JointId World::create_joint(const JointDef& def) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.create_joint(w.inward(def)); });
}
void World::destroy_joint(JointId id) {
  return impl_->run_removal([&](auto w) -> decltype(auto) { return w.destroy_joint(id); });
}
ClothId World::create_cloth(const ClothDef& def) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.create_cloth(w.inward(def)); });
}
void World::destroy_cloth(ClothId id) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.destroy_cloth(id); });
}
RopeId World::create_rope(const RopeDef& def) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.create_rope(w.inward(def)); });
}
void World::destroy_rope(RopeId id) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.destroy_rope(id); });
}
AttachmentId World::create_attachment(const AttachmentDef& def) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.create_attachment(w.inward(def)); });
}
void World::destroy_attachment(AttachmentId id) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.destroy_attachment(id); });
}
void World::set_wind(const WindDef& wind) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.set_wind(wind); });
}
std::size_t World::add_fluid(const FluidVolumeDef& def) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.add_fluid(w.inward(def)); });
}
ParticleId World::add_particles(FluidId fluid, std::span<const Vec3> positions,
                                std::span<const Vec3> velocities) {
  return impl_->run(
      [&](auto w) -> decltype(auto) { return w.add_particles(fluid, w.inward(positions), velocities); });
}
void World::remove_particles(std::span<const ParticleId> ids) {
  return impl_->run_removal([&](auto w) -> decltype(auto) { return w.remove_particles(ids); });
}
void World::apply_impulses(std::span<const ParticleId> ids, std::span<const Vec3> impulses) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.apply_impulses(ids, impulses); });
}
void World::relax(int iterations) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.relax(iterations); });
}
StepReport World::step(float dt) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.step(dt); });
}
Snapshot World::snapshot() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.snapshot(); });
}
void World::restore(const Snapshot& snapshot) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.restore(snapshot); });
}
void World::save(const std::string& path) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.save(path); });
}
double World::time() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.time(); });
}
BodyState World::body_state(BodyId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.outward(w.body_state(id)); });
}
BodyMass World::body_mass(BodyId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.body_mass(id); });
}
double World::hinge_angle(JointId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.hinge_angle(id); });
}
void World::set_body_pose(BodyId id, const Pose& pose) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.set_body_pose(id, w.inward(pose)); });
}
void World::set_body_velocity(BodyId id, Vec3 velocity, Vec3 angular_velocity) {
  return impl_->run(
      [&](auto w) -> decltype(auto) { return w.set_body_velocity(id, velocity, angular_velocity); });
}
void World::apply_force(BodyId id, Vec3 force, Vec3 point) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.apply_force(id, force, w.inward(point)); });
}
void World::apply_force(BodyId id, Vec3 force) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.apply_force(id, force); });
}
void World::apply_torque(BodyId id, Vec3 torque) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.apply_torque(id, torque); });
}
void World::apply_impulse(BodyId id, Vec3 impulse, Vec3 point) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.apply_impulse(id, impulse, w.inward(point)); });
}
void World::move_body(BodyId id, const Pose& target, float duration) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.move_body(id, w.inward(target), duration); });
}
std::span<const Vec3> World::cloth_positions(ClothId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.outward_positions(id); });
}
std::span<const Vec3> World::cloth_velocities(ClothId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.cloth_velocities(id); });
}
std::span<const Vec3> World::cloth_normals(ClothId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.cloth_normals(id); });
}
std::span<const uint32_t> World::cloth_triangles(ClothId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.cloth_triangles(id); });
}
std::span<const TexturePoint> World::cloth_texture(ClothId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.cloth_texture(id); });
}
uint32_t World::cloth_welded_vertices(ClothId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.cloth_welded_vertices(id); });
}

float World::cloth_bending_fraction(ClothId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.cloth_bending_fraction(id); });
}

const std::vector<MeshRepair>& World::mesh_repairs() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.mesh_repairs(); });
}
std::span<const float> World::cloth_strains(ClothId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.cloth_strains(id); });
}
std::span<const float> World::cloth_wetness(ClothId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.cloth_wetness(id); });
}
ClothState World::cloth_state(ClothId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.outward(w.cloth_state(id)); });
}
const std::vector<TearEvent>& World::tear_events() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.tear_events(); });
}
std::span<const Vec3> World::rope_positions(RopeId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.outward_positions(id); });
}
std::span<const Vec3> World::rope_velocities(RopeId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.rope_velocities(id); });
}
std::span<const Quat> World::rope_frames(RopeId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.rope_frames(id); });
}
void World::apply_impulses(ClothId id, std::span<const uint32_t> vertices, std::span<const Vec3> impulses) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.apply_impulses(id, vertices, impulses); });
}
void World::apply_impulses(RopeId id, std::span<const uint32_t> vertices, std::span<const Vec3> impulses) {
  return impl_->run([&](auto w) -> decltype(auto) { return w.apply_impulses(id, vertices, impulses); });
}
Vec3 World::attachment_force(AttachmentId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.attachment_force(id); });
}
std::vector<uint32_t> World::attachment_vertices(AttachmentId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.attachment_vertices(id); });
}
std::vector<ParticleContact> World::particle_contacts() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.outward(w.particle_contacts()); });
}
std::vector<SolidContact> World::solid_contacts() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.outward(w.solid_contacts()); });
}
const std::vector<ContactEvent>& World::contact_events() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.contact_events(); });
}
std::optional<RayHit> World::cast_ray(Vec3 from, Vec3 to) const {
  return impl_->run(
      [&](auto w) -> decltype(auto) { return w.outward(w.cast_ray(w.inward(from), w.inward(to))); });
}
std::vector<float> World::solid_distances(std::span<const Vec3> points, float reach,
                                          const CollisionFilter& filter) const {
  return impl_->run(
      [&](auto w) -> decltype(auto) { return w.solid_distances(w.inward(points), reach, filter); });
}
Overlaps World::overlap_ball(Vec3 centre, float radius) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.overlap_ball(w.inward(centre), radius); });
}
Overlaps World::overlap_box(const Pose& pose, Vec3 half_extents) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.overlap_box(w.inward(pose), half_extents); });
}
std::size_t World::particle_count() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.particle_count(); });
}
std::span<const ParticleId> World::ids() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.ids(); });
}
std::span<const Vec3> World::positions() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.outward_positions(); });
}
std::span<const Vec3> World::velocities() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.velocities(); });
}
std::span<const uint32_t> World::fluids() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.fluids(); });
}
std::span<const float> World::density_errors() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.density_errors(); });
}
std::span<const float> World::pressures() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.pressures(); });
}
std::span<const Ellipsoid> World::ellipsoids() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.outward_ellipsoids(); });
}
std::shared_ptr<const void> World::hold(const void* first) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.hold(first); });
}
void World::write_particles(const ParticleArrays& arrays) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.write_particles(arrays); });
}
void World::write_particles(GlParticles& buffers) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.write_particles(buffers); });
}
SurfaceMesh World::surface_mesh(const SurfaceMeshDef& def) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.outward(w.surface_mesh(def)); });
}
std::span<const DiffuseParticle> World::diffuse() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.outward_diffuse(); });
}
Diagnostics World::diagnostics() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.diagnostics(); });
}
Vec3 World::probe_vector(ProbeId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.probe_vector(id); });
}
double World::probe(ProbeId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.probe(id); });
}
uint64_t World::state_hash() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.state_hash(); });
}
std::vector<std::string> World::warnings() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.warnings(); });
}
std::size_t World::device_bytes() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.device_bytes(); });
}
std::vector<MemoryShare> World::memory_shares() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.memory_shares(); });
}

}  // namespace meniscus
