// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How particles and the values of ghosts go from rank to rank.
#pragma once

#include <algorithm>
#include <bit>
#include <numeric>

#include "pbd/device/access.h"
#include "pbd/rank_exchange.h"
#include "pbd/rank_exchange_kernels.h"

namespace meniscus::pbd {

template <class D>
RankExchange<D>::RankExchange(D& device, Ranks& ranks, bool layers_along_y)
    : device_(device), ranks_(ranks), layers_along_y_(layers_along_y) {}

template <class D>
void RankExchange<D>::reserve(uint32_t capacity) {
  capacity_ = capacity;
  counts_.resize_discard(capacity);
  start_.resize_discard(capacity + 1);
}

// ---- particles ----

template <class D>
template <class Tags>
std::vector<uint32_t> RankExchange<D>::select(uint32_t count, const Tags& tags, uint32_t kinds,
                                              Buffer<uint32_t>& list, uint32_t row_bits) {
  using namespace rank_kernels;
  if (count == 0) return std::vector<uint32_t>(kinds);
  make_room(counts_, count);
  make_room(start_, size_t{count} + 1);
  device_.parallel_for("ranks/count", count, CountTags<Tags>{tags, counts_.view()});
  device_.exclusive_scan("ranks/offsets", View<const uint32_t>{counts_.view().data, count}, start_.view());
  uint32_t total = 0;
  device_.copy_out(&total, start_.view().data + count, sizeof total);
  if (total == 0) return std::vector<uint32_t>(kinds);
  for (Buffer<uint32_t>* buffer : {&tag_, &sorted_tag_, &index_, &list}) make_room(*buffer, total);
  make_room(ends_, kinds);
  const View<uint32_t> tag = tag_.view().first(total), sorted = sorted_tag_.view().first(total),
                       index = index_.view().first(total);
  device_.parallel_for("ranks/select", count, PlaceTags<Tags>{tags, start_.view(), tag, index});
  device_.sort_pairs("ranks/sort", tag, sorted, index, list.view().first(total),
                     row_bits + static_cast<uint32_t>(std::bit_width(kinds - 1)));
  device_.parallel_for("ranks/ends", kinds, EndsOfTags{sorted, row_bits, ends_.view()});
  std::vector<uint32_t> numbers = ends_.read(kinds);
  std::adjacent_difference(numbers.begin(), numbers.end(), numbers.begin());
  return numbers;
}

template <class D>
template <class Points>
uint32_t RankExchange<D>::send(const Points& points, const GridView& grid, uint32_t count,
                               const std::vector<WordArray>& arrays) {
  const rank_kernels::Destinations<Points> destinations{points,
                                                        grid,
                                                        cuts_on_device(),
                                                        region(),
                                                        static_cast<uint32_t>(ranks_.rank()),
                                                        cuts_.any_along(true) ? 1 : 0,
                                                        cuts_.any_along(false) ? 1 : 0};
  const uint32_t arriving = choose_leaving(count, destinations);
  if (is_on_any(ranks_, count + arriving > capacity_)) throw LacksRoom{count + arriving};
  send_leaving(arrays);
  take_over(count, arrays);
  return count + arriving;
}

template <class D>
template <class Tags>
uint32_t RankExchange<D>::choose_leaving(uint32_t count, const Tags& tags) {
  to_ = select(count, tags, static_cast<uint32_t>(ranks_.count()), leaving_);
  from_.assign(to_.size(), 0);
  ranks_.transpose(to_, from_);
  return std::accumulate(from_.begin(), from_.end(), 0u);
}

template <class D>
void RankExchange<D>::send_leaving(const std::vector<WordArray>& arrays) {
  using namespace rank_kernels;
  uint32_t words = 0;
  for (const WordArray& a : arrays) words += a.words;
  make_room(out_, std::accumulate(to_.begin(), to_.end(), size_t{0}) * words);
  make_room(in_, std::accumulate(from_.begin(), from_.end(), size_t{0}) * words);
  std::vector<Sent> sent;
  std::vector<Received> received;
  uint32_t* out = out_.view().data;
  const uint32_t* next = leaving_.view().data;
  uint32_t* in = in_.view().data;
  for (size_t r = 0; r < to_.size(); ++r) {
    const size_t sent_words = size_t{to_[r]} * words, received_words = size_t{from_[r]} * words;
    sent.push_back({static_cast<int>(r), out, sent_words * sizeof(uint32_t)});
    received.push_back({static_cast<int>(r), in, received_words * sizeof(uint32_t)});
    for (const WordArray& a : arrays) {
      pack(a, {next, to_[r]}, out);
      out += size_t{to_[r]} * a.words;
    }
    next += to_[r];
    in += received_words;
  }
  exchange(sent, received);
}

template <class D>
void RankExchange<D>::take_over(uint32_t first, const std::vector<WordArray>& arrays) {
  uint32_t place = first;
  const uint32_t* arrived = in_.view().data;
  for (const uint32_t n : from_) {
    for (const WordArray& a : arrays) {
      const size_t size = size_t{n} * a.words;
      if (n) device_.copy(a.data + size_t{place} * a.words, arrived, size * sizeof(uint32_t));
      arrived += size;
    }
    place += n;
  }
}

template <class D>
uint32_t RankExchange<D>::hand_over(const GridView& grid, uint32_t count,
                                    const std::vector<WordArray>& arrays) {
  const uint32_t arriving = choose_leaving(count, rank_kernels::Owners{arrays.front(), grid, cuts_on_device(),
                                                                       static_cast<uint32_t>(ranks_.rank())});
  send_leaving(arrays);
  return arriving;
}

/// Of messages in the device's memory, in the order of its launches.
template <class D>
void RankExchange<D>::exchange(std::span<const Sent> sent, std::span<const Received> received) {
  void* const stream = DeviceAccess<D>::stream(device_);
  stream ? ranks_.exchange_on_gpu(sent, received, stream) : ranks_.exchange(sent, received);
}

template <class D>
void RankExchange<D>::pack(const WordArray& from, View<const uint32_t> list, uint32_t* to) {
  device_.parallel_for("ranks/pack", list.count, rank_kernels::Pack{from, list, to});
}

// ---- ghosts ----

/// Two ranks may have the rows between them in another order. So the lists are sorted by row, unless there
/// are slabs, whose layers have the same rows in memory on both.
template <class D>
void RankExchange<D>::note_sorted(View<const Vec4> position, const GridView& grid, uint32_t owned,
                                  uint32_t ghosts) {
  using namespace rank_kernels;
  const std::vector<int> ranks = cuts_.neighbours(ranks_.rank());
  sides_.clear();
  if (ranks.empty()) return;
  const auto kinds = 2 * static_cast<uint32_t>(ranks.size());
  const uint32_t row_bits = cuts_.are_slabs() ? 0 : 32 - static_cast<uint32_t>(std::bit_width(kinds - 1));
  const View<const NeighbourRank> neighbours{neighbours_.view().data, kinds / 2};
  const std::vector<uint32_t> numbers = select(
      owned + ghosts, Boundaries{position, grid, owned, neighbours, row_bits}, kinds, lists_, row_bits);
  uint32_t next = 0;
  for (uint32_t k = 0; k < ranks.size(); ++k) {
    const uint32_t needed = numbers[2 * k], ghosts_there = numbers[2 * k + 1];
    sides_.push_back({ranks[k], needed, next, ghosts_there, next + needed});
    next += needed + ghosts_there;
  }
}

template <class D>
void RankExchange<D>::refresh(void* values, uint32_t words) {
  using namespace rank_kernels;
  const WordArray array{static_cast<uint32_t*>(values), words};
  size_t needed = 0, ghosts = 0;
  for (const Side& side : sides_) {
    needed += side.needed;
    ghosts += side.ghosts;
  }
  make_room(out_, needed * words);
  make_room(in_, ghosts * words);
  std::vector<Sent> sent;
  std::vector<Received> received;
  uint32_t *out = out_.view().data, *in = in_.view().data;
  const uint32_t* const lists = lists_.view().data;
  for (const Side& side : sides_) {
    const size_t sent_words = size_t{side.needed} * words, received_words = size_t{side.ghosts} * words;
    pack(array, {lists + side.first_needed, side.needed}, out);
    sent.push_back({side.rank, out, sent_words * sizeof(uint32_t)});
    received.push_back({side.rank, in, received_words * sizeof(uint32_t)});
    out += sent_words;
    in += received_words;
  }
  exchange(sent, received);
  in = in_.view().data;
  for (const Side& side : sides_) {
    const View<const uint32_t> list{lists + side.first_ghost, side.ghosts};
    device_.parallel_for("ranks/unpack", list.count, Unpack{in, list, array});
    in += size_t{side.ghosts} * words;
  }
}

// ---- values at corners of cells ----

template <class D>
void RankExchange<D>::share(uint32_t* words, std::span<const size_t> starts) {
  const auto self = static_cast<size_t>(ranks_.rank());
  std::vector<Sent> sent;
  std::vector<Received> received;
  const auto bytes = [&](size_t r) { return (starts[r + 1] - starts[r]) * sizeof(uint32_t); };
  for (size_t r = 0; r + 1 < starts.size(); ++r) {
    if (r == self) continue;
    sent.push_back({static_cast<int>(r), words + starts[self], bytes(self)});
    received.push_back({static_cast<int>(r), words + starts[r], bytes(r)});
  }
  exchange(sent, received);
}

template <class D>
void RankExchange<D>::pass_up(const uint32_t* sent, uint32_t* received, size_t words) {
  const int rank = ranks_.rank();
  const Sent up{rank + 1, sent, words * sizeof(uint32_t)};
  const Received from_below{rank - 1, received, words * sizeof(uint32_t)};
  exchange({&up, rank + 1 < ranks_.count() ? size_t{1} : size_t{0}},
           {&from_below, rank > 0 ? size_t{1} : size_t{0}});
}

}  // namespace meniscus::pbd
