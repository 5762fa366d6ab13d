// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// World's calls that list what exists, and find it by name.
#include <meniscus/error.h>
#include <meniscus/world.h>

#include "sdk/world/world_boundary.h"
#include "sdk/world/world_calls.h"

namespace meniscus {

namespace {

template <class Entry>
const std::string& name_of(const Entry& entry) {
  if constexpr (requires { entry.def; })
    return entry.def.name;
  else
    return entry.name;
}

template <class Id, class Entry>
Id find(const IdTable<Id, Entry>& table, const std::string& name) {
  const auto id = table.find_first([&](const Entry& entry) { return name_of(entry) == name; });
  if (id) return *id;
  throw Error(ErrorCode::not_found, std::string("no ") + table.what() + " is called \"" + name + "\"");
}

}  // namespace

std::vector<FluidId> World::Calls::fluid_ids() const {
  return impl_->fluids.ids();
}
std::vector<ShapeId> World::Calls::shape_ids() const {
  return impl_->shapes.ids();
}
std::vector<BodyId> World::Calls::body_ids() const {
  return impl_->bodies.ids();
}
std::vector<JointId> World::Calls::joint_ids() const {
  return impl_->joints.ids();
}
std::vector<ClothId> World::Calls::cloth_ids() const {
  return impl_->cloths.ids();
}
std::vector<RopeId> World::Calls::rope_ids() const {
  return impl_->ropes.ids();
}
std::vector<AttachmentId> World::Calls::attachment_ids() const {
  return impl_->attachments.ids();
}
std::vector<EmitterId> World::Calls::emitter_ids() const {
  return impl_->emitters.ids();
}
std::vector<SinkId> World::Calls::sink_ids() const {
  return impl_->sinks.ids();
}
std::vector<ProbeId> World::Calls::probe_ids() const {
  return impl_->probes.ids();
}

FluidId World::Calls::find_fluid(const std::string& name) const {
  return find(impl_->fluids, name);
}
ShapeId World::Calls::find_shape(const std::string& name) const {
  return find(impl_->shapes, name);
}
BodyId World::Calls::find_body(const std::string& name) const {
  return find(impl_->bodies, name);
}
JointId World::Calls::find_joint(const std::string& name) const {
  return find(impl_->joints, name);
}
ClothId World::Calls::find_cloth(const std::string& name) const {
  return find(impl_->cloths, name);
}
RopeId World::Calls::find_rope(const std::string& name) const {
  return find(impl_->ropes, name);
}
AttachmentId World::Calls::find_attachment(const std::string& name) const {
  return find(impl_->attachments, name);
}
EmitterId World::Calls::find_emitter(const std::string& name) const {
  return find(impl_->emitters, name);
}
SinkId World::Calls::find_sink(const std::string& name) const {
  return find(impl_->sinks, name);
}

ForceFieldId World::Calls::find_force_field(const std::string& name) const {
  return find(impl_->force_fields, name);
}
ProbeId World::Calls::find_probe(const std::string& name) const {
  return find(impl_->probes, name);
}

// ---- through the boundary ----

std::vector<FluidId> World::fluid_ids() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.fluid_ids(); });
}
std::vector<ShapeId> World::shape_ids() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.shape_ids(); });
}
std::vector<BodyId> World::body_ids() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.body_ids(); });
}
std::vector<JointId> World::joint_ids() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.joint_ids(); });
}
std::vector<ClothId> World::cloth_ids() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.cloth_ids(); });
}
std::vector<RopeId> World::rope_ids() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.rope_ids(); });
}
std::vector<AttachmentId> World::attachment_ids() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.attachment_ids(); });
}
std::vector<EmitterId> World::emitter_ids() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.emitter_ids(); });
}
std::vector<SinkId> World::sink_ids() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.sink_ids(); });
}
std::vector<ProbeId> World::probe_ids() const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.probe_ids(); });
}
FluidId World::find_fluid(const std::string& name) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.find_fluid(name); });
}
ShapeId World::find_shape(const std::string& name) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.find_shape(name); });
}
BodyId World::find_body(const std::string& name) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.find_body(name); });
}
JointId World::find_joint(const std::string& name) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.find_joint(name); });
}
ClothId World::find_cloth(const std::string& name) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.find_cloth(name); });
}
RopeId World::find_rope(const std::string& name) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.find_rope(name); });
}
AttachmentId World::find_attachment(const std::string& name) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.find_attachment(name); });
}
EmitterId World::find_emitter(const std::string& name) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.find_emitter(name); });
}
SinkId World::find_sink(const std::string& name) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.find_sink(name); });
}
ForceFieldId World::find_force_field(const std::string& name) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.find_force_field(name); });
}
ProbeId World::find_probe(const std::string& name) const {
  return impl_->run([&](auto w) -> decltype(auto) { return w.find_probe(name); });
}

}  // namespace meniscus
