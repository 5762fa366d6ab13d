// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The particles of a world, as arrays in a device's memory. They are kept sorted by grid cell, so that
// neighbours in space are neighbours in memory; `slot` says which element of the user's arrays each one is.
#pragma once

#include <algorithm>

#include "pbd/device/buffer.h"
#include "pbd/math/vec.h"

namespace meniscus::pbd {

/// Group in the low half, flags in the high half.
using Phase = uint32_t;
inline constexpr Phase phase_group_mask = 0xffff;
inline constexpr Phase phase_fluid = 1u << 16;

MENISCUS_HD constexpr uint32_t phase_group(Phase phase) {
  return phase & phase_group_mask;
}

/// What kernels see. Loops run over [0, owned) and may read [0, owned + ghosts).
struct ParticleView {
  View<Vec4> position;        ///< m; w: inverse mass, 1/kg, 0 for what nothing moves
  View<const Vec4> previous;  ///< m, at the substep's start
  View<Vec4> moved;     ///< m, by constraints in this substep: kept beside the position, which rounds it
  View<Vec4> velocity;  ///< m/s
  View<const Phase> phase;
  View<const uint32_t> slot;
  uint32_t owned = 0;
  uint32_t ghosts = 0;
};

/// Two arrays of which one is current: a reordering reads one and writes the other.
template <class T>
struct DoubleBuffer {
  Buffer<T> current, next;

  DoubleBuffer(Device& device, const char* what) : current(device, what), next(device, what) {}
  void flip() { current.swap(next); }
  void reserve(uint32_t size, uint32_t kept) {
    current.resize_keep(size, kept);
    next.resize_discard(size);
  }
};

class Particles {
  Device& device_;  // before the arrays, which are made on it

 public:
  /// A neighbour row is filled up with the index of a particle that is too far away to count. Room beyond it
  /// lets a loop read eight at a time.
  static constexpr uint32_t padding = 16;
  static constexpr float far_away = 1e15f;

  explicit Particles(Device& device) : device_(device) {}

  uint32_t count() const { return count_; }
  uint32_t capacity() const { return capacity_; }
  uint32_t sentinel() const { return capacity_; }

  /// Room for `capacity` particles; those that are there stay.
  void reserve(uint32_t capacity) {
    const uint32_t size = capacity + padding;
    position.reserve(size, count_);
    velocity.reserve(size, count_);
    previous.resize_discard(size);
    moved.resize_discard(size);
    predicted.resize_discard(size);
    phase.reserve(size, count_);
    slot.reserve(size, count_);
    aside_position_.resize_discard(size);
    aside_velocity_.resize_discard(size);
    aside_phase_.resize_discard(size);
    aside_slot_.resize_discard(size);
    capacity_ = capacity;
    write_sentinels();
  }

  void append(std::span<const Vec4> new_position, std::span<const Vec4> new_velocity,
              std::span<const Phase> new_phase, std::span<const uint32_t> new_slot) {
    position.current.write(new_position, count_);
    velocity.current.write(new_velocity, count_);
    phase.current.write(new_phase, count_);
    slot.current.write(new_slot, count_);
    count_ += static_cast<uint32_t>(new_position.size());
  }

  void set_count(uint32_t count) { count_ = count; }

  /// Puts the present state aside; where it then is, the next sort takes it from (see source()). Costs
  /// nothing.
  void put_aside() {
    swap_with_aside();
    aside_count_ = count_;
    from_aside_ = true;
  }
  /// Makes the state put aside the present one again.
  void take_back() {
    swap_with_aside();
    count_ = aside_count_;
    from_aside_ = false;
  }
  /// The state that is to be predicted, and sorted into the next buffers.
  ParticleView source() {
    if (!from_aside_) return view();
    return {aside_position_.view(), previous.view(),    moved.view(), aside_velocity_.view(),
            aside_phase_.view(),    aside_slot_.view(), count_};
  }
  /// What was sorted into the next buffers is the present state.
  void flip() {
    position.flip();
    velocity.flip();
    phase.flip();
    slot.flip();
    from_aside_ = false;
  }

  ParticleView view() {
    return {position.current.view(), previous.view(),     moved.view(), velocity.current.view(),
            phase.current.view(),    slot.current.view(), count_};
  }

  DoubleBuffer<Vec4> position{device_, "particle positions"};
  Buffer<Vec4> previous{device_, "previous positions"};
  Buffer<Vec4> moved{device_, "constraint displacements"};
  Buffer<Vec4> predicted{device_, "predicted positions"};  ///< in the order before the sort
  DoubleBuffer<Vec4> velocity{device_, "particle velocities"};
  DoubleBuffer<Phase> phase{device_, "particle phases"};
  DoubleBuffer<uint32_t> slot{device_, "particle slots"};

 private:
  void write_sentinels() {
    const Vec4 away[] = {{far_away, far_away, far_away, 0}};
    const Vec4 still[] = {{0, 0, 0, 0}};
    for (Buffer<Vec4>* b : {&position.current, &position.next, &previous, &aside_position_})
      b->write(away, sentinel());
    for (Buffer<Vec4>* b : {&velocity.current, &velocity.next, &aside_velocity_}) b->write(still, sentinel());
    const Phase none[] = {0};
    phase.current.write(none, sentinel());
    phase.next.write(none, sentinel());
    aside_phase_.write(none, sentinel());
  }

  void swap_with_aside() {
    position.current.swap(aside_position_);
    velocity.current.swap(aside_velocity_);
    phase.current.swap(aside_phase_);
    slot.current.swap(aside_slot_);
  }

  Buffer<Vec4> aside_position_{device_, "positions put aside"};
  Buffer<Vec4> aside_velocity_{device_, "velocities put aside"};
  Buffer<Phase> aside_phase_{device_, "phases put aside"};
  Buffer<uint32_t> aside_slot_{device_, "slots put aside"};
  uint32_t count_ = 0;
  uint32_t aside_count_ = 0;
  uint32_t capacity_ = 0;
  bool from_aside_ = false;
};

}  // namespace meniscus::pbd
