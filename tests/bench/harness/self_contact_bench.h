// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cloth that meets cloth on one device, with the device's type hidden: a solver with contacts, and the
// plainest fabric there is.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "cloth/self_contact/self_contacts.h"
#include "pbd/device/device.h"

namespace meniscus::tests {

using TriangleCorners = std::array<uint32_t, 3>;

struct ClothCase {
  std::vector<pbd::Vec4> vertices;  ///< m; w: inverse mass
  std::vector<Vec3> velocities;     ///< m/s
  std::vector<Vec3> rest;           ///< m
  std::vector<pbd::SurfaceTriangle> triangles;
  std::vector<cloth::ContactPiece> pieces;
  Vec3 gravity{0, 0, 0};
  int substeps = 5, iterations = 4;
  bool keeps_edges = true;  ///< at their lengths at rest

  /// Adds a grid of columns × rows vertices, all of the same mass (kg), whose vertex (u, v) of the rest plane
  /// stands at shape(u, v).
  template <class Shape>
  void add_sheet(int columns, int rows, float spacing, float mass, const cloth::ContactPiece& piece,
                 const Shape& shape, Vec3 velocity = {0, 0, 0}) {
    const auto first = static_cast<uint32_t>(vertices.size()), number = static_cast<uint32_t>(pieces.size());
    pieces.push_back(piece);
    for (int n = 0; n < columns * rows; ++n) {
      const float u = spacing * (float(n % columns) - 0.5f * float(columns - 1));
      const float v = spacing * (float(n / columns) - 0.5f * float(rows - 1));
      vertices.push_back(pbd::with_w(shape(u, v), 1 / mass));
      velocities.push_back(velocity);
      rest.push_back({u, 0, v});
    }
    for (int c = 0; c + 1 < columns; ++c) {
      for (int r = 0; r + 1 < rows; ++r) {
        const uint32_t a = first + uint32_t(r * columns + c), b = a + 1, d = a + uint32_t(columns), e = d + 1;
        const bool even = (c + r) % 2 == 0;
        triangles.push_back({a, d, even ? e : b, number});
        triangles.push_back({even ? a : b, even ? e : d, even ? b : e, number});
      }
    }
  }
};

class SelfContactBench {
 public:
  virtual ~SelfContactBench() = default;

  virtual void step(float dt) = 0;
  virtual std::vector<Vec3> positions() = 0;
  virtual std::vector<Vec3> velocities() = 0;
  virtual uint32_t most_contacts() = 0;
  virtual uint32_t most_candidates() = 0;
  virtual uint32_t most_crossings() = 0;
  virtual uint32_t given_up() = 0;
  virtual uint32_t listings() = 0;
  virtual uint32_t one_substep_listings() = 0;
  /// For each box, the triangles whose swept boxes, widened by `reach`, overlap it, in ascending order. One
  /// thread or one warp searches for them.
  virtual std::vector<std::vector<uint32_t>> overlaps(std::span<const pbd::Vec4> from,
                                                      std::span<const pbd::Vec4> to, float reach,
                                                      std::span<const Aabb> boxes, bool in_warps) = 0;
};

std::unique_ptr<SelfContactBench> make_cpu_self_contact_bench(const ClothCase& cloth, int threads = 0);
std::unique_ptr<SelfContactBench> make_cuda_self_contact_bench(const ClothCase& cloth);

inline std::unique_ptr<SelfContactBench> make_self_contact_bench(pbd::DeviceKind kind,
                                                                 const ClothCase& cloth) {
#if MENISCUS_HAS_CUDA
  if (kind == pbd::DeviceKind::cuda) return make_cuda_self_contact_bench(cloth);
#endif
  return kind == pbd::DeviceKind::cpu ? make_cpu_self_contact_bench(cloth) : nullptr;
}

}  // namespace meniscus::tests
