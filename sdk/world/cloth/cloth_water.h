// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Fluid that a piece of cloth holds, by vertex: how it is absorbed, runs down and drips. Fluid that moves
// takes its momentum along.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "sdk/world/cloth/cloth_table.h"

namespace meniscus {

/// Three sums in double precision.
struct MomentumSum {
  double x = 0, y = 0, z = 0;

  void add(double mass, const MomentumSum& velocity) {
    x += mass * velocity.x;
    y += mass * velocity.y;
    z += mass * velocity.z;
  }
};

/// One step of a piece's water. The host must have the piece's latest state. finish() writes the result back.
class ClothWater {
 public:
  /// `held`: vertices that nothing moves; fluid that they take comes to rest.
  ClothWater(ClothEntry& entry, double particle_mass, std::vector<bool> held);

  /// Absorbs a particle at a vertex if the surrounding cloth has room for it; returns whether it did.
  bool take(uint32_t vertex, Vec3 velocity);
  /// Moves surplus down along the edges; `down` is a unit vector.
  void run_down(Vec3 down, double dt);
  /// Vertices from which a drop can leave now, the lowest first.
  std::vector<uint32_t> dripping(Vec3 down);
  /// Releases a drop from there if there is still enough fluid around; returns its velocity, m/s.
  std::optional<Vec3> drip(uint32_t vertex);
  /// Updates the masses and velocities of the vertices. Returns whether any has changed.
  bool finish();

 private:
  struct Part {
    uint32_t vertex;
    double mass;
  };
  template <class Available>
  std::vector<Part> gather(uint32_t vertex, const Available& available);
  double capacity(uint32_t v) const;
  double kept(uint32_t v) const;
  double surplus(uint32_t v) const { return std::max(0.0, water_[v] - kept(v)); }
  double mass(uint32_t v) const { return dry_[v] + water_[v]; }
  MomentumSum velocity(uint32_t v) const;
  void add(uint32_t v, double mass, const MomentumSum& velocity);
  void move(uint32_t from, uint32_t to, double mass);

  ClothEntry& entry_;
  const double particle_;
  const std::vector<float>& dry_;
  std::vector<double>& water_;
  std::vector<bool> held_;
  double reach_;                       // m, along the cloth: how far one particle spreads at most
  std::vector<double> open_;           // by vertex: the fraction of its pores that strain leaves open
  std::vector<MomentumSum> momentum_;  // by vertex
  std::vector<double> way_;            // by vertex: distance along the cloth, for gather
  bool changed_ = false;
};

/// Makes the graph of each vertex's neighbours along edges.
VertexGraph make_graph(const cloth::ClothMesh& mesh);

}  // namespace meniscus
