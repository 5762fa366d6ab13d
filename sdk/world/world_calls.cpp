// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The public calls of World, each through the boundary.
#include "sdk/world/world_calls.h"

#include <utility>

#include "sdk/world/world_boundary.h"
#include "sdk/world/world_recorded.h"

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
  if (this == &other) return *this;
  World gone(std::move(other));
  impl_.swap(gone.impl_);  // it is never null, as a signal may cancel() meanwhile
  return *this;
}

void World::cancel() noexcept {
  impl_->engine->device().monitor().cancel();
}

void World::set_progress(std::function<void(const Progress&)> report) {
  impl_->engine->device().monitor().set_progress(report);
  impl_->progress = std::move(report);
}

const WorldDef& World::def() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.def(); });
}
void World::set_def(const WorldDef& def) {
  return impl_->recorded(
      "set_def", [&](auto w) { return w.set_def(def); }, def);
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
  return impl_->recorded(
      "create_fluid", [&](auto w) { return w.create_fluid(def); }, def);
}
void World::set_fluid(FluidId id, const FluidDef& def) {
  return impl_->recorded(
      "set_fluid", [&](auto w) { return w.set_fluid(id, def); }, id, def);
}
FluidId World::create_granular(const GranularDef& def) {
  return impl_->recorded(
      "create_granular", [&](auto w) { return w.create_granular(def); }, def);
}
ShapeId World::create_shape(const ShapeDef& def) {
  return impl_->recorded(
      "create_shape", [&](auto w) { return w.create_shape(w.inward(def)); }, def);
}
void World::destroy_shape(ShapeId id) {
  return impl_->recorded_removal(
      "destroy_shape", [&](auto w) { return w.destroy_shape(id); }, id);
}
EmitterId World::create_emitter(const EmitterDef& def) {
  return impl_->recorded(
      "create_emitter", [&](auto w) { return w.create_emitter(w.inward(def)); }, def);
}
void World::destroy_emitter(EmitterId id) {
  return impl_->recorded_removal(
      "destroy_emitter", [&](auto w) { return w.destroy_emitter(id); }, id);
}
FlowCount World::emitter_count(EmitterId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.emitter_count(id); });
}
double World::emitter_pressure(EmitterId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.emitter_pressure(id); });
}
SinkId World::create_sink(const SinkDef& def) {
  return impl_->recorded(
      "create_sink", [&](auto w) { return w.create_sink(w.inward(def)); }, def);
}
void World::destroy_sink(SinkId id) {
  return impl_->recorded_removal(
      "destroy_sink", [&](auto w) { return w.destroy_sink(id); }, id);
}
FlowCount World::sink_count(SinkId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.sink_count(id); });
}
ProbeId World::create_probe(const ProbeDef& def) {
  return impl_->recorded(
      "create_probe", [&](auto w) { return w.create_probe(w.inward(def)); }, def);
}
void World::destroy_probe(ProbeId id) {
  return impl_->recorded_removal(
      "destroy_probe", [&](auto w) { return w.destroy_probe(id); }, id);
}
BodyId World::create_body(const BodyDef& def) {
  return impl_->recorded(
      "create_body", [&](auto w) { return w.create_body(w.inward(def)); }, def);
}
void World::destroy_body(BodyId id) {
  return impl_->recorded_removal(
      "destroy_body", [&](auto w) { return w.destroy_body(id); }, id);
}
JointId World::create_joint(const JointDef& def) {
  return impl_->recorded(
      "create_joint", [&](auto w) { return w.create_joint(w.inward(def)); }, def);
}
void World::destroy_joint(JointId id) {
  return impl_->recorded_removal(
      "destroy_joint", [&](auto w) { return w.destroy_joint(id); }, id);
}
ClothId World::create_cloth(const ClothDef& def) {
  return impl_->recorded(
      "create_cloth", [&](auto w) { return w.create_cloth(w.inward(def)); }, def);
}
void World::destroy_cloth(ClothId id) {
  return impl_->recorded(
      "destroy_cloth", [&](auto w) { return w.destroy_cloth(id); }, id);
}
RopeId World::create_rope(const RopeDef& def) {
  return impl_->recorded(
      "create_rope", [&](auto w) { return w.create_rope(w.inward(def)); }, def);
}
void World::destroy_rope(RopeId id) {
  return impl_->recorded(
      "destroy_rope", [&](auto w) { return w.destroy_rope(id); }, id);
}
AttachmentId World::create_attachment(const AttachmentDef& def) {
  return impl_->recorded(
      "create_attachment", [&](auto w) { return w.create_attachment(w.inward(def)); }, def);
}
void World::destroy_attachment(AttachmentId id) {
  return impl_->recorded(
      "destroy_attachment", [&](auto w) { return w.destroy_attachment(id); }, id);
}
void World::set_wind(const WindDef& wind) {
  return impl_->recorded(
      "set_wind", [&](auto w) { return w.set_wind(wind); }, wind);
}
std::size_t World::add_fluid(const FluidVolumeDef& def) {
  return impl_->recorded(
      "add_fluid", [&](auto w) { return w.add_fluid(w.inward(def)); }, def);
}
ParticleId World::add_particles(FluidId fluid, std::span<const Vec3> positions,
                                std::span<const Vec3> velocities) {
  return impl_->recorded(
      "add_particles", [&](auto w) { return w.add_particles(fluid, w.inward(positions), velocities); }, fluid,
      positions, velocities);
}
void World::remove_particles(std::span<const ParticleId> ids) {
  return impl_->recorded_removal(
      "remove_particles", [&](auto w) { return w.remove_particles(ids); }, ids);
}
void World::relax(int iterations) {
  try {
    impl_->recorded(
        "relax", [&](auto w) { w.relax(iterations); }, iterations);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::cancelled) impl_->note_state();  // the iterations so far remain
    throw;
  }
}
StepReport World::step(float dt, std::optional<int> iterations) {
  const StepReport report = impl_->run([&](auto w) { return w.step(dt, iterations); });
  impl_->note_step(dt, report);
  return report;
}
Snapshot World::snapshot() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.snapshot(); });
}
void World::restore(const Snapshot& snapshot) {
  impl_->run([&](auto w) { w.restore(snapshot); });
  impl_->note_state();
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
Vec3 World::attachment_force(AttachmentId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.attachment_force(id); });
}
std::vector<uint32_t> World::attachment_vertices(AttachmentId id) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.attachment_vertices(id); });
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
MemoryStats World::memory_stats() const {
  return impl_->run([&](auto w) { return w.memory_stats(); });
}

}  // namespace meniscus
