// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of the neighbour search, the shape of its grid, and its launches.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>

#include "pbd/device/base/atomics.h"
#include "pbd/list_writers.h"
#include "pbd/neighbour_search.h"
#include "pbd/tuning.h"

namespace meniscus::pbd {

namespace neighbour_kernels {

// The sort is a counting sort by cell. Particles of a cell are first placed in the order of arrival, then in
// the order of their numbers. So the result depends on nothing else.

/// Records each particle's cell, and counts the particles of each cell.
template <class Points>
struct CountInCells {
  Points points;
  GridView grid;
  View<uint32_t> key, arrival, counts;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Vec3 p = points(i).xyz();
    // Particles that are not finite have no neighbours. They are spread over the cells, because a single cell
    // would take very long.
    const CellCoordinates at = grid.coordinates(p);
    const uint32_t in_world = !is_finite(p)    ? i & (grid.cell_count() - 1)
                              : grid.holds(at) ? grid.key(at)
                                               : grid.all_cells() - 1;
    const uint32_t cell = grid.first_cell(i) + in_world;
    key[i] = cell;
    arrival[i] = atomic_add(counts[cell], 1);
  }
};

/// Also resets the counts to 0, for the next sort.
struct PlaceByArrival {
  View<const uint32_t> key, arrival, start, number;
  View<uint32_t> placed, placed_number, counts;
  uint32_t particles, cells;

  MENISCUS_HD void operator()(uint32_t i) const {
    const uint32_t place = start[key[i]] + arrival[i];
    placed[place] = i;
    placed_number[place] = number[i];
    for (uint32_t cell = i; cell < cells; cell += particles) counts[cell] = 0;
  }
};

/// `coarsely`: a thread that builds a list alone uses coarse positions.
template <bool coarsely>
struct ListNeighbours {
  static constexpr uint32_t resident_blocks = 9;  // see CudaDevice

  View<const Vec4> position;
  CoarsePositions coarse;
  GridView grid;
  float reach2;
  NeighbourView lists;
  View<uint32_t> longest;

  template <class D>
  MENISCUS_HD void run(uint32_t i) const {
    const Vec3 self = position[i].xyz();
    if constexpr (std::is_same_v<D, CudaTeam>) {
      TeamWriter writer(lists, i);
      if (is_finite(self)) list_by_team(i, self, writer);
      note(i, writer.finish(lists.sentinel), false, D::leads());
    } else if constexpr (D::interleaves_lists) {
      const RunsAround runs(grid, self, grid.first_cell(i));
      if (lists.row_capacity <= NarrowWriter::most && runs.are_within(NeighbourView::narrow_reach, i)) {
        NarrowWriter writer(lists, i);
        list_alone<D>(i, self, runs, writer);
        note(i, writer.finish(), true, true);
      } else {
        WideWriter writer(lists, i);
        list_alone<D>(i, self, runs, writer);
        note(i, writer.finish(lists.sentinel), false, true);
      }
    } else {
      RowWriter writer(lists, i);
      if (is_finite(self)) list<D>(i, self, RunsAround(grid, self, grid.first_cell(i)), writer);
      note(i, writer.finish(lists.sentinel), false, true);
    }
  }

 private:
  template <class D, class Writer>
  MENISCUS_HD void list_alone(uint32_t i, Vec3 self, const RunsAround& runs, Writer& writer) const {
    if (!is_finite(self)) return;
    if constexpr (coarsely)
      list_coarsely(i, self, runs, writer);
    else if constexpr (std::is_same_v<Writer, NarrowWriter>)
      list_narrow<D>(i, self, runs, writer);
    else
      list<D>(i, self, runs, writer);
  }

  template <class D, class Writer>
  MENISCUS_HD void list(uint32_t i, Vec3 self, const RunsAround& runs, Writer& writer) const {
    runs.for_each([&](uint32_t begin, uint32_t end) {
      for (uint32_t j = begin; j < end; j += 32) writer.append(j, near_ones<D>(self, i, j, end));
    });
  }

  template <class D>
  MENISCUS_HD void list_narrow(uint32_t i, Vec3 self, const RunsAround& runs, NarrowWriter& writer) const {
    runs.for_each([&](uint32_t begin, uint32_t end) {
      const auto look = [&](const auto& add) {
        D::Lister::for_each(position, begin, end, [&](uint32_t j, Vec3 other) {
          const Vec3 d = self - other;
          add(dot(d, d) < reach2 && j < end, j);
        });
      };
      const bool has_self = i - begin < end - begin;
      if (!has_self && writer.has_room_for(end - begin))
        look([&](bool near, uint32_t j) {
          if (near) writer.add_in_room(j);
        });
      else
        look([&](bool near, uint32_t j) {
          if (near && j != i) writer.add(j);
        });
    });
  }

  /// A run that contains i is scanned in two parts, so that i need not be compared with each candidate.
  template <class Writer>
  MENISCUS_HD void list_coarsely(uint32_t i, Vec3 self, const RunsAround& runs, Writer& writer) const {
    const Vec3 at = CoarsePositions::in_cell(grid, self);
    NearHalves near(at.x, CoarsePositions::period);
    runs.for_each_row([&](uint32_t begin, uint32_t end, float y, float z) {
      near.set_row(at.y - y, at.z - z);
      const bool has_self = i - begin < end - begin;
      uint32_t from = begin, to = has_self ? i : end;
      MENISCUS_NO_UNROLL
      for (int parts = has_self ? 2 : 1; parts > 0; --parts) {
        if (writer.has_room_for(to - from))
          near.for_each(coarse.blocks, from, to, [&](uint32_t j, uint32_t k) { writer.add_in_room(j, k); });
        else
          near.for_each(coarse.blocks, from, to, [&](uint32_t j, uint32_t k) { writer.add(j, k); });
        from = i + 1;
        to = end;
      }
    });
  }

  /// Each thread looks up some of the bounds. Then the team scans one run after another, so that the list has
  /// the order of the runs.
  MENISCUS_HD void list_by_team(uint32_t i, Vec3 self, TeamWriter& writer) const {
    const Surroundings around(grid, self, grid.first_cell(i));
    const uint32_t rank = CudaTeam::rank(), runs = around.runs();
    for (uint32_t first = 0; first < runs; first += CudaTeam::lane_count) {
      const Run own = first + rank < runs ? around.run(first + rank) : Run{0, 0};
      for (uint32_t n = 0; n < CudaTeam::lane_count && first + n < runs; ++n) {
        const Run run{from_lane_of_team(own.begin, n), from_lane_of_team(own.end, n)};
        for (uint32_t j = run.begin; j < run.end; j += CudaTeam::lane_count) {
          const Vec3 d = self - load(position, j + rank).xyz();
          writer.append(j + rank, dot(d, d) < reach2 && j + rank < run.end && j + rank != i);
        }
      }
    }
  }

  MENISCUS_HD void note(uint32_t i, uint32_t found, bool is_narrow, bool leads) const {
    if (!leads) return;
    const uint32_t size = found < lists.row_capacity ? found : lists.row_capacity;
    lists.count[i] = is_narrow ? size | NeighbourView::narrow_bit : size;
    atomic_max(longest[0], found);
  }

  /// Bit k is set where particle first + k, one of at most 32 before `end`, is in reach and is not i. Whole
  /// masks keep the threads of a warp converged: the rare hits are written afterwards.
  template <class D>
  MENISCUS_HD uint32_t near_ones(Vec3 self, uint32_t i, uint32_t first, uint32_t end) const {
    const uint32_t near = D::Lister::near(position, self, reach2, first, end - first < 32 ? end - first : 32);
    return i - first < 32 ? near & ~(1u << (i - first)) : near;
  }
};

/// The axis with the most bits, of those that may have fewer. A row that is too short holds cells twice
/// within reach of a point, and its order then depends on the table.
inline size_t axis_to_narrow(const std::array<uint32_t, 3>& bits) {
  size_t axis = 0;
  for (size_t k = 1; k < 3; ++k) {
    const bool is_least = axis == 0 && bits[0] <= GridView::least_bits_x;
    if (bits[k] > GridView::least_bits && (is_least || bits[k] > bits[axis])) axis = k;
  }
  return axis;
}

/// Cells of a table for so many particles.
inline uint32_t table_for(uint32_t count, uint32_t least) {
  uint32_t cells = least;
  while (cells < GridView::slices * count) cells *= 2;
  return cells;
}

inline uint32_t bits_for(float cells, uint32_t least) {
  uint32_t bits = least;
  while (bits < 30 && static_cast<float>(1u << bits) < cells) ++bits;
  return bits;
}

/// The extent in support radii, with a cell on each side.
inline Vec3 reaches_of(float inverse_reach, const Aabb& extent) {
  return inverse_reach * (extent.upper - extent.lower) + Vec3{2, 2, 2};
}

/// The bits of a table, on each axis, in which no cells of the extent share an entry.
inline std::array<uint32_t, 3> bits_of(float inverse_reach, const Aabb& extent) {
  const Vec3 reaches = reaches_of(inverse_reach, extent);
  return {bits_for(GridView::slices * reaches.x, GridView::least_bits_x),
          bits_for(reaches.y, GridView::least_bits), bits_for(reaches.z, GridView::least_bits)};
}

/// As many rows as keep the indices of neighbours close to each other: all, if a layer has few particles;
/// else as many as can be full, at h = 2 s.
inline uint32_t strip_bits_for(Vec3 reaches, uint32_t count) {
  constexpr float close = NeighbourView::narrow_reach;
  if (search_tuning::unevenness * static_cast<float>(count) < close * reaches.z) return 31;
  const float rows = close / (search_tuning::particles_in_cube * reaches.x) - 1;
  return static_cast<uint32_t>(std::bit_width(static_cast<uint32_t>(std::fmax(rows, 1.0f)))) - 1;
}

}  // namespace neighbour_kernels

template <class D>
NeighbourSearch<D>::NeighbourSearch(D& device, float support_radius, uint32_t row_capacity)
    : device_(device), support_radius_(support_radius), row_capacity_(row_capacity) {
  grid_.inverse_reach = 1.0f / support_radius;
}

template <class D>
void NeighbourSearch<D>::reserve(uint32_t capacity) {
  capacity_ = capacity;
  const uint32_t size = capacity + Particles::padding;
  for (Buffer<uint32_t>* b : {&order_, &counts_}) b->resize_discard(size);
  reserve_lists(grid_.is_part ? 0 : capacity);  // those of a part grow with it
  if constexpr (D::interleaves_lists) coarse_.resize_discard(size / HalfBlock::points + 3);
  if (grid_.is_part) return;  // see fit_part()
  cells_ = neighbour_kernels::table_for(capacity / worlds_, least_cells());
  reserve_table(worlds_ * cells_);
}

template <class D>
void NeighbourSearch<D>::reserve_lists(uint32_t rows) {
  rows_ = 0;
  index_.resize_discard((size_t{rows} + Particles::padding) * row_capacity_);
  rows_ = rows;
}

template <class D>
void NeighbourSearch<D>::reserve_table(uint32_t cells) {
  cell_counts_.resize_discard(cells);
  cell_counts_.fill(0);
  cell_start_.resize_discard(cells + 1);
}

template <class D>
void NeighbourSearch<D>::set_part(const Region& part) {
  grid_.is_part = true;
  grid_.part = part;
}

template <class D>
void NeighbourSearch<D>::fit_part(const Aabb& extent, uint32_t count, PartLayers layers) {
  using namespace neighbour_kernels;
  const uint32_t cells = has_own_cells_ ? most_cells(count) : table_for(count, least_cells());
  shape(extent, count, static_cast<uint32_t>(std::bit_width(cells)) - 1);
  const auto narrow = [](uint32_t& bits, int32_t most) {
    bits = std::min(bits, bits_for(static_cast<float>(most), GridView::least_bits));
  };
  if (grid_.part.is_cut_along_y()) narrow(grid_.bits_y, layers.y);
  if (grid_.part.is_cut_along_z()) narrow(grid_.bits_z, layers.z);
  grid_.strip_bits = std::min(grid_.strip_bits, grid_.bits_y);
  if (grid_.all_cells() > cell_counts_.size() || cell_counts_.size() > 3 * size_t{grid_.all_cells()})
    reserve_table(grid_.all_cells());
  grid_.start = cell_start_.view().first(grid_.all_cells() + 1);
}

template <class D>
std::pair<uint32_t, uint32_t> NeighbourSearch<D>::count_part() const {
  uint32_t owned = 0, both = 0;
  device_.copy_out(&owned, grid_.start.data + grid_.cell_count(), sizeof owned);
  device_.copy_out(&both, grid_.start.data + grid_.all_cells() - 1, sizeof both);
  return {owned, both - owned};
}

/// To a cell for each place in the extent, but not beyond 16 times what the particles need. If there is not
/// enough memory, the table is as before.
template <class D>
void NeighbourSearch<D>::grow_table(const Aabb& extent) {
  uint32_t bits = 0;
  for (const uint32_t of_axis : neighbour_kernels::bits_of(grid_.inverse_reach, extent)) bits += of_axis;
  const uint32_t before = cells_;
  const uint64_t cells = std::min(uint64_t{1} << std::min(bits, 31u), uint64_t{most_cells(capacity_)});
  if (cells <= before) return;
  try {
    cells_ = static_cast<uint32_t>(cells);
    reserve_table(worlds_ * cells_);
  } catch (...) {
    cells_ = before;
    reserve_table(worlds_ * cells_);
    throw;
  }
}

/// Of a table with own cells for so many particles in all worlds.
template <class D>
uint32_t NeighbourSearch<D>::most_cells(uint32_t count) const {
  const uint64_t most = 8 * uint64_t{GridView::slices} * (count / worlds_);
  return static_cast<uint32_t>(std::clamp(std::bit_ceil(most), uint64_t{least_cells()}, uint64_t{1} << 31));
}

template <class D>
void NeighbourSearch<D>::fit(const Aabb& extent, uint32_t count) {
  if (has_own_cells_) grow_table(extent);
  const uint32_t cells = has_own_cells_ ? std::min(cells_, most_cells(count)) : cells_;
  shape(extent, count, static_cast<uint32_t>(std::bit_width(cells)) - 1);
  grid_.start = cell_start_.view().first(worlds_ * grid_.all_cells() + 1);
}

template <class D>
void NeighbourSearch<D>::shape(const Aabb& extent, uint32_t count, uint32_t most_bits) {
  using namespace neighbour_kernels;
  std::array<uint32_t, 3> bits = bits_of(grid_.inverse_reach, extent);
  if constexpr (D::interleaves_lists) {
    // Coarse positions do not distinguish cells that share an entry, and are too coarse far from the origin.
    const Vec3 far = grid_.inverse_reach * max(abs(extent.lower), abs(extent.upper));
    is_coarse_ = !device_.fixes_sums() && count > D::most_teams && bits[0] + bits[1] + bits[2] <= most_bits &&
                 Surroundings::slack_at(far) < search_tuning::most_coarse_slack;
  }
  while (bits[0] + bits[1] + bits[2] > most_bits) --bits[axis_to_narrow(bits)];
  grid_.bits_x = bits[0];
  grid_.bits_y = bits[1];
  grid_.bits_z = bits[2];
  grid_.strip_bits =
      std::min(strip_bits_for(reaches_of(grid_.inverse_reach, extent), count / worlds_), bits[1]);
  grid_.whole_layer_bits = grid_.layers_along_y ? bits[1] : bits[2];
  grid_.whole_strip_bits = grid_.strip_bits;
}

template <class D>
template <class Points>
CellOrder NeighbourSearch<D>::sort(const Points& points, View<const uint32_t> number) {
  using namespace neighbour_kernels;
  const uint32_t count = number.count, cells = worlds_ * grid_.all_cells();
  const View<uint32_t> counts = cell_counts_.view().first(cells);
  if (size_t{4} * count > index_.size()) reserve_lists(4 * (count / row_capacity_ + 1));
  uint32_t* const room = index_.view().data;
  const View<uint32_t> keys{room, count}, arrival{room + count, count}, placed{arrival.data + count, count},
      placed_number{placed.data + count, count};
  try {
    device_.parallel_for("neighbours/cells", count,
                         CountInCells<Points>{points, grid_, keys, arrival, counts});
    device_.exclusive_scan("neighbours/starts", View<const uint32_t>(counts), cell_start_.view());
    device_.parallel_for(
        "neighbours/place", count,
        PlaceByArrival{keys, arrival, grid_.start, number, placed, placed_number, counts, count, cells});
  } catch (...) {
    cell_counts_.fill(0);
    throw;
  }
  return {keys, grid_.start, placed, placed_number, order_.view()};
}

template <class D>
void NeighbourSearch<D>::list(const ParticleView& particles, uint32_t sentinel, View<uint32_t> longest) {
  using namespace neighbour_kernels;
  const float reach2 = support_radius_ * support_radius_;
  if constexpr (D::interleaves_lists) {
    if (is_coarse_) {
      device_.parallel_for_long(
          "neighbours/list", particles.sorted,
          ListNeighbours<true>{particles.position, coarse(), grid_, reach2, view(sentinel), longest});
      return;
    }
  }
  device_.parallel_for_long(
      "neighbours/list", particles.sorted,
      ListNeighbours<false>{particles.position, {}, grid_, reach2, view(sentinel), longest});
}

template <class D>
void NeighbourSearch<D>::grow_rows(uint32_t needed) {
  const uint32_t row_capacity = (needed + needed / 8 + 15) / 16 * 16;
  index_.resize_or_stay((size_t{rows_} + Particles::padding) * row_capacity);
  row_capacity_ = row_capacity;
}

template <class D>
NeighbourView NeighbourSearch<D>::view(uint32_t sentinel) {
  if (grid_.is_part) {  // the sort is done, and its temporary memory is free
    const uint32_t owned = count_part().first;
    if (owned > rows_) reserve_lists(owned + owned / 16);
  }
  return {index_.view(), counts_.view(), row_capacity_, stride(), sentinel};
}

}  // namespace meniscus::pbd
