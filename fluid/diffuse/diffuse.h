// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Spray, foam and bubbles: particles of mixed air and water, too small for the solver. The fluid moves them,
// and they have no effect on it (Ihmsen, Akinci, Akinci & Teschner 2012). A fluid particle creates
//   n = (k_ta Φ(I_ta) + k_wc Φ(I_wc)) Φ(I_k) Δt       (eq. 8)
// diffuse particles, where Φ rises from 0 to 1 over a range, and
//   I_ta = Σ |v_ij| (1 − v̂_ij · x̂_ij) w               trapped air (eq. 2), m/s
//   I_wc = Σ (1 − n_i · n_j) w over x̂_ji · n_i < 0     wave crests (eqs. 4 to 6), where v̂_i · n_i > 0.6
//   I_k  = v²/2                                        J/kg
// The amount of fluid around a diffuse particle determines its kind: spray, which flies; foam, which moves
// with the fluid; or a bubble, which rises (eqs. 9 to 13). Departures from the paper: the weights w = 1 − r/h
// are divided by their sum inside a fluid, and energy is per mass. So the ranges have the same meaning at
// every resolution. All kinds age. n is rounded up or down at random, in proportion to its fraction.
#pragma once

#include <meniscus/defs.h>
#include <meniscus/outputs.h>

#include <compare>
#include <functional>
#include <utility>
#include <vector>

#include "pbd/substep.h"

namespace meniscus::fluid {

struct DiffuseParameters {
  DiffuseDef def;
  float support = 0;      ///< h, m
  float radius = 0;       ///< m, the radius around a fluid particle in which it creates others
  float full_weight = 1;  ///< Σ w inside a fluid
  Vec3 gravity{0, 0, 0};  ///< m/s²
};

DiffuseParameters diffuse_parameters(const DiffuseDef& def, float spacing, float support, Vec3 gravity);

/// The next state, within a step that has not ended.
struct PendingDiffuse {
  pbd::View<DiffuseParticle> particles;  ///< as many as the capacity
  pbd::View<const uint32_t> count;       ///< one element, on the device: the number of particles
};

/// The order of the particles in a world alone: by the step of their birth, then by the slot that the fluid
/// particle had which created them, then by their turn.
struct DiffuseKey {
  uint32_t step, slot, turn;

  auto operator<=>(const DiffuseKey&) const = default;
};

/// Advances the particles in a step's last substep. New particles count once the step is accepted.
///
/// In a world that ranks share, each has the particles in its region.
template <class D>
class Diffuse final : public pbd::Observer<D> {
 public:
  Diffuse(D& device, const DiffuseParameters& parameters);

  /// Sets the function that keeps them out of solids. It runs after they have moved and new ones were
  /// created.
  void set_walls(std::function<void(const PendingDiffuse&)> walls) { walls_ = std::move(walls); }

  void set_gravity(Vec3 gravity) { parameters_.gravity = gravity; }

  void start_step() override { elapsed_ = 0; }
  void observe(const pbd::Substep<D>& substep) override;
  /// Accepts the step.
  void accept();
  void visit_state(pbd::StateVisitor& v) {
    v.value("count", is_shared_ ? all_count_ : count_);
    v.value("refused", refused_);
    v.value("step", step_);
    v.array("particle", is_shared_ ? gathered_.view() : present_.view(), count());
    any_pending_ = false;
  }

  uint32_t count() const { return is_shared_ ? all_count_ : count_; }  ///< of all ranks
  uint32_t refused() const { return refused_; }  ///< in the last step, beyond the capacity
  void read(std::span<DiffuseParticle> out) const { present_.read(out); }

  /// From now on ranks share the world. Keeps the particles for which owns(position) is true.
  void share(const std::function<bool(Vec3)>& owns);
  struct Own {
    DiffuseKey key;
    DiffuseParticle particle;
  };
  std::vector<Own> read_own() const;
  /// In a shared world: what visit_state() takes for the particles of all ranks.
  void set_gathered(std::span<const DiffuseParticle> particles);

 private:
  void reserve(uint32_t particles);
  void move(const pbd::Substep<D>& substep);
  void make(const pbd::Substep<D>& substep);
  uint32_t exchange_particles(const pbd::Substep<D>& substep);
  bool is_shared() const { return is_shared_; }
  void agree_on_births(const pbd::Substep<D>& substep);
  void limit_births(const pbd::Substep<D>& substep, uint64_t room);
  std::vector<pbd::WordArray> carried();

  D& device_;
  DiffuseParameters parameters_;
  std::function<void(const PendingDiffuse&)> walls_;
  uint32_t count_ = 0, refused_ = 0, step_ = 0;
  float elapsed_ = 0;  // s, in the present step
  bool any_pending_ = false;
  bool is_shared_ = false;
  uint32_t candidates_ = 0;  // in the present step: present particles and those of other ranks
  uint32_t all_count_ = 0, next_all_count_ = 0, next_refused_ = 0;  // of all ranks
  pbd::Buffer<DiffuseParticle> present_{device_, "spray, foam and bubbles"};
  pbd::Buffer<DiffuseParticle> moved_{device_, "spray, foam and bubbles"};
  pbd::Buffer<DiffuseParticle> next_{device_, "spray, foam and bubbles"};
  pbd::Buffer<uint32_t> alive_{device_, "living foam"};
  pbd::Buffer<uint32_t> place_{device_, "places of foam"};
  pbd::Buffer<pbd::Vec4> normal_{device_, "surface normals"};  // w: I_ta
  pbd::Buffer<uint32_t> born_{device_, "new foam"};
  pbd::Buffer<uint32_t> birth_place_{device_, "places of new foam"};
  pbd::Buffer<uint32_t> totals_{device_, "foam counts"};
  // In a shared world.
  pbd::Buffer<DiffuseKey> keys_{device_, "order of foam"}, next_keys_{device_, "order of foam"};
  pbd::Buffer<DiffuseParticle> gathered_{device_, "foam of all ranks"};
};

}  // namespace meniscus::fluid
