// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Removes fluid particles. The others are compacted, in memory and in the user's order.
#pragma once

#include "pbd/gather.h"
#include "pbd/particles.h"

namespace meniscus::pbd {

namespace removal_kernels {

struct ScatterOrder {
  View<const uint32_t> keep, offset;
  View<uint32_t> order;

  MENISCUS_HD void operator()(uint32_t i) const {
    if (keep[i]) order[offset[i]] = i;
  }
};

struct SpreadBySlot {
  View<const uint32_t> by_index, slot;
  View<uint32_t> by_slot;

  MENISCUS_HD void operator()(uint32_t i) const {
    if (!is_vertex_slot(slot[i])) by_slot[slot[i]] = by_index[i];
  }
};

struct PickBySlot {
  View<const uint32_t> by_slot, slot;
  View<uint32_t> by_index;

  MENISCUS_HD void operator()(uint32_t i) const {
    by_index[i] = is_vertex_slot(slot[i]) ? 1 : by_slot[slot[i]];
  }
};

/// Where `gone` has the slots that are removed everywhere, ascending.
struct CloseUp {
  View<const uint32_t> gone;
  View<uint32_t> slot;

  MENISCUS_HD void operator()(uint32_t i) const {
    uint32_t first = 0, end = gone.count;  // of those that are not below slot[i]
    while (first < end) {
      const uint32_t middle = first + (end - first) / 2;
      gone[middle] < slot[i] ? first = middle + 1 : end = middle;
    }
    slot[i] -= first;
  }
};

struct Renumber {
  View<const uint32_t> new_slot;
  View<uint32_t> slot;

  MENISCUS_HD void operator()(uint32_t i) const {
    if (!is_vertex_slot(slot[i])) slot[i] = new_slot[slot[i]];
  }
};

}  // namespace removal_kernels

template <class D>
class Removal {
 public:
  explicit Removal(D& device) : device_(device) {}

  /// Sets the maximum number of particles. Most worlds never remove any: memory is allocated at the first
  /// removal.
  void reserve(uint32_t capacity) { capacity_ = capacity; }

  /// By index: 1 for particles that stay, as vertices always do, else 0. Fill it before apply().
  View<uint32_t> keep() {
    allocate();
    return keep_.view();
  }

  /// Fills keep() from an array by slot.
  void keep_by_slot(Particles& particles, std::span<const uint32_t> keep) {
    allocate();
    keep_by_slot_.write(keep);
    device_.parallel_for(
        "removal/pick", particles.count(),
        removal_kernels::PickBySlot{keep_by_slot_.view(), particles.slot.current.view(), keep_.view()});
  }

  /// The number of fluid particles that stay.
  uint32_t count_kept(const Particles& particles) {
    const uint32_t n = particles.count();
    device_.exclusive_scan("removal/offsets", View<const uint32_t>(keep_.view().first(n)), offset_.view());
    uint32_t kept = 0;
    offset_.read(std::span(&kept, 1), n);
    return kept - particles.vertices();
  }

  /// Removes the other particles, after count_kept. Calls reorder(order, count) for arrays that are stored
  /// elsewhere. Writes keep() by slot, as it was before, to `by_slot`.
  template <class Reorder>
  void apply(Particles& particles, uint32_t kept, std::span<uint32_t> by_slot, const Reorder& reorder) {
    const uint32_t n = particles.count(), fluid = particles.sorted();
    using namespace removal_kernels;
    View<uint32_t> slot = particles.slot.current.view();
    device_.parallel_for("removal/slots", n, SpreadBySlot{keep_.view(), slot, keep_by_slot_.view()});
    device_.exclusive_scan("removal/slot offsets", View<const uint32_t>(keep_by_slot_.view().first(fluid)),
                           slot_offset_.view());
    device_.parallel_for("removal/renumber", n, Renumber{slot_offset_.view(), slot});
    compact(particles, kept, reorder);
    keep_by_slot_.read(by_slot.first(fluid));
  }

  /// The same for the particles of one rank. `gone`: the slots that are removed on all ranks, ascending.
  template <class Reorder>
  void apply_among_ranks(Particles& particles, uint32_t kept, std::span<const uint32_t> gone,
                         const Reorder& reorder) {
    Buffer<uint32_t> all(device_, "removed slots");
    all.resize_discard(gone.size());
    all.write(gone);
    device_.parallel_for("removal/close up", particles.sorted(),
                         removal_kernels::CloseUp{all.view(), particles.slot.current.view()});
    if (kept < particles.sorted()) compact(particles, kept, reorder);
  }

 private:
  template <class Reorder>
  void compact(Particles& particles, uint32_t kept, const Reorder& reorder) {
    const uint32_t n = particles.count(), stay = kept + particles.vertices();
    device_.parallel_for("removal/order", n,
                         removal_kernels::ScatterOrder{keep_.view(), offset_.view(), order_.view()});
    const View<const uint32_t> order = order_.view();
    gather_in_order(device_, "removal/positions", particles.position, order, stay);
    gather_in_order(device_, "removal/velocities", particles.velocity, order, stay);
    gather_in_order(device_, "removal/phases", particles.phase, order, stay);
    gather_in_order(device_, "removal/slots", particles.slot, order, stay);
    gather_in_order(device_, "removal/numbers", particles.number, order, stay);
    reorder(order, kept);
    particles.set_sorted(kept);
  }

  void allocate() {
    for (Buffer<uint32_t>* b : {&keep_, &keep_by_slot_, &order_}) b->resize_discard(capacity_);
    offset_.resize_discard(capacity_ + 1);
    slot_offset_.resize_discard(capacity_ + 1);
  }

  D& device_;
  uint32_t capacity_ = 0;
  Buffer<uint32_t> keep_{device_, "kept particles"};
  Buffer<uint32_t> keep_by_slot_{device_, "kept slots"};
  Buffer<uint32_t> offset_{device_, "kept offsets"};
  Buffer<uint32_t> slot_offset_{device_, "kept slot offsets"};
  Buffer<uint32_t> order_{device_, "kept order"};
};

}  // namespace meniscus::pbd
