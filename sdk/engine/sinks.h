// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Marks and counts the particles that sinks take.
#pragma once

#include <algorithm>

#include "pbd/device/base/atomics.h"
#include "pbd/removal.h"
#include "sdk/engine/engine.h"

namespace meniscus {

namespace sink_kernels {

using pbd::View;

MENISCUS_HD inline bool takes(const Sink& sink, Vec3 p) {
  const Vec3 q = to_local(sink.pose, p);
  bool holds = false;
  switch (sink.kind) {
    case Sink::Kind::box:
      holds = inside(sink.box, q);
      break;
    case Sink::Kind::ball:
      holds = dot(q, q) <= sink.size * sink.size;
      break;
    case Sink::Kind::half_space:
      holds = dot(sink.normal, q) < sink.size;
      break;
  }
  return holds != sink.outside;
}

/// The first sink that takes a particle at p, or the number of sinks.
MENISCUS_HD inline uint32_t taker(View<const Sink> sinks, Vec3 p) {
  uint32_t k = 0;
  while (k < sinks.count && !takes(sinks[k], p)) ++k;
  return k;
}

struct Mark {
  View<const pbd::Vec4> position;
  View<const Sink> sinks;
  View<const pbd::Phase> phase;
  View<uint32_t> keep;
  uint32_t sorted;

  MENISCUS_HD void operator()(uint32_t i) const {
    keep[i] = i >= sorted || (phase[i] & pbd::phase_piston) || taker(sinks, position[i].xyz()) == sinks.count;
  }
};

struct Count {
  View<const pbd::Vec4> position;
  View<const Sink> sinks;
  View<const uint32_t> keep, slot;  ///< without slots takers are noted by place
  View<uint32_t> taken, by_slot;

  MENISCUS_HD void operator()(uint32_t i) const {
    if (keep[i]) return;
    const uint32_t by = taker(sinks, position[i].xyz());
    pbd::atomic_add(taken[by], 1);
    by_slot[slot.count ? slot[i] : i] = by;
  }
};

}  // namespace sink_kernels

/// Marks the particles that the sinks take, counts them, and notes by slot, or by place where no slots are
/// given, which sink takes each.
template <class D>
class Sinks {
  template <class T>
  using View = pbd::View<T>;

 public:
  explicit Sinks(D& device) : device_(device) {}

  void set(std::span<const Sink> sinks) {
    sinks_.resize_discard(sinks.size());
    taken_.resize_discard(sinks.size());
    sinks_.write(sinks);
  }

  bool empty() const { return sinks_.size() == 0; }
  size_t count() const { return sinks_.size(); }

  /// Fills removal.keep(); returns how many fluid particles remain. If some are removed, taken[k] is the
  /// count of sink k.
  uint32_t mark(pbd::Particles& particles, pbd::Removal<D>& removal, std::span<uint32_t> taken,
                View<const uint32_t> slots) {
    const View<const pbd::Vec4> position = particles.position.current.view();
    device_.parallel_for("sinks/mark", particles.count(),
                         sink_kernels::Mark{position, sinks_.view(), particles.phase.current.view(),
                                            removal.keep(), particles.sorted()});
    const uint32_t kept = removal.count_kept(particles);
    if (kept == particles.sorted()) return kept;
    taken_.fill(0);
    if (by_slot_.size() < particles.sorted())
      by_slot_.resize_discard(std::max<size_t>(particles.sorted(), 2 * by_slot_.size()));
    device_.parallel_for(
        "sinks/count", particles.sorted(),
        sink_kernels::Count{position, sinks_.view(), removal.keep(), slots, taken_.view(), by_slot_.view()});
    taken_.read(taken);
    return kept;
  }

  /// The number of the sink that takes each particle, after mark() has found some.
  void read_takers(uint32_t count, std::vector<uint32_t>& takers) const {
    takers.resize(count);
    by_slot_.read(std::span(takers));
  }

 private:
  D& device_;
  pbd::Buffer<Sink> sinks_{device_, "sinks"};
  pbd::Buffer<uint32_t> taken_{device_, "particles by sink"};
  pbd::Buffer<uint32_t> by_slot_{device_, "sinks by particle"};  // of those that are taken alone
};

}  // namespace meniscus
