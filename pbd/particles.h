// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The particles of a world, as arrays in a device's memory. Fluid particles come first, sorted by grid cell,
// so that neighbours in space are neighbours in memory. `slot` is the element of the user's arrays that a
// particle corresponds to. `number` identifies it for its whole life. The vertices of cloth and rods follow
// in a fixed order, so that constraints can refer to them by index.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "pbd/device/buffer.h"
#include "pbd/math/vec.h"
#include "pbd/state/state_visitor.h"

namespace meniscus::pbd {

/// Group in the low half, flags in the high half.
using Phase = uint32_t;
inline constexpr Phase phase_group_mask = 0xffff;
inline constexpr Phase phase_fluid = 1u << 16;
inline constexpr Phase phase_vertex = 1u << 17;  ///< of cloth or rods; the group is the piece
inline constexpr Phase phase_face = 1u
                                    << 18;  ///< a point of a face, there for one substep; with phase_vertex
inline constexpr Phase phase_grain = 1u << 19;  ///< in the place of phase_fluid: a grain of sand or the like
inline constexpr Phase phase_pressing = 1u << 20;  ///< cloth carried it at the end of the last substep
inline constexpr Phase phase_passing = 1u << 21;   ///< it is passing through permeable cloth
inline constexpr Phase phase_overlapping =
    1u << 22;  ///< it may have overlapped a solid when it, or the solid, was created or placed, and has not
               ///< been found outside of all solids since
inline constexpr Phase phase_piston =
    1u << 23;  ///< it is in the duct of an imposed emitter (sdk/engine/pistons.h)

/// The number of steps for which a particle that has just left an emitter's opening keeps its velocity: in
/// the top byte.
inline constexpr uint32_t most_held = 255;

MENISCUS_HD constexpr Phase held_for(uint32_t steps) {
  return steps << 24;
}
MENISCUS_HD constexpr uint32_t held_steps(Phase phase) {
  return phase >> 24;
}

MENISCUS_HD constexpr uint32_t phase_group(Phase phase) {
  return phase & phase_group_mask;
}
MENISCUS_HD constexpr bool is_grain(Phase phase) {
  return (phase & phase_grain) != 0;
}

/// Slots of vertices start here: vertices have numbers of their own.
inline constexpr uint32_t vertex_slot = 1u << 31;

MENISCUS_HD constexpr bool is_vertex_slot(uint32_t slot) {
  return slot >= vertex_slot;
}

/// The particles as kernels see them. Loops run over [0, owned) and may read [0, owned + ghosts).
struct ParticleView {
  View<Vec4> position;        ///< m; w: inverse mass, 1/kg, 0 for fixed particles
  View<const Vec4> previous;  ///< m, at the substep's start
  View<Vec4>
      accumulated_delta;  ///< m, by constraints in this substep, kept separately because the position
                          ///< rounds it; of fixed particles the accumulated positional impulse, kg·m. w: of
                          ///< fluids the inverse mass again, for kernels that do not need the position
  View<Vec4> velocity;    ///< m/s; w: of fluids, the magnitude of the last substep's curl, 1/s, for vorticity
                          ///< confinement
  View<const Phase> phase;
  View<const uint32_t> slot;
  View<const uint32_t> number;  ///< persistent: random choices are hashed from it
  uint32_t owned = 0;
  uint32_t ghosts = 0;
  uint32_t sorted =
      0;  ///< the number of fluid particles, which come first; vertex v is the particle sorted + v

  /// A rank without fluid of its own may still take part in exchanges.
  MENISCUS_HD bool has_fluid() const { return sorted + ghosts > 0; }
};

/// Elements of 32-bit words, of an array whose type does not matter.
struct WordArray {
  uint32_t* data;
  uint32_t words;  ///< of an element
};

/// What the accumulated delta of a particle of inverse mass w gets of a positional impulse: w of it, or all
/// of it where w = 0. A held particle records what it withstands.
MENISCUS_HD inline float recorded_part(float w) {
  return w > 0 ? w : 1.0f;
}
/// The positional impulse that a particle of inverse mass w has recorded as this delta.
MENISCUS_HD inline Vec3 recorded_impulse(float w, Vec3 delta) {
  return w > 0 ? (1 / w) * delta : delta;
}

/// Two arrays of which one is current: a reordering reads that one and writes the other.
template <class T>
struct DoubleBuffer {
  Buffer<T> current, next;

  DoubleBuffer(Device& device, const char* what) : current(device, what), next(device, what) {}
  void flip() { current.swap(next); }
  /// An array that is never reordered needs no `next`.
  void reserve(uint32_t size, uint32_t kept, bool flips = true) {
    current.resize_keep(size, kept);
    next.resize_discard(flips ? size : 0);
  }
};

class Particles {
  Device& device_;  // before the arrays, which are made on it

 public:
  /// Neighbour lists are padded with the index of a particle that is too far away to matter. Room after it
  /// lets a loop read eight at a time.
  static constexpr uint32_t padding = 16;
  static constexpr float far_away = 1e15f;

  explicit Particles(Device& device) : device_(device) {}

  uint32_t count() const { return count_; }
  uint32_t sorted() const { return sorted_; }
  uint32_t vertices() const { return count_ - sorted_; }
  uint32_t capacity() const { return capacity_; }
  uint32_t sentinel() const { return capacity_; }

  /// Makes room for `capacity` particles, and keeps the existing ones. `sorts`: whether any may be of fluids.
  void reserve(uint32_t capacity, bool sorts) {
    const uint32_t size = capacity + padding;
    position.reserve(size, count_, sorts);
    velocity.reserve(size, count_, sorts);
    phase.reserve(size, count_, sorts);
    slot.reserve(size, count_, sorts);
    number.reserve(size, count_, sorts);
    previous.resize_discard(size);
    accumulated_delta.resize_discard(size);
    predicted.resize_discard(size);
    saved_position_.resize_discard(size);
    saved_velocity_.resize_discard(size);
    saved_phase_.resize_discard(size);
    saved_slot_.resize_discard(size);
    saved_number_.resize_discard(size);
    capacity_ = capacity;
    write_sentinels();
  }

  /// The numbers of the next particles.
  std::vector<uint32_t> take_numbers(uint32_t count) {
    std::vector<uint32_t> numbers(count);
    for (uint32_t k = 0; k < count; ++k) numbers[k] = (next_number_ + k) % vertex_slot;
    next_number_ += count;
    return numbers;
  }
  /// Adds fluid particles before the vertices. They get the next numbers, or these.
  void append(std::span<const Vec4> new_position, std::span<const Vec4> new_velocity,
              std::span<const Phase> new_phase, std::span<const uint32_t> new_slot) {
    const auto added = static_cast<uint32_t>(new_position.size());
    append(new_position, new_velocity, new_phase, new_slot, take_numbers(added));
  }
  void append(std::span<const Vec4> new_position, std::span<const Vec4> new_velocity,
              std::span<const Phase> new_phase, std::span<const uint32_t> new_slot,
              std::span<const uint32_t> new_number) {
    const auto added = static_cast<uint32_t>(new_position.size());
    move_vertices(sorted_ + added);
    position.current.write(new_position, sorted_);
    velocity.current.write(new_velocity, sorted_);
    phase.current.write(new_phase, sorted_);
    slot.current.write(new_slot, sorted_);
    number.current.write(new_number, sorted_);
    set_sorted(sorted_ + added);
  }

  /// Replaces all vertices.
  void set_vertices(std::span<const Vec4> new_position, std::span<const Vec4> new_velocity,
                    std::span<const Phase> new_phase) {
    std::vector<uint32_t> new_slot(new_position.size());
    std::iota(new_slot.begin(), new_slot.end(), vertex_slot);
    position.current.write(new_position, sorted_);
    velocity.current.write(new_velocity, sorted_);
    phase.current.write(new_phase, sorted_);
    slot.current.write(new_slot, sorted_);
    number.current.write(new_slot, sorted_);
    count_ = sorted_ + static_cast<uint32_t>(new_position.size());
  }

  /// Sets the number of fluid particles; the number of vertices does not change.
  void set_sorted(uint32_t sorted) {
    count_ = sorted + vertices();
    sorted_ = sorted;
  }

  /// Saves the present state. The next sort reads it from where it then is (see source()). No data are
  /// copied.
  void save() {
    swap_with_saved();
    saved_count_ = count_;
    saved_sorted_ = sorted_;
    from_saved_ = true;
  }
  /// Makes the saved state the present one again.
  void restore() {
    swap_with_saved();
    count_ = saved_count_;
    sorted_ = saved_sorted_;
    from_saved_ = false;
  }
  /// The state to predict from, which is then sorted into target().
  ParticleView source() { return from_saved_ ? saved() : view(); }
  /// The state at the last save(), also after the steps from it.
  ParticleView saved() {
    return {saved_position_.view(),
            previous.view(),
            accumulated_delta.view(),
            saved_velocity_.view(),
            saved_phase_.view(),
            saved_slot_.view(),
            saved_number_.view(),
            count_,
            0,
            sorted_};
  }
  /// The arrays of source(), but for what a substep makes anew.
  std::vector<WordArray> source_arrays() {
    const auto words = [](auto& of_present, auto& saved, bool is_saved) {
      auto view = (is_saved ? saved : of_present.current).view();
      return WordArray{reinterpret_cast<uint32_t*>(view.data), sizeof(*view.data) / sizeof(uint32_t)};
    };
    return {words(position, saved_position_, from_saved_), words(velocity, saved_velocity_, from_saved_),
            words(phase, saved_phase_, from_saved_), words(slot, saved_slot_, from_saved_),
            words(number, saved_number_, from_saved_)};
  }
  /// Call it before velocity.flip() if only the fluids' next velocities were written.
  void keep_vertex_velocities() {
    if (vertices() == 0) return;
    device_.copy(velocity.next.view().data + sorted_, velocity.current.view().data + sorted_,
                 vertices() * sizeof(Vec4));
  }
  /// The next buffers. Without fluids all elements keep their places, so the present buffers.
  template <class T>
  View<T> target(DoubleBuffer<T>& values) {
    return (sorted_ ? values.next : values.current).view();
  }
  /// Makes what was sorted into target() the present state.
  void accept_sorted() {
    from_saved_ = false;
    if (sorted_ == 0) return;
    position.flip();
    velocity.flip();
    phase.flip();
    slot.flip();
    number.flip();
  }

  /// In their present order. The room must be there.
  void visit_state(StateVisitor& v) {
    v.value("count", count_);
    v.value("sorted", sorted_);
    v.value("next_number", next_number_);
    v.array("position", position.current.view(), count_);
    v.array("velocity", velocity.current.view(), count_);
    v.array("phase", phase.current.view(), count_);
    v.array("slot", slot.current.view(), count_);
    v.array("number", number.current.view(), count_);
  }

  ParticleView view() {
    return {position.current.view(),
            previous.view(),
            accumulated_delta.view(),
            velocity.current.view(),
            phase.current.view(),
            slot.current.view(),
            number.current.view(),
            count_,
            0,
            sorted_};
  }

  DoubleBuffer<Vec4> position{device_, "particle positions"};
  Buffer<Vec4> previous{device_, "previous positions"};
  Buffer<Vec4> accumulated_delta{device_, "constraint displacements"};
  Buffer<Vec4> predicted{device_, "predicted positions"};  ///< of motions that may be limited, unsorted
  DoubleBuffer<Vec4> velocity{device_, "particle velocities"};
  DoubleBuffer<Phase> phase{device_, "particle phases"};
  DoubleBuffer<uint32_t> slot{device_, "particle slots"};
  DoubleBuffer<uint32_t> number{device_, "particle numbers"};

 private:
  /// Moves the vertices, so that they begin at `first`.
  void move_vertices(uint32_t first) {
    const uint32_t moving = vertices();
    if (moving == 0 || first == sorted_) return;
    const auto move = [&]<class T>(DoubleBuffer<T>& values) {
      device_.copy(values.next.view().data, values.current.view().data + sorted_, moving * sizeof(T));
      device_.copy(values.current.view().data + first, values.next.view().data, moving * sizeof(T));
    };
    move(position);
    move(velocity);
    move(phase);
    move(slot);
    move(number);
  }
  void write_sentinels() {
    const Vec4 away[] = {{far_away, far_away, far_away, 0}};
    const Vec4 still[] = {{0, 0, 0, 0}};
    const Phase none[] = {0};
    for (Buffer<Vec4>* b : {&position.current, &position.next, &previous, &predicted, &saved_position_})
      if (b->size()) b->write(away, sentinel());
    for (Buffer<Vec4>* b : {&velocity.current, &velocity.next, &saved_velocity_})
      if (b->size()) b->write(still, sentinel());
    for (Buffer<Phase>* b : {&phase.current, &phase.next, &saved_phase_})
      if (b->size()) b->write(none, sentinel());
  }

  void swap_with_saved() {
    position.current.swap(saved_position_);
    velocity.current.swap(saved_velocity_);
    phase.current.swap(saved_phase_);
    slot.current.swap(saved_slot_);
    number.current.swap(saved_number_);
  }

  Buffer<Vec4> saved_position_{device_, "saved positions"};
  Buffer<Vec4> saved_velocity_{device_, "saved velocities"};
  Buffer<Phase> saved_phase_{device_, "saved phases"};
  Buffer<uint32_t> saved_slot_{device_, "saved slots"};
  Buffer<uint32_t> saved_number_{device_, "saved numbers"};
  uint32_t count_ = 0, sorted_ = 0;
  uint32_t saved_count_ = 0, saved_sorted_ = 0;
  uint32_t capacity_ = 0;
  uint32_t next_number_ = 0;  // wraps below vertex_slot, where the numbers of vertices begin
  bool from_saved_ = false;
};

}  // namespace meniscus::pbd
