// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Worlds of C: objects, steps and diagnostics.
#include <meniscus/c/world.h>

#include <iterator>
#include <memory>
#include <span>

#include "sdk/c/handles.h"

namespace meniscus::c {
namespace {

MeniscusDeviceInfo info_of(const DeviceInfo& device) {
  return {0,
          device.usable ? 1 : 0,
          device.kind.c_str(),
          device.name.c_str(),
          device.reason.c_str(),
          device.memory_bytes};
}

/// Creates what a definition describes.
struct Create {
  World& world;

  MeniscusId operator()(const FluidDef& def) const { return in_c(world.create_fluid(def)); }
  MeniscusId operator()(const GranularDef& def) const { return in_c(world.create_granular(def)); }
  MeniscusId operator()(const ShapeDef& def) const { return in_c(world.create_shape(def)); }
  MeniscusId operator()(const BodyDef& def) const { return in_c(world.create_body(def)); }
  MeniscusId operator()(const JointDef& def) const { return in_c(world.create_joint(def)); }
  MeniscusId operator()(const ClothDef& def) const { return in_c(world.create_cloth(def)); }
  MeniscusId operator()(const RopeDef& def) const { return in_c(world.create_rope(def)); }
  MeniscusId operator()(const AttachmentDef& def) const { return in_c(world.create_attachment(def)); }
  MeniscusId operator()(const EmitterDef& def) const { return in_c(world.create_emitter(def)); }
  MeniscusId operator()(const SinkDef& def) const { return in_c(world.create_sink(def)); }
  MeniscusId operator()(const ProbeDef& def) const { return in_c(world.create_probe(def)); }
  MeniscusId operator()(const ForceFieldDef& def) const { return in_c(world.create_force_field(def)); }
  template <class Other>
  MeniscusId operator()(const Other&) const {
    throw Error(ErrorCode::invalid_argument, "def is no definition of an object");
  }
};

void destroy(World& world, MeniscusId id) {
  switch (id.kind) {
    case MENISCUS_SHAPE:
      return world.destroy_shape(in_cpp<ShapeId>(id));
    case MENISCUS_BODY:
      return world.destroy_body(in_cpp<BodyId>(id));
    case MENISCUS_JOINT:
      return world.destroy_joint(in_cpp<JointId>(id));
    case MENISCUS_CLOTH:
      return world.destroy_cloth(in_cpp<ClothId>(id));
    case MENISCUS_ROPE:
      return world.destroy_rope(in_cpp<RopeId>(id));
    case MENISCUS_ATTACHMENT:
      return world.destroy_attachment(in_cpp<AttachmentId>(id));
    case MENISCUS_EMITTER:
      return world.destroy_emitter(in_cpp<EmitterId>(id));
    case MENISCUS_SINK:
      return world.destroy_sink(in_cpp<SinkId>(id));
    case MENISCUS_PROBE:
      return world.destroy_probe(in_cpp<ProbeId>(id));
    case MENISCUS_FORCE_FIELD:
      return world.destroy_force_field(in_cpp<ForceFieldId>(id));
    default:
      throw Error(ErrorCode::invalid_argument,
                  std::string("the id is of a ") + kind_name(id.kind) + ", which cannot be destroyed");
  }
}

MeniscusStepReport report_of(const StepReport& r) {
  MeniscusStepReport c{};
  c.substeps = r.substeps;
  c.iterations = r.iterations;
  c.contacts = r.contacts;
  c.density_iterations = r.density_iterations;
  c.ms = r.ms;
  static_assert(sizeof c.stage_ms == sizeof r.stage_ms);
  std::memcpy(c.stage_ms, r.stage_ms.data(), sizeof c.stage_ms);
  c.rigid_ms = r.rigid_ms;
  c.emission_refused = r.emission_refused;
  c.max_neighbours = r.max_neighbours;
  c.removed = r.removed;
  c.emitted = r.emitted;
  c.absorbed = r.absorbed;
  c.dripped = r.dripped;
  c.diffuse = r.diffuse;
  c.diffuse_refused = r.diffuse_refused;
  c.max_speed = r.max_speed;
  c.cloth_layer_overflows = r.overflows.cloth_layers;
  c.cloth_vertex_overflows = r.overflows.cloth_vertices;
  c.fluid_failsafe_overflows = r.overflows.fluid_failsafe;
  c.cloth_failsafe_overflows = r.overflows.cloth_failsafe;
  c.emitter_hold_overflows = r.overflows.emitter_hold;
  return c;
}

std::span<const Vec3> vectors_of(const MeniscusVec3* values, std::size_t count, const char* name) {
  return {same_layout<Vec3>(required_array(values, count, name)), count};
}

}  // namespace

const char* kind_name(uint32_t kind) {
  constexpr const char* names[] = {"nothing", "fluid",      "shape",   "body", "joint", "cloth",
                                   "rope",    "attachment", "emitter", "sink", "probe", "force field"};
  return kind < std::size(names) ? names[kind] : "unknown kind";
}

}  // namespace meniscus::c

using namespace meniscus::c;
using namespace meniscus;

MeniscusStatus meniscus_world_create(const MeniscusDef* def, MeniscusWorld** world) {
  return guarded([&] {
    MeniscusWorld*& out = required(world, "world");
    out = std::make_unique<MeniscusWorld>(MeniscusWorld{World(def ? def_of<WorldDef>(def) : WorldDef{})})
              .release();
  });
}

void meniscus_world_destroy(MeniscusWorld* world) {
  delete world;
}

MeniscusStatus meniscus_def(const MeniscusWorld* world, MeniscusDef** def) {
  return guarded([&] {
    MeniscusDef*& out = required(def, "def");
    out = std::make_unique<MeniscusDef>(MeniscusDef{world_of(world).def()}).release();
  });
}

MeniscusStatus meniscus_set_def(MeniscusWorld* world, const MeniscusDef* def) {
  return guarded([&] { world_of(world).set_def(def_of<WorldDef>(def)); });
}

MeniscusStatus meniscus_device(MeniscusWorld* world, MeniscusDeviceInfo* info) {
  return guarded([&] {
    MeniscusWorld& w = required(world, "world");
    w.device = w.world.device();
    write_result(info, info_of(w.device));
  });
}

MeniscusStatus meniscus_list_device(size_t number, MeniscusDeviceInfo* info) {
  return guarded([&] {
    static thread_local std::vector<DeviceInfo> devices;
    devices = list_devices();
    if (number >= devices.size())
      throw Error(ErrorCode::not_found, "there are " + std::to_string(devices.size()) + " devices");
    write_result(info, info_of(devices[number]));
  });
}

MeniscusStatus meniscus_support_radius(const MeniscusWorld* world, float* radius) {
  return guarded([&] { required(radius, "radius") = world_of(world).support_radius(); });
}

MeniscusStatus meniscus_particle_mass(const MeniscusWorld* world, MeniscusId fluid, float* mass) {
  return guarded([&] { required(mass, "mass") = world_of(world).particle_mass(in_cpp<FluidId>(fluid)); });
}

MeniscusStatus meniscus_create(MeniscusWorld* world, const MeniscusDef* def, MeniscusId* id) {
  return guarded([&] {
    MeniscusId& out = required(id, "id");
    out = std::visit(Create{world_of(world)}, required(def, "def").def);
  });
}

MeniscusStatus meniscus_destroy(MeniscusWorld* world, MeniscusId id) {
  return guarded([&] { destroy(world_of(world), id); });
}

MeniscusStatus meniscus_set_fluid(MeniscusWorld* world, MeniscusId fluid, const MeniscusDef* def) {
  return guarded([&] { world_of(world).set_fluid(in_cpp<FluidId>(fluid), def_of<FluidDef>(def)); });
}

MeniscusStatus meniscus_set_force_field(MeniscusWorld* world, MeniscusId field, const MeniscusDef* def) {
  return guarded(
      [&] { world_of(world).set_force_field(in_cpp<ForceFieldId>(field), def_of<ForceFieldDef>(def)); });
}

MeniscusStatus meniscus_set_wind(MeniscusWorld* world, const MeniscusDef* wind) {
  return guarded([&] { world_of(world).set_wind(def_of<WindDef>(wind)); });
}

MeniscusStatus meniscus_add_fluid(MeniscusWorld* world, const MeniscusDef* volume, size_t* count) {
  return guarded([&] {
    const std::size_t added = world_of(world).add_fluid(def_of<FluidVolumeDef>(volume));
    if (count) *count = added;
  });
}

MeniscusStatus meniscus_add_particles(MeniscusWorld* world, MeniscusId fluid, const MeniscusVec3* positions,
                                      const MeniscusVec3* velocities, size_t count, uint64_t* first) {
  return guarded([&] {
    const std::span<const Vec3> at = vectors_of(positions, count, "positions");
    const std::span<const Vec3> moving =
        velocities ? vectors_of(velocities, count, "velocities") : std::span<const Vec3>{};
    const ParticleId id = world_of(world).add_particles(in_cpp<FluidId>(fluid), at, moving);
    if (first) *first = id;
  });
}

MeniscusStatus meniscus_remove_particles(MeniscusWorld* world, const uint64_t* ids, size_t count) {
  return guarded([&] { world_of(world).remove_particles({required_array(ids, count, "ids"), count}); });
}

MeniscusStatus meniscus_apply_particle_impulses(MeniscusWorld* world, const uint64_t* ids,
                                                const MeniscusVec3* impulses, size_t count) {
  return guarded([&] {
    world_of(world).apply_impulses(std::span<const ParticleId>(required_array(ids, count, "ids"), count),
                                   vectors_of(impulses, count, "impulses"));
  });
}

MeniscusStatus meniscus_relax(MeniscusWorld* world, int iterations) {
  return guarded([&] { world_of(world).relax(iterations); });
}

MeniscusStatus meniscus_step(MeniscusWorld* world, float dt, MeniscusStepReport* report) {
  return guarded([&] {
    if (report) check_size(*report);  // before the step: a failing call changes nothing
    const StepReport made = world_of(world).step(dt);
    if (report) write_result(report, report_of(made));
  });
}

MeniscusStatus meniscus_step_begin(MeniscusWorld* world, float dt) {
  return guarded([&] { world_of(world).step_begin(dt); });
}

MeniscusStatus meniscus_step_end(MeniscusWorld* world, MeniscusStepReport* report) {
  return guarded([&] {
    if (report) check_size(*report);
    const StepReport made = world_of(world).step_end();
    if (report) write_result(report, report_of(made));
  });
}

MeniscusStatus meniscus_step_iterated(MeniscusWorld* world, float dt, int iterations,
                                      MeniscusStepReport* report) {
  return guarded([&] {
    if (report) check_size(*report);
    const StepReport made = world_of(world).step(dt, iterations);
    if (report) write_result(report, report_of(made));
  });
}

MeniscusStatus meniscus_step_begin_iterated(MeniscusWorld* world, float dt, int iterations) {
  return guarded([&] { world_of(world).step_begin(dt, iterations); });
}

const char* meniscus_stage_name(size_t stage) {
  return stage < stage_count ? stage_name(static_cast<Stage>(stage)) : nullptr;
}

MeniscusStatus meniscus_time(const MeniscusWorld* world, double* time) {
  return guarded([&] { required(time, "time") = world_of(world).time(); });
}

MeniscusStatus meniscus_cancel(MeniscusWorld* world) {
  if (!world) return guarded([&] { required(world, "world"); });
  world->world.cancel();
  return MENISCUS_OK;
}

MeniscusStatus meniscus_set_progress(MeniscusWorld* world,
                                     void (*report)(const char* what, double fraction, void* user),
                                     void* user) {
  return guarded([&] {
    if (!report) return world_of(world).set_progress(nullptr);
    world_of(world).set_progress(
        [report, user](const Progress& progress) { report(progress.what, progress.fraction, user); });
  });
}

MeniscusStatus meniscus_warnings(MeniscusWorld* world, const char* const** texts, size_t* count) {
  return guarded([&] {
    MeniscusWorld& w = required(world, "world");
    w.warnings = w.world.warnings();
    w.warning_texts.clear();
    for (const std::string& warning : w.warnings) w.warning_texts.push_back(warning.c_str());
    write_array(texts, count, w.warning_texts);
  });
}
