// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Many worlds of as many particles each, in the arrays of one solver. The particles of a world follow one
// another, in memory as by slot: with n particles each, particle i belongs to world i / n, before and after
// each sort, as the world leads in the cells' keys. All positions are local to their world.
#pragma once

#include "pbd/device/buffer.h"
#include "pbd/particles.h"

namespace meniscus::pbd {

/// Some of a batch's worlds.
struct ChosenWorlds {
  View<const uint32_t> chosen;  ///< by world, 1 or 0; empty: all
  uint32_t each;                ///< particles of a world
  uint32_t count;               ///< particles of all worlds

  MENISCUS_HD bool has(uint32_t i) const { return chosen.count == 0 || chosen[i / each] != 0; }
};

/// By world, m/s².
struct WorldGravities {
  View<const Vec4> gravity;
  uint32_t each = 1;

  /// Of the world of particle i, or `common` if worlds have none of their own.
  MENISCUS_HD Vec3 of(uint32_t i, Vec3 common) const {
    return gravity.count ? load(gravity, i / each).xyz() : common;
  }
};

/// Whether the source has one world, which all get, or as many as the target.
enum class WorldsFrom : uint32_t { one, all };

namespace world_kernels {

template <class T>
struct Write {
  ChosenWorlds worlds;
  View<const T> from;
  View<T> to;
  WorldsFrom kind;

  MENISCUS_HD void operator()(uint32_t i) const {
    if (worlds.has(i)) to[i] = from[kind == WorldsFrom::one ? i % worlds.each : i];
  }
};

/// Slots of a kept world, moved to where the worlds have theirs.
struct WriteSlots {
  ChosenWorlds worlds;
  View<const uint32_t> from;
  View<uint32_t> to;

  MENISCUS_HD void operator()(uint32_t i) const {
    if (worlds.has(i)) to[i] = i - i % worlds.each + from[i % worlds.each];
  }
};

}  // namespace world_kernels

/// Writes `from` to the chosen worlds.
template <class D, class T>
void write_worlds(D& device, const char* name, const ChosenWorlds& worlds, View<const T> from, View<T> to,
                  WorldsFrom kind) {
  device.parallel_for(name, worlds.count, world_kernels::Write<T>{worlds, from, to, kind});
}

/// The particles of one world, to which worlds are reset.
template <class D>
class KeptWorld {
 public:
  KeptWorld(D& device, Particles& particles) : device_(device), particles_(particles) {}

  /// Keeps the present state of the first `each` particles.
  void keep(uint32_t each) {
    const auto copy = [&]<class T>(Buffer<T>& to, View<const T> from) {
      to.resize_discard(each);
      device_.copy(to.view().data, from.data, each * sizeof(T));
    };
    const ParticleView p = particles_.view();
    copy(position_, View<const Vec4>(p.position));
    copy(velocity_, View<const Vec4>(p.velocity));
    copy(phase_, p.phase);
    copy(slot_, p.slot);
    copy(number_, p.number);
  }

  void reset_worlds(const ChosenWorlds& worlds) {
    device_.parallel_for("worlds/slots", worlds.count,
                         world_kernels::WriteSlots{worlds, slot_.view(), particles_.slot.current.view()});
    ParticleView kept{};
    kept.position = position_.view();
    kept.velocity = velocity_.view();
    kept.phase = phase_.view();
    kept.number = number_.view();
    write(worlds, kept, WorldsFrom::one);
  }

  /// The state at the last Particles::save().
  void undo_worlds(const ChosenWorlds& worlds) {
    const ParticleView before = particles_.saved();
    write_worlds(device_, "worlds/slots", worlds, before.slot, particles_.slot.current.view(),
                 WorldsFrom::all);
    write(worlds, before, WorldsFrom::all);
  }

 private:
  void write(const ChosenWorlds& worlds, const ParticleView& from, WorldsFrom kind) {
    write_worlds(device_, "worlds/positions", worlds, View<const Vec4>(from.position),
                 particles_.position.current.view(), kind);
    write_worlds(device_, "worlds/velocities", worlds, View<const Vec4>(from.velocity),
                 particles_.velocity.current.view(), kind);
    write_worlds(device_, "worlds/phases", worlds, from.phase, particles_.phase.current.view(), kind);
    write_worlds(device_, "worlds/numbers", worlds, from.number, particles_.number.current.view(), kind);
  }

  D& device_;
  Particles& particles_;
  Buffer<Vec4> position_{device_, "kept positions"}, velocity_{device_, "kept velocities"};
  Buffer<Phase> phase_{device_, "kept phases"};
  Buffer<uint32_t> slot_{device_, "kept slots"}, number_{device_, "kept numbers"};
};

}  // namespace meniscus::pbd
