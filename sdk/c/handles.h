// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What the handles of C are, and how plain values and ids of C and C++ become one another.
#pragma once

#include <meniscus/meniscus_c.h>
#include <meniscus/scene.h>

#include <cstring>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "sdk/c/status.h"

namespace meniscus::c {

/// In the order of MeniscusDefKind.
using AnyDef = std::variant<WorldDef, FluidDef, GranularDef, FluidVolumeDef, ShapeDef, BodyDef, JointDef,
                            ClothDef, RopeDef, AttachmentDef, WindDef, EmitterDef, SinkDef, ProbeDef,
                            SurfaceMeshDef, ForceFieldDef>;
static_assert(std::variant_size_v<AnyDef> == MENISCUS_FORCE_FIELD_DEF + 1);

/// The objects of a built scene, for meniscus_scene_item().
struct SceneItems {
  struct Item {
    MeniscusId id;
    std::string name;
  };
  std::vector<Item> of_kind[MENISCUS_FORCE_FIELD + 1];
};

}  // namespace meniscus::c

struct MeniscusDef {
  meniscus::c::AnyDef def;
};

struct MeniscusScene {
  meniscus::Scene scene;
};

struct MeniscusGlParticles {
  meniscus::GlParticles buffers;
};

/// A world, with the arrays that its read-outs have filled.
struct MeniscusWorld {
  meniscus::World world;
  meniscus::c::SceneItems items{};

  meniscus::DeviceInfo device{};
  std::vector<std::string> warnings{};
  std::vector<const char*> warning_texts{};
  std::vector<meniscus::MemoryShare> memory{};
  std::vector<MeniscusMemoryShare> memory_shares{};
  std::vector<MeniscusMeshRepair> repairs{};
  std::vector<MeniscusTearEvent> tears{};
  std::vector<uint32_t> attachment_vertices{};
  std::vector<MeniscusParticleContact> particle_contacts{};
  std::vector<MeniscusSolidContact> solid_contacts{};
  std::vector<MeniscusContactEvent> contact_events{};
  std::vector<MeniscusSleepEvent> sleep_events{};
  std::vector<MeniscusFlowEvent> flow_events{};
  std::vector<MeniscusId> overlap_things{};
  std::vector<uint64_t> overlap_particles{};
  std::vector<MeniscusId> objects[MENISCUS_FORCE_FIELD + 1]{};
  meniscus::SurfaceMesh surface{};
};

namespace meniscus::c {

// ---- plain values ----

template <class To, class From>
const To* same_layout(const From* values) {
  static_assert(sizeof(To) == sizeof(From) && alignof(To) == alignof(From));
  static_assert(std::is_standard_layout_v<To> && std::is_standard_layout_v<From>);
  return reinterpret_cast<const To*>(values);
}

inline Vec3 in_cpp(MeniscusVec3 v) {
  return {v.x, v.y, v.z};
}
inline Quat in_cpp(MeniscusQuat q) {
  return {q.x, q.y, q.z, q.w};
}
inline Pose in_cpp(const MeniscusPose& p) {
  return {in_cpp(p.position), in_cpp(p.rotation)};
}
inline MeniscusVec3 in_c(Vec3 v) {
  return {v.x, v.y, v.z};
}
inline MeniscusQuat in_c(Quat q) {
  return {q.x, q.y, q.z, q.w};
}
inline MeniscusPose in_c(const Pose& p) {
  return {in_c(p.position), in_c(p.rotation)};
}

// ---- ids ----

template <class IdType>
inline constexpr MeniscusKind kind_of = MENISCUS_NONE;
template <>
inline constexpr MeniscusKind kind_of<FluidId> = MENISCUS_FLUID;
template <>
inline constexpr MeniscusKind kind_of<ShapeId> = MENISCUS_SHAPE;
template <>
inline constexpr MeniscusKind kind_of<BodyId> = MENISCUS_BODY;
template <>
inline constexpr MeniscusKind kind_of<JointId> = MENISCUS_JOINT;
template <>
inline constexpr MeniscusKind kind_of<ClothId> = MENISCUS_CLOTH;
template <>
inline constexpr MeniscusKind kind_of<RopeId> = MENISCUS_ROPE;
template <>
inline constexpr MeniscusKind kind_of<AttachmentId> = MENISCUS_ATTACHMENT;
template <>
inline constexpr MeniscusKind kind_of<EmitterId> = MENISCUS_EMITTER;
template <>
inline constexpr MeniscusKind kind_of<SinkId> = MENISCUS_SINK;
template <>
inline constexpr MeniscusKind kind_of<ProbeId> = MENISCUS_PROBE;
template <>
inline constexpr MeniscusKind kind_of<ForceFieldId> = MENISCUS_FORCE_FIELD;

/// "body" for MENISCUS_BODY.
const char* kind_name(uint32_t kind);

template <class IdType>
MeniscusId in_c(IdType id) {
  return {kind_of<IdType>, id.index, id.generation};
}

/// Throws Error(invalid_argument) if the id is of another kind.
template <class IdType>
IdType in_cpp(MeniscusId id) {
  if (id.kind == kind_of<IdType>) return {id.index, id.generation};
  throw Error(ErrorCode::invalid_argument, std::string("the id is of a ") + kind_name(id.kind) +
                                               "; it must be of a " + kind_name(kind_of<IdType>));
}

// ---- handles ----

inline World& world_of(MeniscusWorld* world) {
  return required(world, "world").world;
}
inline const World& world_of(const MeniscusWorld* world) {
  return required(world, "world").world;
}

/// The definition in a handle. Throws Error(invalid_argument) if it is of another kind.
template <class Def>
const Def& def_of(const MeniscusDef* def) {
  const auto* const held = std::get_if<Def>(&required(def, "def").def);
  if (held) return *held;
  throw Error(ErrorCode::invalid_argument, "def is a definition of another kind");
}

// ---- results ----

/// Throws Error(invalid_argument) unless the size is possible for this struct.
template <class Result>
void check_size(const Result& out) {
  if (out.size >= sizeof out.size && out.size <= sizeof(Result)) return;
  throw Error(ErrorCode::invalid_argument, "size is " + std::to_string(out.size) + "; it must be at most " +
                                               std::to_string(sizeof(Result)) +
                                               ", the size of the struct in this library");
}

/// Writes a result that begins with its size, as far as the caller's struct goes.
template <class Result>
void write_result(Result* out, Result result) {
  check_size(required(out, "result"));
  result.size = out->size;
  std::memcpy(out, &result, out->size);
}

/// Hands out an array that the world owns.
template <class T, class List>
void write_array(const T** values, std::size_t* count, const List& list) {
  required(values, "array");
  required(count, "count");
  *values = list.data();
  *count = list.size();
}
/// The same, of an array with another name for the same layout.
template <class T, class List>
void write_same(const T** values, std::size_t* count, const List& list) {
  required(values, "array");
  required(count, "count");
  *values = same_layout<T>(list.data());
  *count = list.size();
}

}  // namespace meniscus::c
