// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The table of World's calls that change its state.
#include "sdk/world/recording/replayed_calls.h"

#include <tuple>
#include <utility>

namespace meniscus {

namespace {

using call_text::Ids;
using call_text::Json;

template <class... Args, std::size_t... K>
auto arguments(const Json& call, const Ids& ids, std::index_sequence<K...>) {
  if (call.size() != sizeof...(Args) + 1)
    throw Error(ErrorCode::io, "a call of the recording has another number of arguments");
  return std::tuple{call_text::decode<typename call_text::Held<Args>::Type>(call[K + 1], ids)...};
}

template <auto Call>
struct Make;
template <class Result, class... Args, Result (World::*Call)(Args...)>
struct Make<Call> {
  static void call(World& world, const Json& json, const Ids& ids) {
    auto held = arguments<Args...>(json, ids, std::index_sequence_for<Args...>{});
    std::apply([&](auto&... args) { (world.*Call)(args...); }, held);
  }
};

template <class... Args>
using Setter = void (World::*)(Args...);

/// Members that belong to a program or a machine stay.
void set_def(World& world, const Json& call, const Ids& ids) {
  WorldDef def = world.def();
  const DeviceChoice device = def.device;
  const int threads = def.threads;
  const std::optional<int> cuda_device = def.cuda_device;
  if (call.size() != 2) throw Error(ErrorCode::io, "a call of the recording has another number of arguments");
  definition_json::from_json(call[1], "argument", def, ids);
  def.device = device;
  def.threads = threads;
  def.cuda_device = cuda_device;
  world.set_def(def);
}

/// The name of its call; empty if it is none.
std::string name_of(const Record& record) {
  if (record.kind != RecordKind::call) return {};
  const Json call = Json::from_cbor(record.bytes, true, false);
  return call.is_array() && !call.empty() && call[0].is_string() ? call[0].get<std::string>() : std::string();
}

using Vectors = std::span<const Vec3>;
using ParticleIds = std::span<const ParticleId>;
using Numbers = std::span<const uint32_t>;

}  // namespace

const std::map<std::string, ReplayedCall>& replayed_calls() {
  static const std::map<std::string, ReplayedCall> calls{
      {"set_def", set_def},
      {"create_fluid", Make<&World::create_fluid>::call},
      {"set_fluid", Make<&World::set_fluid>::call},
      {"create_granular", Make<&World::create_granular>::call},
      {"create_shape", Make<&World::create_shape>::call},
      {"destroy_shape", Make<&World::destroy_shape>::call},
      {"create_emitter", Make<&World::create_emitter>::call},
      {"destroy_emitter", Make<&World::destroy_emitter>::call},
      {"create_sink", Make<&World::create_sink>::call},
      {"destroy_sink", Make<&World::destroy_sink>::call},
      {"create_probe", Make<&World::create_probe>::call},
      {"destroy_probe", Make<&World::destroy_probe>::call},
      {"create_body", Make<&World::create_body>::call},
      {"destroy_body", Make<&World::destroy_body>::call},
      {"create_joint", Make<&World::create_joint>::call},
      {"destroy_joint", Make<&World::destroy_joint>::call},
      {"create_cloth", Make<&World::create_cloth>::call},
      {"destroy_cloth", Make<&World::destroy_cloth>::call},
      {"create_rope", Make<&World::create_rope>::call},
      {"destroy_rope", Make<&World::destroy_rope>::call},
      {"create_attachment", Make<&World::create_attachment>::call},
      {"destroy_attachment", Make<&World::destroy_attachment>::call},
      {"create_force_field", Make<&World::create_force_field>::call},
      {"set_force_field", Make<&World::set_force_field>::call},
      {"destroy_force_field", Make<&World::destroy_force_field>::call},
      {"set_wind", Make<&World::set_wind>::call},
      {"add_fluid", Make<&World::add_fluid>::call},
      {"add_particles", Make<&World::add_particles>::call},
      {"remove_particles", Make<&World::remove_particles>::call},
      {"apply_particle_impulses",
       Make<static_cast<Setter<ParticleIds, Vectors>>(&World::apply_impulses)>::call},
      {"apply_cloth_impulses",
       Make<static_cast<Setter<ClothId, Numbers, Vectors>>(&World::apply_impulses)>::call},
      {"apply_rope_impulses",
       Make<static_cast<Setter<RopeId, Numbers, Vectors>>(&World::apply_impulses)>::call},
      {"relax", Make<&World::relax>::call},
      {"set_body_pose", Make<&World::set_body_pose>::call},
      {"set_body_velocity", Make<&World::set_body_velocity>::call},
      {"apply_force", Make<static_cast<Setter<BodyId, Vec3, Vec3>>(&World::apply_force)>::call},
      {"apply_central_force", Make<static_cast<Setter<BodyId, Vec3>>(&World::apply_force)>::call},
      {"apply_torque", Make<&World::apply_torque>::call},
      {"apply_impulse", Make<&World::apply_impulse>::call},
      {"move_body", Make<&World::move_body>::call},
      {"set_positions", Make<static_cast<Setter<Vectors>>(&World::set_positions)>::call},
      {"set_fluid_positions", Make<static_cast<Setter<FluidId, Vectors>>(&World::set_positions)>::call},
      {"set_particle_positions",
       Make<static_cast<Setter<ParticleIds, Vectors>>(&World::set_positions)>::call},
      {"set_velocities", Make<static_cast<Setter<Vectors>>(&World::set_velocities)>::call},
      {"set_fluid_velocities", Make<static_cast<Setter<FluidId, Vectors>>(&World::set_velocities)>::call},
      {"set_particle_velocities",
       Make<static_cast<Setter<ParticleIds, Vectors>>(&World::set_velocities)>::call},
      {"set_cloth_positions", Make<&World::set_cloth_positions>::call},
      {"set_cloth_velocities", Make<&World::set_cloth_velocities>::call},
      {"set_rope_positions", Make<&World::set_rope_positions>::call},
      {"set_rope_velocities", Make<&World::set_rope_velocities>::call},
      {"set_shape_pose", Make<&World::set_shape_pose>::call},
      {"set_fluid_filter",
       Make<static_cast<Setter<FluidId, const CollisionFilter&>>(&World::set_filter)>::call},
      {"set_shape_filter",
       Make<static_cast<Setter<ShapeId, const CollisionFilter&>>(&World::set_filter)>::call},
      {"set_body_filter",
       Make<static_cast<Setter<BodyId, const CollisionFilter&>>(&World::set_filter)>::call},
      {"set_cloth_filter",
       Make<static_cast<Setter<ClothId, const CollisionFilter&>>(&World::set_filter)>::call},
      {"set_rope_filter",
       Make<static_cast<Setter<RopeId, const CollisionFilter&>>(&World::set_filter)>::call},
      {"set_shape_surface", Make<static_cast<Setter<ShapeId, const SurfaceDef&>>(&World::set_surface)>::call},
      {"set_body_surface", Make<static_cast<Setter<BodyId, const SurfaceDef&>>(&World::set_surface)>::call},
  };
  return calls;
}

bool is_step(const Record& record) {
  return name_of(record) == "step";
}

bool changes_definitions(const Record& record) {
  const std::string name = name_of(record);
  return name.starts_with("create_") || name.starts_with("destroy_") || name.ends_with("_filter") ||
         name.ends_with("_surface") || name == "set_fluid" || name == "set_force_field" ||
         name == "set_shape_pose";
}

}  // namespace meniscus
