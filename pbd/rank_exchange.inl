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

namespace rank_kernels {

/// Makes room, and a quarter more, since the next message may be longer.
template <class T>
void make_room(Buffer<T>& buffer, size_t size) {
  if (size > buffer.size()) buffer.resize_discard(size + size / 4 + 64);
}

}  // namespace rank_kernels

template <class D>
RankExchange<D>::RankExchange(D& device, Ranks& ranks, bool layers_along_y)
    : device_(device), ranks_(ranks), layers_along_y_(layers_along_y) {
  if (ranks.rank() > 0) sides_.push_back({ranks.rank() - 1, {}, {}});
  if (ranks.rank() + 1 < ranks.count()) sides_.push_back({ranks.rank() + 1, {}, {}});
}

template <class D>
void RankExchange<D>::reserve(uint32_t capacity) {
  capacity_ = capacity;
  counts_.resize_discard(capacity);
  start_.resize_discard(capacity + 1);
}

// ---- where the cuts are ----

template <class D>
typename RankExchange<D>::Histogram RankExchange<D>::count_layers(const ParticleView& particles,
                                                                  const GridView& grid, const Aabb& extent) {
  GridView shape = grid;
  shape.layers_along_y = layers_along_y_;
  const auto layer_of = [&](Vec3 p) { return shape.layer(shape.coordinates(p)); };
  const int32_t first = layer_of(extent.lower),
                layers = std::min(layer_of(extent.upper) - first + 1, rank_kernels::most_layers);
  const auto count = static_cast<uint32_t>(std::max(layers, 1));
  rank_kernels::make_room(histogram_, count);
  histogram_.fill(0);
  const View<uint32_t> counts = histogram_.view().first(count);
  device_.parallel_for("ranks/layers", particles.sorted,
                       rank_kernels::CountLayers{particles.position, shape, first, counts});
  const std::vector<uint32_t> own = histogram_.read(count);
  return {first, {own.begin(), own.end()}};
}

template <class D>
int32_t RankExchange<D>::layers_within(const GridView& grid, const Aabb& extent) const {
  GridView shape = grid;
  shape.layers_along_y = layers_along_y_;
  const int32_t first = std::max(shape.layer(shape.coordinates(extent.lower)), first_layer()),
                last = std::min(shape.layer(shape.coordinates(extent.upper)), end_layer() - 1);
  return std::max(last - first + 1, 1) + 2;
}

/// A layer with particles has corners on both of its sides. The corners below have edges that reach into it.
template <class D>
template <class Points>
typename RankExchange<D>::OccupiedLayers RankExchange<D>::find_layers(const Points& points,
                                                                      const GridView& grid, uint32_t count) {
  using namespace rank_kernels;
  occupied_.resize_discard(1);
  device_.reduce("ranks/occupied", count, no_layers, LayersOf<Points>{points, grid}, MergeLayers{},
                 occupied_.view());
  GhostExchange::Layers all = no_layers;
  for (const GhostExchange::Layers& of_rank : values_of_all(ranks_, occupied_.read(1)[0]))
    all = MergeLayers{}(all, of_rank);
  corner_layers_.clear();
  for (int r = 0; r < ranks_.count(); ++r)
    corner_layers_.push_back(
        {std::max(slabs_.first(r), all.first - 1), std::min(slabs_.end(r), all.end + 1)});
  if (all.first >= all.end) return {0, 1};
  const int32_t first = std::max(first_layer() - 1, all.first), last = std::min(end_layer() + 1, all.end);
  return {static_cast<uint32_t>(all.end - all.first), std::max(last - first, 1)};
}

template <class D>
void RankExchange<D>::cut_all(const ParticleView& particles, const GridView& grid, const Aabb& extent) {
  Histogram layers = count_layers(particles, grid, extent);
  const bool is_empty = !(extent.lower.z <= extent.upper.z);
  if (is_empty) layers.first = 0;
  cut(std::move(layers));
}

template <class D>
void RankExchange<D>::cut_all(std::span<const Vec4> positions, const GridView& grid) {
  GridView shape = grid;
  shape.layers_along_y = layers_along_y_;
  std::vector<int32_t> layer_of;
  for (const Vec4& p : positions) layer_of.push_back(shape.layer(shape.coordinates(p.xyz())));
  if (layer_of.empty()) return cut({0, {0}});
  const auto [least, most] = std::minmax_element(layer_of.begin(), layer_of.end());
  Histogram layers{*least, std::vector<uint64_t>(
                               static_cast<size_t>(std::min(*most - *least + 1, rank_kernels::most_layers)))};
  for (const int32_t layer : layer_of)
    ++layers.counts[std::min(static_cast<size_t>(layer - layers.first), layers.counts.size() - 1)];
  cut(std::move(layers));
}

template <class D>
void RankExchange<D>::cut(Histogram layers) {
  if (policy_.expects_more) layers.counts.resize(std::max(layers.counts.size(), least_layers()));
  slabs_ = even_slabs_ = Slabs(layers.first, layers.counts, ranks_.count());
}

template <class D>
void RankExchange<D>::balance(const ParticleView& particles, const GridView& grid, const Aabb& extent) {
  if (steps_++ % policy_.every != 0 || !(extent.lower.z <= extent.upper.z)) return;
  Histogram layers = count_layers(particles, grid, extent);
  ranks_.add_up(layers.counts);
  const bool has_room = layers.counts.size() >= least_layers();
  if (has_room && even_slabs_.imbalance(layers.first, layers.counts) > policy_.most_imbalance)
    even_slabs_ = Slabs(layers.first, layers.counts, ranks_.count());
  slabs_ = even_slabs_.moved(++looks_ % 2 ? policy_.shift : 0);
}

// ---- particles ----

template <class D>
template <class Tags>
std::vector<uint32_t> RankExchange<D>::select(uint32_t count, const Tags& tags, uint32_t kinds,
                                              Buffer<uint32_t>& list) {
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
                     static_cast<uint32_t>(std::bit_width(kinds - 1)));
  device_.parallel_for("ranks/ends", kinds, EndsOfTags{sorted, ends_.view()});
  std::vector<uint32_t> numbers = ends_.read(kinds);
  std::adjacent_difference(numbers.begin(), numbers.end(), numbers.begin());
  return numbers;
}

template <class D>
template <class Points>
uint32_t RankExchange<D>::send(const Points& points, const GridView& grid, uint32_t count,
                               const std::vector<WordArray>& arrays) {
  const rank_kernels::Destinations<Points> destinations{points, grid, write_cuts(),
                                                        static_cast<uint32_t>(ranks_.rank())};
  const uint32_t arriving = choose_leaving(count, destinations);
  if (is_on_any(ranks_, count + arriving > capacity_)) throw LacksRoom{count + arriving};
  send_leaving(arrays);
  take_over(count, arrays);
  return count + arriving;
}

template <class D>
View<const int32_t> RankExchange<D>::write_cuts() {
  rank_kernels::make_room(cuts_, static_cast<size_t>(ranks_.count()));
  cuts_.write(slabs_.cuts());
  return View<const int32_t>(cuts_.view()).first(static_cast<uint32_t>(ranks_.count()) - 1);
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
  const uint32_t arriving = choose_leaving(
      count, rank_kernels::Owners{arrays.front(), grid, write_cuts(), static_cast<uint32_t>(ranks_.rank())});
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

template <class D>
void RankExchange<D>::note_sorted(View<const Vec4> position, const GridView& grid, uint32_t owned,
                                  uint32_t ghosts) {
  using namespace rank_kernels;
  const bool has_below = ranks_.rank() > 0, has_above = ranks_.rank() + 1 < ranks_.count();
  const std::vector<uint32_t> numbers = select(
      owned + ghosts, Boundaries{position, grid, owned, first_layer(), end_layer(), has_below, has_above},
      boundary_kinds, lists_);
  const auto first = [&](Boundary tag) {
    return std::accumulate(numbers.begin(), numbers.begin() + tag, uint32_t{0});
  };
  const auto note = [&](Side& side, Boundary needed, Boundary ghost) {
    side = {side.rank, numbers[needed], first(needed), numbers[ghost], first(ghost)};
  };
  if (has_below) note(sides_.front(), needed_below, ghost_below);
  if (has_above) note(sides_.back(), needed_above, ghost_above);
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
