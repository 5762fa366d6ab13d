// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Writers of a particle's neighbour list, one for each of the forms that neighbours.h reads.
#pragma once

#include "pbd/device/cuda/own_row.h"
#include "pbd/neighbours.h"

namespace meniscus::pbd {

/// Form::add(j) stores one index, if there is room.
template <class Form>
class ListBuilder {
 public:
  /// Adds first + k for each bit k of `chosen`. All are counted; those for which there is room are stored.
  MENISCUS_HD void append(uint32_t first, uint32_t chosen) {
    for (; chosen; chosen &= chosen - 1) form().add(first + lowest_bit(chosen));
  }

  /// Pads with `sentinel` to a multiple of eight. Returns the number found, which may exceed the capacity.
  MENISCUS_HD uint32_t finish(uint32_t sentinel) {
    const uint32_t found = count_;
    while (count_ % 8) form().add(sentinel);
    return found;
  }

 protected:
  uint32_t count_ = 0;

 private:
  MENISCUS_HD Form& form() { return static_cast<Form&>(*this); }
};

/// Writes a list in a row of its own.
class RowWriter : public ListBuilder<RowWriter> {
 public:
  MENISCUS_HD RowWriter(const NeighbourView& list, uint32_t i)
      : row_(list.index.data + size_t{i} * list.row_capacity), capacity_(list.row_capacity) {}

  MENISCUS_HD void add(uint32_t j) {
    if (count_ < capacity_) row_[count_] = j;
    ++count_;
  }

 private:
  uint32_t* row_;
  uint32_t capacity_;
};

/// Writes a wide list, a group at a time.
class WideWriter : public ListBuilder<WideWriter> {
 public:
  MENISCUS_HD WideWriter(const NeighbourView& list, uint32_t i)
      : at_(reinterpret_cast<IndexGroup*>(list.index.data) + i),
        capacity_(list.row_capacity),
        stride_(list.stride) {}

  MENISCUS_HD void add(uint32_t j, uint32_t k = 0) {
    group_ = {group_.b, group_.c, group_.d, j + k};
    if (++count_ % 4 || count_ > capacity_) return;
    *at_ = group_;
    at_ += stride_;
  }
  // The interface of NarrowWriter, for code that is a template over both.
  MENISCUS_HD static bool has_room_for(uint32_t) { return true; }
  MENISCUS_HD void add_in_room(uint32_t j, uint32_t k) { add(j, k); }

 private:
  IndexGroup* at_;
  uint32_t capacity_, stride_;
  IndexGroup group_{};
};

/// Writes a narrow list. A thread collects the offsets in shared memory first. The threads of a warp find
/// their neighbours at different times, and each would wait for the others to write a group.
class NarrowWriter {
 public:
  static constexpr uint32_t most = 64;  ///< entries

  MENISCUS_HD NarrowWriter(const NeighbourView& list, uint32_t i)
      : list_(list), i_(i), place_(row_.first()), end_(place_ + list.row_capacity * Row::step) {}

  /// Adds j + k.
  MENISCUS_HD void add(uint32_t j, uint32_t k = 0) {
    if (place_ < end_) row_.put(place_, j - i_ + k);
    place_ += Row::step;
  }

  /// Whether so many more entries fit.
  MENISCUS_HD bool has_room_for(uint32_t more) const {
    return place_ + more * Row::step <= row_.first() + most * Row::step;
  }
  /// Adds j + k without a check; see has_room_for().
  MENISCUS_HD void add_in_room(uint32_t j, uint32_t k = 0) {
    row_.put(place_, j - i_ + k);
    place_ += Row::step;
  }

  MENISCUS_HD uint32_t finish() {
    const uint32_t found = (place_ - row_.first()) / Row::step;
    const uint32_t stored = found < list_.row_capacity ? found : list_.row_capacity;
    const auto both = [&](uint32_t k) {
      const auto one = [&](uint32_t n) { return n < stored ? row_.at(row_.first() + n * Row::step) : 0; };
      return one(k) | one(k + 1) << 16;
    };
    IndexGroup* group = reinterpret_cast<IndexGroup*>(list_.index.data) + i_;
    for (uint32_t k = 0; k < stored; k += 8, group += list_.stride)
      *group = {both(k), both(k + 2), both(k + 4), both(k + 6)};
    return found;
  }

 private:
  using Row = OwnRow<most>;

  const NeighbourView& list_;
  uint32_t i_;
  Row row_;
  uint32_t place_, end_;
};

/// Appends to a list that is complete. A narrow list becomes wide, because what is appended may be far away.
class ListExtension {
 public:
  MENISCUS_HD ListExtension(const NeighbourView& list, uint32_t i)
      : list_(list), i_(i), count_(list.size(i)) {
    if (list.is_narrow(i)) widen();
  }

  MENISCUS_HD void add(uint32_t j) {
    if (count_ < list_.row_capacity) list_.entry(i_, count_) = j;
    ++count_;
  }

  /// Pads the list. Returns the number of its entries, which may exceed the capacity.
  MENISCUS_HD uint32_t finish() {
    const uint32_t found = count_;
    while (count_ % 8) add(list_.sentinel);
    list_.count[i_] = found < list_.row_capacity ? found : list_.row_capacity;
    return found;
  }

 private:
  /// Eight entries at a time, from the last ones on: wide ones take twice the room, further on.
  MENISCUS_HD void widen() {
    for (uint32_t end = (count_ + 7) / 8 * 8; end > 0; end -= 8) {
      uint32_t index[8];
      for (uint32_t k = 0; k < 8; ++k) index[k] = list_.index_at(i_, list_.offset(i_, end - 8 + k));
      for (uint32_t k = 0; k < 8; ++k) list_.entry(i_, end - 8 + k) = index[k];
    }
  }

  const NeighbourView& list_;
  uint32_t i_, count_;
};

/// Writes a wide list, by a team. append() takes an index from each thread that found one, in the order of
/// the threads.
class TeamWriter {
 public:
  MENISCUS_HD TeamWriter(const NeighbourView& list, uint32_t i) : list_(list), i_(i) {}

  MENISCUS_HD void append(uint32_t j, bool found) {
    const uint32_t votes = votes_of_team(found);
    if (found) write(count_ + bit_count(votes & ((1u << CudaTeam::rank()) - 1)), j);
    count_ += bit_count(votes);
  }
  MENISCUS_HD uint32_t finish(uint32_t sentinel) {
    const uint32_t k = count_ + CudaTeam::rank();
    if (k < (count_ + 7) / 8 * 8) write(k, sentinel);
    return count_;
  }

 private:
  MENISCUS_HD void write(uint32_t k, uint32_t j) {
    if (k < list_.row_capacity) list_.entry(i_, k) = j;
  }

  const NeighbourView& list_;
  uint32_t i_;
  uint32_t count_ = 0;
};

}  // namespace meniscus::pbd
