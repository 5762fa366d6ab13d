// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Measures neighbourhoods of particles on the host.
#include "sdk/cli/evidence/particle_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "pbd/math/vec.h"

namespace meniscus::cli {
namespace {

using Cell = std::array<int32_t, 3>;

/// Particles sorted by the cubic cell that they are in.
class CellList {
 public:
  CellList(std::span<const Vec3> positions, float cell_size) : positions_(positions), size_(cell_size) {
    for (uint32_t i = 0; i < positions.size(); ++i) entries_.push_back({cell_of(positions[i]), i});
    std::sort(entries_.begin(), entries_.end());
  }

  /// Calls use(j) for all others in the cells around that of particle i.
  template <class Use>
  void for_each_near(uint32_t i, const Use& use) const {
    const Cell centre = cell_of(positions_[i]);
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {  // the three cells along z stand in a row
        const Entry low{{centre[0] + dx, centre[1] + dy, centre[2] - 1}, 0};
        const Entry high{{centre[0] + dx, centre[1] + dy, centre[2] + 2}, 0};
        for (auto e = std::lower_bound(entries_.begin(), entries_.end(), low);
             e != entries_.end() && *e < high; ++e) {
          if (e->second != i) use(e->second);
        }
      }
    }
  }

 private:
  using Entry = std::pair<Cell, uint32_t>;

  Cell cell_of(Vec3 p) const {
    const auto index = [&](float x) { return static_cast<int32_t>(std::floor(x / size_)); };
    return {index(p.x), index(p.y), index(p.z)};
  }

  std::span<const Vec3> positions_;
  float size_;
  std::vector<Entry> entries_;
};

constexpr int fewest_for_a_curl = 8;

}  // namespace

std::vector<float> nearest_distances(std::span<const Vec3> positions, float reach) {
  const CellList cells(positions, reach);
  std::vector<float> nearest(positions.size(), reach);
  for (uint32_t i = 0; i < positions.size(); ++i) {
    cells.for_each_near(
        i, [&](uint32_t j) { nearest[i] = std::min(nearest[i], length(positions[j] - positions[i])); });
  }
  return nearest;
}

std::vector<Vec3> vorticity_of(std::span<const Vec3> positions, std::span<const Vec3> velocities,
                               float reach) {
  const CellList cells(positions, reach);
  std::vector<Vec3> curls(positions.size(), Vec3{0, 0, 0});
  for (uint32_t i = 0; i < positions.size(); ++i) {
    Vec3 sum{0, 0, 0};
    float moment = 0;
    int count = 0;
    cells.for_each_near(i, [&](uint32_t j) {
      const Vec3 x = positions[j] - positions[i];
      const float r = length(x);
      if (r >= reach) return;
      const float weight = (1 - r / reach) * (1 - r / reach);
      sum = sum + weight * cross(x, velocities[j] - velocities[i]);
      moment += weight * r * r;
      ++count;
    });
    if (count >= fewest_for_a_curl && moment > 0) curls[i] = (3 / moment) * sum;
  }
  return curls;
}

}  // namespace meniscus::cli
