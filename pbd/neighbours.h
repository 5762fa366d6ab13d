// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Neighbour lists as constraints read them: through for_each_neighbour alone, so that the form of the list
// can change. What D is says who reads: the CPU with eight lanes (CpuDevice), a thread of the GPU
// (CudaDevice), or four or eight (CudaTeamOf).
#pragma once

#include <type_traits>

#include "pbd/device/cuda/team.h"
#include "pbd/device/scalar.h"
#include "pbd/device/view.h"

namespace meniscus::pbd {

/// Where entry k of particle i's list stands in an interleaved list.
MENISCUS_HD inline size_t interleaved_place(uint32_t stride, uint32_t i, uint32_t k) {
  return (size_t{k / 4} * stride + i) * 4 + k % 4;
}

/// One list a particle, padded with a sentinel to a multiple of eight. On the CPU each particle has a row of
/// its own. On the GPU groups of four lie interleaved over the particles, so that a warp's loads of sixteen
/// bytes coalesce.
struct NeighbourView {
  View<uint32_t> index;
  View<const uint32_t> count;
  uint32_t row_capacity = 0;  ///< entries a particle, a multiple of eight
  uint32_t stride = 0;        ///< particles a group row; 0 where each has a row of its own

  /// Entry k of particle i's list; the sentinel takes a neighbour out of it.
  MENISCUS_HD uint32_t& entry(uint32_t i, uint32_t k) const {
    return index.data[stride ? interleaved_place(stride, i, k) : size_t{i} * row_capacity + k];
  }
};

struct alignas(16) IndexGroup {
  uint32_t a, b, c, d;
};

/// Rows are apart, so that no processor guesses which part of them is read: unasked, half of a loop over
/// neighbours is spent waiting for the list.
inline constexpr size_t rows_ahead = 8;

inline void prefetch_row(const uint32_t* row, uint32_t count) {
  constexpr uint32_t line = 16;
  for (uint32_t k = 0; k < count; k += line) __builtin_prefetch(row + k);
}

/// Calls visit(j) for each neighbour of i within the list's reach, in an order that is the same every time. j
/// is one index, or eight where D has eight lanes; it goes to gather(). i itself is not among them.
template <class D, class Visit>
MENISCUS_HD void for_each_neighbour(const NeighbourView& list, uint32_t i, const Visit& visit) {
  const uint32_t count = list.count[i];
  if constexpr (D::lane_count == 1) {
    // The next group is on its way while this one's neighbours are.
    const IndexGroup* group = reinterpret_cast<const IndexGroup*>(list.index.data) + i;
    IndexGroup j = count ? *group : IndexGroup{};
    for (uint32_t k = 0; k < count; k += 4) {
      group += list.stride;
      const IndexGroup next = k + 4 < count ? *group : j;
      visit(j.a);
      visit(j.b);
      visit(j.c);
      visit(j.d);
      j = next;
    }
  } else if constexpr (is_cuda_team<D>) {
    // Of eight entries each thread takes as many, one after the other.
    constexpr uint32_t each = 8 / D::lane_count;
    struct alignas(4 * each) Part {
      uint32_t at[each];
    };
    const auto part = [&](uint32_t k) {
      const size_t place = interleaved_place(list.stride, i, k + each * D::rank());
      return *reinterpret_cast<const Part*>(list.index.data + place);
    };
    Part j = count ? part(0) : Part{};
    for (uint32_t k = 0; k < count; k += 8) {
      const Part next = k + 8 < count ? part(k + 8) : j;
      MENISCUS_UNROLL
      for (uint32_t n = 0; n < each; ++n) visit(typename D::Index{j.at[n]});
      j = next;
    }
  } else {
    const uint32_t* row = list.index.data + size_t{i} * list.row_capacity;
    prefetch_row(row + rows_ahead * size_t{list.row_capacity}, count);
    for (uint32_t k = 0; k < count; k += D::lane_count) visit(typename D::LaneIndex{row + k});
  }
}

/// Writes the list of one particle while it is built. Form::add(j) stores one, if it fits.
template <class Form>
class ListBuilder {
 public:
  /// Adds first + k for each bit k of `chosen`. All are counted; those that fit are stored.
  MENISCUS_HD void append(uint32_t first, uint32_t chosen) {
    for (; chosen; chosen &= chosen - 1) form().add(first + lowest_bit(chosen));
  }

  /// Fills up with `sentinel` to a multiple of eight; returns the number found, which may be more than
  /// fitted.
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

/// To a row of its own.
class RowWriter : public ListBuilder<RowWriter> {
 public:
  MENISCUS_HD RowWriter(uint32_t* index, uint32_t row_capacity, uint32_t /*stride*/, uint32_t i)
      : row_(index + size_t{i} * row_capacity), capacity_(row_capacity) {}

  MENISCUS_HD void add(uint32_t j) {
    if (count_ < capacity_) row_[count_] = j;
    ++count_;
  }

 private:
  uint32_t* row_;
  uint32_t capacity_;
};

/// To an interleaved list, a group of four at a time.
class GroupWriter : public ListBuilder<GroupWriter> {
 public:
  MENISCUS_HD GroupWriter(uint32_t* index, uint32_t row_capacity, uint32_t stride, uint32_t i)
      : at_(reinterpret_cast<IndexGroup*>(index) + i), capacity_(row_capacity), stride_(stride) {}

  MENISCUS_HD void add(uint32_t j) {
    group_ = {group_.b, group_.c, group_.d, j};
    if (++count_ % 4 || count_ > capacity_) return;
    *at_ = group_;
    at_ += stride_;
  }

 private:
  IndexGroup* at_;
  uint32_t capacity_, stride_;
  IndexGroup group_{};
};

template <class D>
using ListWriter = std::conditional_t<D::interleaves_lists, GroupWriter, RowWriter>;

/// To an interleaved list, by a team: append() takes what each of its threads has found, one after the other.
class TeamWriter {
 public:
  MENISCUS_HD TeamWriter(uint32_t* index, uint32_t row_capacity, uint32_t stride, uint32_t i)
      : index_(index), capacity_(row_capacity), stride_(stride), i_(i) {}

  MENISCUS_HD void append(uint32_t first, uint32_t chosen) {
    const TeamPlace place = place_in_team(bit_count(chosen));
    uint32_t k = count_ + place.before;
    for (; chosen; chosen &= chosen - 1) write(k++, first + lowest_bit(chosen));
    count_ += place.total;
  }
  MENISCUS_HD uint32_t finish(uint32_t sentinel) {
    const uint32_t k = count_ + CudaTeam::rank();
    if (k < (count_ + 7) / 8 * 8) write(k, sentinel);
    return count_;
  }

 private:
  MENISCUS_HD void write(uint32_t k, uint32_t j) {
    if (k < capacity_) index_[interleaved_place(stride_, i_, k)] = j;
  }

  uint32_t* index_;
  uint32_t capacity_, stride_, i_;
  uint32_t count_ = 0;
};

}  // namespace meniscus::pbd
