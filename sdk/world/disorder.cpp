// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Chooses points and relaxes them.
#include "sdk/world/disorder.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "pbd/math/random.h"
#include "pbd/math/vec.h"
#include "sdk/world/tuning.h"

namespace meniscus {

namespace {

using world_tuning::relaxing_support;

/// The push of a pair at x_i − x_j = d, in spacings: Wendland's ∇W.
Vec3 push_of(Vec3 d) {
  const float r = length(d), q = r / relaxing_support, u = 1 - q;
  if (!(u > 0) || r < 1e-6f) return {0, 0, 0};
  constexpr float scale =
      210 / (3.14159265f * relaxing_support * relaxing_support * relaxing_support * relaxing_support);
  return (scale * q * u * u * u / r) * d;
}

/// Spreads the 21 low bits of x to every third bit.
uint64_t spread(uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffffull;
  x = (x | x << 16) & 0x1f0000ff0000ffull;
  x = (x | x << 8) & 0x100f00f00f00f00full;
  x = (x | x << 4) & 0x10c30c30c30c30c3ull;
  return (x | x << 2) & 0x1249249249249249ull;
}

/// One point of each group of cells that are adjacent in Morton's order. So each part of the volume has its
/// share.
std::vector<Vec3> choose_points(const FreeCells& c, float spacing) {
  std::vector<std::pair<uint64_t, Vec3>> free;
  for (int k = 0; k < c.nz; ++k) {
    for (int j = 0; j < c.ny; ++j) {
      for (int i = 0; i < c.nx; ++i) {
        if (!c.is[c.at(i, j, k)]) continue;
        const uint64_t code = spread(uint64_t(i)) | spread(uint64_t(j)) << 1 | spread(uint64_t(k)) << 2;
        free.push_back({code, c.centre(i, j, k)});
      }
    }
  }
  std::sort(free.begin(), free.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  const double volume = double(free.size()) * double{c.volume};
  const auto count = static_cast<size_t>(std::llround(volume / std::pow(double{spacing}, 3)));
  std::vector<Vec3> points;
  for (size_t n = 0; n < count; ++n) {
    const auto number = static_cast<uint32_t>(n);
    const double place =
        (double(n) + double{pbd::random_numbers(number, 0, 0).x}) * double(free.size()) / double(count);
    const Vec3 r = pbd::random_numbers(number, 1, 0);
    points.push_back(free[std::min(static_cast<size_t>(place), free.size() - 1)].second +
                     Vec3{c.size.x * (r.x - 0.5f), c.size.y * (r.y - 0.5f), c.size.z * (r.z - 0.5f)});
  }
  return points;
}

/// The push of all that is not free, at the centres of cells.
class Surroundings {
 public:
  Surroundings(const FreeCells& cells, float spacing) : c_(cells), push_(cells.is.size()) {
    std::vector<Offset> near;
    for (int k = -reach; k <= reach; ++k) {
      for (int j = -reach; j <= reach; ++j) {
        for (int i = -reach; i <= reach; ++i) {
          const Vec3 d =
              (-1 / spacing) * Vec3{c_.size.x * float(i), c_.size.y * float(j), c_.size.z * float(k)};
          const Vec3 push = (c_.size.x * c_.size.y * c_.size.z / (spacing * spacing * spacing)) * push_of(d);
          if (dot(push, push) > 0) near.push_back({i, j, k, push});
        }
      }
    }
    const std::vector<char> beside = beside_free();
    for (int k = 0; k < c_.nz; ++k) {
      for (int j = 0; j < c_.ny; ++j) {
        for (int i = 0; i < c_.nx; ++i) {
          if (!beside[c_.at(i, j, k)]) continue;
          for (const Offset& o : near) {
            if (!is_free(i + o.i, j + o.j, k + o.k)) push_[c_.at(i, j, k)] += o.push;
          }
        }
      }
    }
  }

  /// Linear between the centres of cells.
  Vec3 operator()(Vec3 p) const {
    const Vec3 x = p - c_.lower;
    const Vec3 at{x.x / c_.size.x - 0.5f, x.y / c_.size.y - 0.5f, x.z / c_.size.z - 0.5f};
    const int i = static_cast<int>(std::floor(at.x)), j = static_cast<int>(std::floor(at.y)),
              k = static_cast<int>(std::floor(at.z));
    const Vec3 f = at - Vec3{float(i), float(j), float(k)};
    Vec3 push{0, 0, 0};
    for (int corner = 0; corner < 8; ++corner) {
      const int a = corner & 1, b = corner >> 1 & 1, c = corner >> 2;
      const float weight = (a ? f.x : 1 - f.x) * (b ? f.y : 1 - f.y) * (c ? f.z : 1 - f.z);
      push += weight * push_[c_.at(i + a, j + b, k + c)];
    }
    return push;
  }

 private:
  struct Offset {
    int i, j, k;
    Vec3 push;
  };
  static constexpr int reach = 5;  // cells are at least .4 spacings long
  static_assert(reach < FreeCells::pad);

  bool is_free(int i, int j, int k) const {
    return i >= 0 && j >= 0 && k >= 0 && i < c_.nx && j < c_.ny && k < c_.nz && c_.is[c_.at(i, j, k)];
  }
  /// Cells that are free, or beside one that is.
  std::vector<char> beside_free() const {
    std::vector<char> beside(c_.is.size());
    for (int k = 1; k + 1 < c_.nz; ++k) {
      for (int j = 1; j + 1 < c_.ny; ++j) {
        for (int i = 1; i + 1 < c_.nx; ++i) {
          for (int n = 0; n < 27; ++n)
            beside[c_.at(i, j, k)] |= c_.is[c_.at(i + n % 3 - 1, j + n / 3 % 3 - 1, k + n / 9 - 1)];
        }
      }
    }
    return beside;
  }

  const FreeCells& c_;
  std::vector<Vec3> push_;  // in spacings
};

/// The neighbours of each point within `reach`.
class Near {
 public:
  void find(const FreeCells& c, const std::vector<Vec3>& points, float reach) {
    const auto along = [&](float x, float low) {
      return static_cast<size_t>(std::max(0.0f, (x - low) / reach));
    };
    const size_t nx = along(c.size.x * float(c.nx), 0) + 1, ny = along(c.size.y * float(c.ny), 0) + 1,
                 nz = along(c.size.z * float(c.nz), 0) + 1;
    const auto place = [&](Vec3 p) {
      return std::array{std::min(along(p.x, c.lower.x), nx - 1), std::min(along(p.y, c.lower.y), ny - 1),
                        std::min(along(p.z, c.lower.z), nz - 1)};
    };
    const auto bucket = [&](const std::array<size_t, 3>& a) { return a[0] + nx * (a[1] + ny * a[2]); };
    std::vector<uint32_t> first(nx * ny * nz + 1), number(points.size());
    for (Vec3 p : points) ++first[bucket(place(p)) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<uint32_t> next(first.begin(), first.end() - 1);
    for (size_t i = 0; i < points.size(); ++i) number[next[bucket(place(points[i]))]++] = uint32_t(i);
    start.assign(1, 0);
    other.clear();
    for (size_t i = 0; i < points.size(); ++i) {
      const auto [x, y, z] = place(points[i]);
      for (size_t n = 0; n < 27; ++n) {
        const std::array<size_t, 3> at{x + n % 3, y + n / 3 % 3, z + n / 9};  // one too far
        if (at[0] < 1 || at[1] < 1 || at[2] < 1 || at[0] > nx || at[1] > ny || at[2] > nz) continue;
        const size_t b = bucket({at[0] - 1, at[1] - 1, at[2] - 1});
        for (uint32_t m = first[b]; m < first[b + 1]; ++m) {
          if (number[m] != i && length(points[number[m]] - points[i]) < reach) other.push_back(number[m]);
        }
      }
      start.push_back(other.size());
    }
  }

  std::vector<size_t> start;    // by point, and one more
  std::vector<uint32_t> other;  // the neighbours
};

/// Moves every point by the pushes on it, but into no cell that is not free.
void relax_once(const FreeCells& cells, const Surroundings& surroundings, const Near& near, float spacing,
                std::vector<Vec3>& points) {
  using namespace world_tuning;
  std::vector<Vec3> moved = points;
  for (size_t i = 0; i < points.size(); ++i) {
    Vec3 push = surroundings(points[i]);
    for (size_t m = near.start[i]; m < near.start[i + 1]; ++m)
      push += push_of((1 / spacing) * (points[i] - points[near.other[m]]));
    Vec3 move = (relaxing_rate * relaxing_support * relaxing_support) * push;
    move = pbd::min(1.0f, relaxing_limit / pbd::max(length(move), 1e-6f)) * move;
    const Vec3 to = points[i] + spacing * move;
    if (cells.is_free(to)) moved[i] = to;
  }
  points.swap(moved);
}

}  // namespace

std::vector<Vec3> disordered_points(const FreeCells& cells, float spacing,
                                    const std::function<void(std::vector<Vec3>&)>& keep_out) {
  using namespace world_tuning;
  std::vector<Vec3> points = choose_points(cells, spacing);
  if (points.empty()) return points;
  const Surroundings surroundings(cells, spacing);
  Near near;
  for (int round = 0; round < relaxing_rounds; ++round) {
    // Within these rounds no point moves far enough to miss a neighbour that matters.
    if (round % rounds_of_a_list == 0) {
      if (round) keep_out(points);
      near.find(cells, points, (relaxing_support + rounds_of_a_list * relaxing_limit) * spacing);
    }
    relax_once(cells, surroundings, near, spacing, points);
  }
  keep_out(points);
  return points;
}

}  // namespace meniscus
