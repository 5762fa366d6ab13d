// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The constraint set of contacts with Coulomb friction among grains.
#pragma once

#include <span>

#include "collision/contact/contact_set.h"
#include "collision/grains/rows.h"
#include "collision/grains/tuning.h"
#include "pbd/chebyshev.h"
#include "pbd/device/shared_buffer.h"
#include "pbd/restorable_buffer.h"
#include "pbd/substep.h"

namespace meniscus::collision {

namespace grain_kernels {
struct GrainState;
}

/// Properties of one group of particles, for contacts among grains.
struct GrainMaterial {
  bool is_grain = false;
  float friction = 0;  ///< Coulomb's μ of a contact
};

/// The μ of contacts with which a heap comes to rest at this slope. Measured on columns of about 2000 grains
/// that collapse: tan φ = 0.18 + 1.4 μ for μ up to 0.3, and 0.17 for frictionless grains.
constexpr float contact_friction(float slope) {
  return slope > grain_tuning::frictionless_slope
             ? (slope - grain_tuning::frictionless_slope) / grain_tuning::slope_of_friction
             : 0.0f;
}

/// Contacts with Coulomb friction among grains. Grains are balls of one diameter d that do not rotate
/// (Macklin et al. 2014, section 6.1).
///
///   normal    C = |x_i − x_j| − d ≥ 0
///   friction  the substep's slip along the contact is taken back, up to μ times the normal load
///
/// Departures from the paper:
/// - A contact's impulse is accumulated over the substep, as a vector, and kept in the friction cone. So an
///   iteration can take back what an earlier one overdid. One μ serves at rest and in motion.
/// - A grain is split among its constraints and not averaged over them (mass splitting, Tonge, Benevolenski &
///   Voroshilov 2012): Δp = −(C n + slip)/(n_i w_i + n_j w_j), where n_i contacts press on i. The impulses on
///   both grains of a pair are equal and opposite, so momentum is conserved. The spectrum is bounded by 1, as
///   Chebyshev's weights need.
/// - The solve starts from the impulses of the last substep. So a pile at rest is solved over many substeps.
///   The paper makes grains lighter with their height instead, which does not conserve momentum.
/// - Overlaps from before the substep are removed slowly. Removed within one substep, they would throw grains
///   apart.
template <class D>
class GrainSet final : public pbd::ConstraintSet<D> {
 public:
  /// `diameter` of all grains, m. `contacts` solves the contacts with solids.
  GrainSet(D& device, float diameter, ContactSet<D>& contacts);

  /// One entry for each group of the particles' phases.
  void set_materials(std::span<const GrainMaterial> materials);
  /// s, of the substep that left its impulses; 0: there was none.
  float last_substep() const { return last_dt_; }
  void set_last_substep(float seconds) { last_dt_ = seconds; }

  void reserve(uint32_t capacity, uint32_t kept) override;
  void clear(uint32_t first, uint32_t count) override;
  void reorder(pbd::View<const uint32_t> order, uint32_t count) override;
  void save() override;
  void restore() override;
  void visit_state(pbd::StateVisitor& v);
  void keep_world(uint32_t each) override;
  void reset_worlds(const pbd::ChosenWorlds& worlds) override;
  void undo_worlds(const pbd::ChosenWorlds& worlds) override;
  /// Visits the grains of one world of a batch, or of a world alone.
  void visit_world(pbd::StateVisitor& v, uint32_t world, uint32_t each);

  void begin(pbd::Substep<D>& substep) override;
  void project(pbd::Substep<D>& substep, int iteration) override;

  bool had_room() const override { return longest_row() <= row_capacity_; }
  void make_room() override;

 private:
  static constexpr uint32_t block = D::interleaves_lists ? 32 : 1;  // see GrainRows
  void reserve_arrays(uint32_t kept);
  void reserve_rows(uint32_t kept);
  void lengthen_rows(uint32_t capacity);
  grain_kernels::GrainState current_state();
  grain_kernels::GrainState kept_state();
  void pack_world(uint32_t first, uint32_t each, const grain_kernels::GrainState& to);
  GrainRows current_rows();
  GrainRows next_rows();
  uint32_t longest_row() const { return found_.host().empty() ? 0 : found_.host()[0]; }

  D& device_;
  float diameter_;
  ContactSet<D>& contacts_;
  bool any_ = false;  // whether there may be grains
  pbd::Chebyshev chebyshev_;
  float last_dt_ = 0, saved_dt_ = 0;
  uint32_t capacity_ = 0;       // in particles
  uint32_t row_capacity_ = 16;  // a grain of a dense pile has about 12 contacts

  pbd::Buffer<float> roughness_{device_, "grain materials"};
  pbd::RestorableBuffer<uint32_t> partner_{device_, "grain contacts"};
  pbd::RestorableBuffer<pbd::Vec4> impulse_{device_, "grain contact impulses"};
  pbd::RestorableBuffer<uint32_t> count_{device_, "grain contact counts"};
  pbd::RestorableBuffer<uint32_t> origin_{device_, "grain origins"};
  pbd::Buffer<pbd::Vec4> change_{device_, "grain contact changes"};
  pbd::Buffer<pbd::Vec4> staged_{device_, "staged grains"};
  pbd::Buffer<float> pressing_{device_, "pressed grains"};
  pbd::Buffer<uint32_t> longest_{device_, "longest row of grain contacts"};
  pbd::SharedBuffer<uint32_t> found_{device_, "longest row of grain contacts"};  // for the host

  // Of a batch: the grains to which worlds are reset.
  uint32_t kept_row_capacity_ = 0;
  pbd::Buffer<uint32_t> kept_partner_{device_, "kept grains"}, kept_count_{device_, "kept grains"},
      kept_origin_{device_, "kept grains"};
  pbd::Buffer<pbd::Vec4> kept_impulse_{device_, "kept grains"};
};

}  // namespace meniscus::collision
