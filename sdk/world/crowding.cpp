// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Counts the particles near each new one, if cells of the grid hold so many that there may be too many.
#include "sdk/world/crowding.h"

#include <meniscus/error.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "sdk/engine/point_table.h"
#include "sdk/world/tuning.h"

namespace meniscus {

namespace {

constexpr uint64_t most = world_tuning::most_crowded;

/// At least the number of points within a cell's size of any place: a ball touches 27 cells.
uint64_t bound_of(const PointTable& table) {
  const std::span<const uint32_t> start = table.start();
  uint32_t fullest = 0;
  for (size_t b = 0; b + 1 < start.size(); ++b) fullest = std::max(fullest, start[b + 1] - start[b]);
  return 27 * uint64_t{fullest};
}

/// The number of points within `reach` of p.
uint64_t count_near(const PointTableView& table, std::span<const Vec3> points, Vec3 p, float reach) {
  const PointTableView::Cell c = table.cell_of(p);
  uint64_t count = 0;
  for (int32_t k = 0; k < 27; ++k) {
    const PointTableView::Cell cell{c.x + k % 3 - 1, c.y + k / 3 % 3 - 1, c.z + k / 9 - 1};
    const uint32_t b = table.bucket(cell);
    for (uint32_t at = table.start[b]; at < table.start[b + 1]; ++at) {
      const Vec3 q = points[table.number[at]];
      const PointTableView::Cell of_q = table.cell_of(q);
      const bool is_here = of_q.x == cell.x && of_q.y == cell.y && of_q.z == cell.z;  // not another's bucket
      count += is_here && dot(q - p, q - p) < reach * reach;
    }
  }
  return count;
}

}  // namespace

void check_crowding(uint64_t& bound, std::span<const Vec3> added,
                    const std::function<std::span<const Vec3>()>& present, float reach, const char* call) {
  PointTable table;
  table.fill(added, reach);
  if (bound + bound_of(table) <= most) {
    bound += bound_of(table);
    return;
  }
  const std::span<const Vec3> before = present();
  std::vector<Vec3> all(before.begin(), before.end());
  all.insert(all.end(), added.begin(), added.end());
  table.fill(all, reach);
  const uint64_t exact_bound = all.size() <= most ? 0 : bound_of(table);
  for (size_t i = 0; exact_bound > most && i < added.size(); ++i) {
    const uint64_t count = count_near(table.view(), all, added[i], reach);
    if (count <= most) continue;
    std::ostringstream why;
    why << call << " would put " << count << " particles within one support radius (" << reach << " m) of ("
        << added[i].x << ", " << added[i].y << ", " << added[i].z << "); at most " << most << " may be";
    throw Error(ErrorCode::capacity, why.str());
  }
  bound = std::min(most, bound_of(table));
}

}  // namespace meniscus
