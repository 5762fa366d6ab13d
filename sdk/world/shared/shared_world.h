// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// One world over many ranks, each a process with a device.
#pragma once

#include <meniscus/world.h>

#include <vector>

#include "pbd/rank_exchange.h"
#include "pbd/ranks/ranks.h"

namespace meniscus {

/// The particles of one rank: read-outs of World, in an order of its own.
struct ParticlesOfRank {
  std::vector<ParticleId> ids;
  std::vector<Vec3> positions, velocities;
  std::vector<uint32_t> fluids;
  std::vector<float> density_errors, pressures;
  std::vector<DiffuseParticle> diffuse;
};

/// Shares a world. All ranks first build the same world by the same calls. Then each makes this object, which
/// keeps the particles in the region of its rank. Rank 0 leads: it calls steps and read-outs of its world,
/// which are those of all ranks. The others follow(). Calls that would change the world in another way throw
/// Error(invalid_argument) and name themselves.
///
/// A shared world has fluids without viscosity, solids, emitters, sinks, probes, diffuse particles and the
/// pressure grid. It has the same state, bit for bit, whatever the number of ranks. All ranks have all
/// bodies. Bodies, imposed emitters and the grid need fixed sums.
class SharedWorld {
 public:
  /// Throws Error(invalid_argument) and names what the world has and a shared one cannot have.
  static void check(const World& world);

  /// Call it for a new world that will be shared. Its particles stay on the host until then, so that a device
  /// gets those of its rank alone. A call that needs them earlier brings all of them to the device.
  static void hold_back(World& world);

  /// check() comes first. Throws Error(capacity) if the fluid has fewer than 3 layers of cells a rank, and no
  /// emitter makes more. Throws Error(invalid_argument) if pencils are asked for with the pressure grid.
  /// `world` may be moved meanwhile. It and `ranks` must outlive this.
  SharedWorld(World& world, pbd::Ranks& ranks, const pbd::CutPolicy& policy = {});
  /// On rank 0: ends the others' follow().
  ~SharedWorld();
  SharedWorld(const SharedWorld&) = delete;
  SharedWorld& operator=(const SharedWorld&) = delete;

  bool leads() const { return ranks_.rank() == 0; }
  /// The number of particles that this rank has at present.
  std::size_t own_particles() const;
  bool has_diffuse() const;
  /// On all ranks but 0: does what rank 0 asks for, until it destroys its SharedWorld or pauses. Returns
  /// whether it pauses.
  bool follow();
  /// On rank 0: the others' follow() returns. They must follow again before rank 0 calls its world.
  void pause();
  /// On all ranks at the same time, while none follows.
  ParticlesOfRank read_own_particles();

 private:
  std::vector<ParticleId> ids_of(const std::vector<uint32_t>& slots) const;

  World::Impl& world_;
  pbd::Ranks& ranks_;
};

}  // namespace meniscus
