// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The vertices of one world of a batch, to which worlds are reset. Those of all worlds follow one another
// behind all fluids.
#pragma once

#include "pbd/device/buffer.h"
#include "pbd/particles.h"
#include "pbd/worlds.h"

namespace meniscus::pbd {

namespace world_kernels {

/// Phases of a kept world, with the numbers that the pieces of each world have.
struct WritePieces {
  ChosenWorlds worlds;
  View<const Phase> from;
  View<Phase> to;
  uint32_t pieces;  ///< of a world

  MENISCUS_HD void operator()(uint32_t i) const {
    if (worlds.has(i)) to[i] = from[i % worlds.each] + i / worlds.each * pieces;
  }
};

}  // namespace world_kernels

template <class D>
class KeptVertices {
 public:
  KeptVertices(D& device, Particles& particles) : device_(device), particles_(particles) {}

  uint32_t each() const { return static_cast<uint32_t>(phase_.size()); }
  uint32_t pieces() const { return pieces_; }

  /// Keeps all present vertices, of a single world with so many pieces of cloth.
  void keep(uint32_t pieces) {
    const uint32_t first = particles_.sorted(), count = particles_.vertices();
    const auto copy = [&]<class T>(Buffer<T>& to, View<const T> from) {
      to.resize_discard(count);
      if (count > 0) device_.copy(to.view().data, from.data + first, count * sizeof(T));
    };
    const ParticleView p = particles_.view();
    copy(position_, View<const Vec4>(p.position));
    copy(velocity_, View<const Vec4>(p.velocity));
    copy(phase_, p.phase);
    pieces_ = pieces;
  }

  void reset_worlds(View<const uint32_t> chosen) {
    if (each() == 0) return;
    const ChosenWorlds worlds{chosen, each(), particles_.vertices()};
    write_worlds(device_, "worlds/vertices", worlds, View<const Vec4>(position_.view()),
                 of_vertices(particles_.position.current.view()), WorldsFrom::one);
    write_worlds(device_, "worlds/vertex velocities", worlds, View<const Vec4>(velocity_.view()),
                 of_vertices(particles_.velocity.current.view()), WorldsFrom::one);
    device_.parallel_for("worlds/vertex phases", worlds.count,
                         world_kernels::WritePieces{worlds, phase_.view(),
                                                    of_vertices(particles_.phase.current.view()), pieces_});
  }

  /// The state at the last Particles::save().
  void undo_worlds(View<const uint32_t> chosen) {
    if (each() == 0) return;
    const ChosenWorlds worlds{chosen, each(), particles_.vertices()};
    const ParticleView before = particles_.saved();
    write_worlds(device_, "worlds/vertices", worlds, of_vertices(View<const Vec4>(before.position)),
                 of_vertices(particles_.position.current.view()), WorldsFrom::all);
    write_worlds(device_, "worlds/vertex velocities", worlds, of_vertices(View<const Vec4>(before.velocity)),
                 of_vertices(particles_.velocity.current.view()), WorldsFrom::all);
    write_worlds(device_, "worlds/vertex phases", worlds, of_vertices(before.phase),
                 of_vertices(particles_.phase.current.view()), WorldsFrom::all);
  }

 private:
  template <class T>
  View<T> of_vertices(View<T> all) const {
    return all.from(particles_.sorted());
  }

  D& device_;
  Particles& particles_;
  uint32_t pieces_ = 0;
  Buffer<Vec4> position_{device_, "kept positions"}, velocity_{device_, "kept velocities"};
  Buffer<Phase> phase_{device_, "kept phases"};
};

}  // namespace meniscus::pbd
