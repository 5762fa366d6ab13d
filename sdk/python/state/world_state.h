// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A world as Python holds it: who may call it, the arrays that were read, and what was created in it.
#pragma once

#include <meniscus/scene.h>
#include <meniscus/world.h>
#include <nanobind/nanobind.h>

#include <array>
#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include "sdk/python/state/callable.h"

namespace meniscus::python {

/// The things of one kind that exist, in the order of their creation.
template <class Id, class Def>
struct Registry {
  std::vector<Id> ids;
  std::vector<Def> defs;

  void add(Id id, Def def) {
    ids.push_back(id);
    defs.push_back(std::move(def));
  }
  Def* find(Id id) {
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (ids[i] == id) return &defs[i];
    }
    return nullptr;
  }
  /// Forgets those for which this is false.
  template <class Keep>
  void keep(const Keep& keep_it) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (!keep_it(ids[i])) continue;
      if (kept != i) ids[kept] = ids[i], defs[kept] = std::move(defs[i]);
      ++kept;
    }
    ids.resize(kept);
    defs.erase(defs.begin() + std::ptrdiff_t(kept), defs.end());
  }
};

/// What was created in a world and exists.
struct Things {
  Registry<FluidId, std::variant<FluidDef, GranularDef>> fluids;
  Registry<ShapeId, ShapeDef> shapes;
  Registry<BodyId, BodyDef> bodies;
  Registry<JointId, JointDef> joints;
  Registry<ClothId, ClothDef> cloths;
  Registry<RopeId, RopeDef> ropes;
  Registry<AttachmentId, AttachmentDef> attachments;
  Registry<EmitterId, EmitterDef> emitters;
  Registry<SinkId, SinkDef> sinks;
  Registry<ProbeId, ProbeDef> probes;
  Registry<ForceFieldId, ForceFieldDef> force_fields;
};

/// Arrays that are read from the world. Those of vertices and contacts have an owner each.
enum class ReadoutKind {
  ids,
  positions,
  velocities,
  fluids,
  density_errors,
  pressures,
  ellipsoids,
  diffuse,
  cloth_positions,
  cloth_velocities,
  cloth_normals,
  cloth_triangles,
  cloth_texture,
  cloth_strains,
  cloth_wetness,
  rope_positions,
  rope_velocities,
  rope_frames,
};

class WorldState : public Things {
 public:
  /// The stream is an object that must outlive the world, or none.
  WorldState(const WorldDef& def, nb::object stream);
  WorldState(World world, Things things, nb::object stream);
  WorldState(BuiltScene built, const Scene& scene);

  /// A quick call that changes nothing, under the GIL.
  template <class Call>
  decltype(auto) look(const Call& call) {
    const Turn turn(*this);
    return call(world_);
  }
  /// A long call that changes nothing. Other threads of Python go on.
  template <class Call>
  decltype(auto) measure(const Call& call) {
    const Turn turn(*this);
    return without_gil(call);
  }
  /// A call that changes the world, and with it the values of all arrays that are read later.
  template <class Call>
  decltype(auto) change(const Call& call) {
    const Turn turn(*this);
    forget_arrays();
    return without_gil(call);
  }
  /// An array of the present state. On its first request read_out(world) runs without the GIL, since some
  /// read-outs search neighbours, and wrap(world, values) makes the array.
  template <class ReadOut, class Wrap>
  nb::object array(ReadoutKind kind, uint32_t owner, const ReadOut& read_out, const Wrap& wrap) {
    const Turn turn(*this);
    nb::object& known =
        kind <= ReadoutKind::diffuse ? particle_arrays_[std::size_t(kind)] : owned_arrays_[{kind, owner}];
    if (!known.is_valid()) {
      const auto values = without_gil(read_out);
      known = wrap(world_, values);
    }
    return known;
  }
  /// Ends the long call that runs. Any thread may call it.
  void cancel() { world_.cancel(); }
  /// Drops on_progress, the hooks, read_file and log.
  void forget_functions();

  std::string name;
  float frame_time = 1.0f / 60;  ///< s
  int frames = 250;              ///< of the scene
  std::optional<SceneCamera> camera;
  nb::object on_progress;                          ///< a function of what and fraction, or none
  std::vector<std::pair<HookId, Callable>> hooks;  ///< that the world calls
  Callable read_file;                              ///< that the world calls, or none
  Callable log;                                    ///< that the world calls, or none

 private:
  /// The right to call the world. A thread waits for it without the GIL.
  class Turn {
   public:
    explicit Turn(WorldState& state);
    ~Turn();
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

   private:
    WorldState& state_;
  };

  template <class Call>
  auto without_gil(const Call& call) -> decltype(call(std::declval<World&>())) {
    try {
      if constexpr (std::is_void_v<decltype(call(world_))>) {
        run_without_gil(call);
        raise_if_asked();
      } else {
        auto result = run_without_gil(call);
        raise_if_asked();
        return result;
      }
    } catch (const Error&) {
      raise_if_asked();
      throw;
    }
  }
  template <class Call>
  auto run_without_gil(const Call& call) -> decltype(call(std::declval<World&>())) {
    const nb::gil_scoped_release released;
    return call(world_);
  }
  /// Throws what a signal or on_progress has raised while the call ran.
  void raise_if_asked();
  /// Lets the world report to this. Long calls report at most ten times a second, and signals of Python are
  /// looked for there.
  void listen();
  void report(const Progress& progress) noexcept;
  void forget_arrays();

  nb::object stream_;  ///< lent by Python
  World world_;
  std::mutex mutex_;
  std::atomic<std::thread::id> caller_{};
  std::unique_ptr<nb::python_error> raised_;  ///< by a signal or by on_progress, while a call ran
  std::array<nb::object, std::size_t(ReadoutKind::diffuse) + 1> particle_arrays_;
  std::map<std::pair<ReadoutKind, uint32_t>, nb::object> owned_arrays_;
};

}  // namespace meniscus::python
