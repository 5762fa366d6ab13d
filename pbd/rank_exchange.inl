// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How particles and the values of ghosts go from rank to rank.
#pragma once

#include <algorithm>

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
typename RankExchange<D>::Layers RankExchange<D>::count_layers(const ParticleView& particles,
                                                               const GridView& grid, const Aabb& extent) {
  constexpr int32_t most = 1 << 16;  // beyond them, stray particles count for the ends
  GridView shape = grid;
  shape.layers_along_y = layers_along_y_;
  const auto layer_of = [&](Vec3 p) { return shape.layer(shape.coordinates(p)); };
  const int32_t first = layer_of(extent.lower), layers = std::min(layer_of(extent.upper) - first + 1, most);
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

template <class D>
void RankExchange<D>::cut_all(const ParticleView& particles, const GridView& grid, const Aabb& extent) {
  Layers layers = count_layers(particles, grid, extent);
  if (policy_.expects_more) {
    const bool is_empty = !(extent.lower.z <= extent.upper.z);
    if (is_empty) layers.first = 0;
    layers.counts.resize(std::max(layers.counts.size(), least_layers()));
  }
  slabs_ = even_slabs_ = Slabs(layers.first, layers.counts, ranks_.count());
}

template <class D>
void RankExchange<D>::balance(const ParticleView& particles, const GridView& grid, const Aabb& extent) {
  if (steps_++ % policy_.every != 0 || !(extent.lower.z <= extent.upper.z)) return;
  Layers layers = count_layers(particles, grid, extent);
  ranks_.add_up(layers.counts);
  const bool has_room = layers.counts.size() >= least_layers();
  if (has_room && even_slabs_.imbalance(layers.first, layers.counts) > policy_.most_imbalance)
    even_slabs_ = Slabs(layers.first, layers.counts, ranks_.count());
  slabs_ = even_slabs_.moved(++looks_ % 2 ? policy_.shift : 0);
}

// ---- particles ----

template <class D>
template <class Tags>
std::vector<Selected> RankExchange<D>::select(uint32_t count, const Tags& tags) {
  using namespace rank_kernels;
  if (count == 0) return {};
  device_.parallel_for("ranks/count", count, CountTags<Tags>{tags, counts_.view()});
  device_.exclusive_scan("ranks/offsets", View<const uint32_t>{counts_.view().data, count}, start_.view());
  uint32_t total = 0;
  device_.copy_out(&total, start_.view().data + count, sizeof total);
  if (total == 0) return {};
  make_room(selected_, total);
  device_.parallel_for("ranks/select", count, PlaceTags<Tags>{tags, start_.view(), selected_.view()});
  return selected_.read(total);
}

template <class D>
template <class Points>
uint32_t RankExchange<D>::send(const Points& points, const GridView& grid, uint32_t count,
                               const std::vector<WordArray>& arrays) {
  using namespace rank_kernels;
  const auto ranks = static_cast<size_t>(ranks_.count());
  make_room(cuts_, ranks);
  cuts_.write(slabs_.cuts());
  const View<const int32_t> cuts = View<const int32_t>(cuts_.view()).first(static_cast<uint32_t>(ranks) - 1);
  std::vector<Selected> leaving =
      select(count, Destinations<Points>{points, grid, cuts, static_cast<uint32_t>(ranks_.rank())});
  std::stable_sort(leaving.begin(), leaving.end(),
                   [](const Selected& a, const Selected& b) { return a.tag < b.tag; });
  std::vector<uint32_t> list, to(ranks), from(ranks);
  for (const Selected& s : leaving) {
    list.push_back(s.index);
    ++to[s.tag];
  }
  ranks_.transpose(to, from);

  uint32_t words = 0, arriving = 0;
  for (const WordArray& a : arrays) words += a.words;
  for (const uint32_t n : from) arriving += n;
  if (is_on_any(ranks_, count + arriving > capacity_)) throw LacksRoom{count + arriving};
  make_room(lists_, list.size());
  make_room(out_, list.size() * words);
  make_room(in_, size_t{arriving} * words);
  lists_.write(list);
  std::vector<Sent> sent;
  std::vector<Received> received;
  uint32_t* out = out_.view().data;
  const uint32_t* next = lists_.view().data;
  uint32_t* in = in_.view().data;
  for (size_t r = 0; r < ranks; ++r) {
    const size_t sent_words = size_t{to[r]} * words, received_words = size_t{from[r]} * words;
    sent.push_back({static_cast<int>(r), out, sent_words * sizeof(uint32_t)});
    received.push_back({static_cast<int>(r), in, received_words * sizeof(uint32_t)});
    for (const WordArray& a : arrays) {
      pack(a, {next, to[r]}, out);
      out += size_t{to[r]} * a.words;
    }
    next += to[r];
    in += received_words;
  }
  exchange(sent, received);
  uint32_t place = count;
  const uint32_t* arrived = in_.view().data;
  for (const uint32_t n : from) {
    for (const WordArray& a : arrays) {
      const size_t size = size_t{n} * a.words;
      if (n) device_.copy(a.data + size_t{place} * a.words, arrived, size * sizeof(uint32_t));
      arrived += size;
    }
    place += n;
  }
  return place;
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
  for (Side& side : sides_) {
    side.needed.clear();
    side.ghosts.clear();
  }
  const bool has_below = ranks_.rank() > 0, has_above = ranks_.rank() + 1 < ranks_.count();
  const std::vector<Selected> all = select(
      owned + ghosts, Boundaries{position, grid, owned, first_layer(), end_layer(), has_below, has_above});
  for (const Selected& s : all) {
    const bool is_above = s.tag == needed_above || s.tag == ghost_above;
    Side& side = is_above ? sides_.back() : sides_.front();
    (s.tag == needed_below || s.tag == needed_above ? side.needed : side.ghosts).push_back(s.index);
  }
  std::vector<uint32_t> lists;
  for (Side& side : sides_) {
    side.first_needed = static_cast<uint32_t>(lists.size());
    lists.insert(lists.end(), side.needed.begin(), side.needed.end());
    side.first_ghost = static_cast<uint32_t>(lists.size());
    lists.insert(lists.end(), side.ghosts.begin(), side.ghosts.end());
  }
  make_room(lists_, lists.size());
  lists_.write(lists);
}

template <class D>
void RankExchange<D>::refresh(void* values, uint32_t words) {
  using namespace rank_kernels;
  const WordArray array{static_cast<uint32_t*>(values), words};
  size_t needed = 0, ghosts = 0;
  for (const Side& side : sides_) {
    needed += side.needed.size();
    ghosts += side.ghosts.size();
  }
  make_room(out_, needed * words);
  make_room(in_, ghosts * words);
  std::vector<Sent> sent;
  std::vector<Received> received;
  uint32_t *out = out_.view().data, *in = in_.view().data;
  const uint32_t* const lists = lists_.view().data;
  for (const Side& side : sides_) {
    const size_t sent_words = side.needed.size() * words, received_words = side.ghosts.size() * words;
    pack(array, {lists + side.first_needed, static_cast<uint32_t>(side.needed.size())}, out);
    sent.push_back({side.rank, out, sent_words * sizeof(uint32_t)});
    received.push_back({side.rank, in, received_words * sizeof(uint32_t)});
    out += sent_words;
    in += received_words;
  }
  exchange(sent, received);
  in = in_.view().data;
  for (const Side& side : sides_) {
    const View<const uint32_t> list{lists + side.first_ghost, static_cast<uint32_t>(side.ghosts.size())};
    device_.parallel_for("ranks/unpack", list.count, Unpack{in, list, array});
    in += side.ghosts.size() * words;
  }
}

}  // namespace meniscus::pbd
