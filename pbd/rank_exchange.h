// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How a rank of a shared world exchanges particles and ghosts with the others.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "pbd/ghosts.h"
#include "pbd/grid.h"
#include "pbd/neighbour_search.h"
#include "pbd/particles.h"
#include "pbd/ranks/cuts.h"
#include "pbd/ranks/ranks.h"

namespace meniscus::pbd {

/// Where the cuts between ranks are, and when they move.
struct CutPolicy {
  CutKind kind = CutKind::automatic;
  int every = 16;                ///< steps between two looks
  double most_imbalance = 1.05;  ///< see Cuts::imbalance
  int32_t shift = 0;             ///< layers by which the cuts move to and fro with each look
  bool expects_more = false;     ///< particles come: at first there may be fewer layers than the ranks need
};

/// Thrown on all ranks, if one of them has no room for what the others want to send.
struct LacksRoom {
  uint32_t needed;  ///< particles on this rank, with its ghosts
};

/// A rank with ghosts of this one.
struct NeighbourRank {
  Region region;
  uint32_t rows_along_y;  ///< 1: the rows of these ghosts are in a layer of z, one for each y; 0: as for z
};

/// Each particle has one owner: the rank in whose region its predicted position is. Before each sort, a rank
/// sends away the particles that others own from now on, and copies of those that are ghosts there. The sort
/// puts owned particles first and ghosts behind them. Within a row both are in the canonical order. Between
/// two ranks, rows go in the order of their layers. So both have the same ghosts in the same order, and later
/// messages carry values alone.
template <class D>
class RankExchange final : public GhostExchange {
 public:
  RankExchange(D& device, Ranks& ranks, bool layers_along_y);

  Ranks& ranks() { return ranks_; }
  void set_policy(const CutPolicy& policy) { policy_ = policy; }

  void reserve(uint32_t capacity);

  /// The first cuts, where every rank knows all particles: on the device, or where they are to be.
  void cut_all(const ParticleView& particles, const GridView& grid, const Aabb& extent);
  void cut_all(std::span<const Vec4> positions, const GridView& grid);
  /// Moves the cuts if the policy asks for it. `extent`: of the particles of all ranks.
  void balance(const ParticleView& particles, const GridView& grid, const Aabb& extent);
  const Region& region() const { return cuts_.region(ranks_.rank()); }
  /// The layers that may have particles of this rank or their ghosts, where this is the extent of all.
  PartLayers layers_within(const GridView& grid, const Aabb& extent) const;
  /// For slabs. Finds which layers have particles, of which the first `count` are on this rank. Returns how
  /// many layers there are, on all ranks and on this one with its ghosts.
  struct OccupiedLayers {
    uint32_t all;
    int32_t own;
  };
  template <class Points>
  OccupiedLayers find_layers(const Points& points, const GridView& grid, uint32_t count);

  /// Sends the first `count` particles to where points(i) is, and writes those that arrive behind them.
  /// Returns how many there are then. Throws LacksRoom before anything is sent.
  template <class Points>
  uint32_t send(const Points& points, const GridView& grid, uint32_t count,
                const std::vector<WordArray>& arrays);

  /// Notes which sorted particles are ghosts, or have ghosts on other ranks.
  void note_sorted(View<const Vec4> position, const GridView& grid, uint32_t owned, uint32_t ghosts);
  void refresh(void* values, uint32_t words) override;
  void add_up(std::span<uint64_t> values) override { ranks_.add_up(values); }
  int rank() const override { return ranks_.rank(); }
  std::span<const GhostExchange::Layers> corner_layers() const override { return corner_layers_; }
  void share(uint32_t* words, std::span<const size_t> starts) override;
  void pass_up(const uint32_t* sent, uint32_t* received, size_t words) override;
  uint32_t hand_over(const GridView& grid, uint32_t count, const std::vector<WordArray>& arrays) override;
  void take_over(uint32_t first, const std::vector<WordArray>& arrays) override;

 private:
  using Layers = GhostExchange::Layers;

  /// Writes to `list` the i below `count` to which tags.for_each(i, visit) gives a tag: by tag, and those of
  /// a tag in order. Returns how many there are of each of `kinds` kinds. The kind of a tag is what is above
  /// its lowest `row_bits`. The list stays on the device.
  template <class Tags>
  std::vector<uint32_t> select(uint32_t count, const Tags& tags, uint32_t kinds, Buffer<uint32_t>& list,
                               uint32_t row_bits = 0);
  CutAxes axes() const;
  Layers slab(int rank) const;
  ColumnCounts no_counts(const GridView& grid, const Aabb& extent) const;
  /// Chooses what leaves: the elements below count, for the ranks that are their tags. Returns how many
  /// arrive.
  template <class Tags>
  uint32_t choose_leaving(uint32_t count, const Tags& tags);
  void send_leaving(const std::vector<WordArray>& arrays);
  void cut(ColumnCounts columns);
  void set_cuts(Cuts cuts);
  CutsView cuts_on_device() const;
  ColumnCounts count_columns(const ParticleView& particles, const GridView& grid, const Aabb& extent);
  void exchange(std::span<const Sent> sent, std::span<const Received> received);
  void pack(const WordArray& from, View<const uint32_t> list, uint32_t* to);

  D& device_;
  Ranks& ranks_;
  bool layers_along_y_;
  CutPolicy policy_;
  Cuts cuts_, even_cuts_;
  std::vector<GhostExchange::Layers> corner_layers_;  // by rank
  int looks_ = 0, steps_ = 0;
  uint32_t capacity_ = 0;

  /// Where in lists_ the particles are that a neighbour needs, and the ghosts that it owns.
  struct Side {
    int rank;
    uint32_t needed, first_needed, ghosts, first_ghost;
  };
  std::vector<Side> sides_;
  /// Elements by rank, of the last message.
  std::vector<uint32_t> to_, from_;

  Buffer<uint32_t> counts_{device_, "exchange counts"};
  Buffer<uint32_t> start_{device_, "exchange offsets"};
  Buffer<uint32_t> tag_{device_, "tags of exchanged particles"};
  Buffer<uint32_t> sorted_tag_{device_, "tags of exchanged particles"};
  Buffer<uint32_t> index_{device_, "exchanged particles"};
  Buffer<uint32_t> ends_{device_, "ends of exchange lists"};
  Buffer<uint32_t> lists_{device_, "exchange lists"};
  Buffer<uint32_t> leaving_{device_, "exchange lists"};
  Buffer<uint32_t> out_{device_, "messages"}, in_{device_, "messages"};
  Buffer<Cut> tree_{device_, "cuts between ranks"};
  Buffer<NeighbourRank> neighbours_{device_, "neighbours of a rank"};
  Buffer<uint32_t> histogram_{device_, "particles by column"};
  Buffer<GhostExchange::Layers> occupied_{device_, "layers with particles"};
};

}  // namespace meniscus::pbd
