// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The constraint set that makes the contacts of fluid with cloth act on the cloth.
#pragma once

#include <span>

#include "collision/fluid_cloth/fluid_cloth_contacts.h"
#include "collision/fluid_cloth/load.h"
#include "pbd/vertex_means.h"

namespace meniscus::collision {

/// Makes the contacts of fluid with cloth act on the cloth (see load.h). In an iteration
///
///   loading()   runs after the density constraint and before cloth's own: gives the vertices the impulses of
///               the contacts. At the substep's start it also adds the masses of the particles that press on
///               them;
///   carrying()  runs after cloth's constraints and before contacts are projected: moves the carried
///               particles.
///
/// Both must be registered in those places, and the set itself after all sets that move vertices. `settle`
/// then makes sure that no particle has passed through, and `end` transfers the impulses of restitution. The
/// transfer keeps impulses, so momentum is conserved.
template <class D>
class FluidClothSet final : public pbd::ConstraintSet<D>, public pbd::VertexMeans<D> {
 public:
  FluidClothSet(D& device, pbd::Particles& particles, FluidClothContacts<D>& contacts)
      : device_(device), particles_(particles), contacts_(contacts), loading_(*this), carrying_(*this) {}

  pbd::ConstraintSet<D>& loading() { return loading_; }
  pbd::ConstraintSet<D>& carrying() { return carrying_; }

  /// By vertex: inverse masses, 1/kg. `heaviest` is the largest mass of any vertex or particle, kg.
  void set_vertices(std::span<const float> inverse_masses, float heaviest);
  /// In a batch, those of the worlds; the view must stay valid.
  void set_gravities(const pbd::WorldGravities& gravities) { gravities_ = gravities; }
  /// Replaces the inverse masses of the vertices from `first` on.
  void weigh(uint32_t first, std::span<const float> inverse_masses) {
    if (self_weight_.size() > 0) self_weight_.write(inverse_masses, first);  // otherwise no cloth meets fluid
  }

  void start_step() override {
    contacts_.start_step();
    draws_before_ = draws_;
  }
  void undo_step() override { draws_ = draws_before_; }
  void visit_state(pbd::StateVisitor& v) {
    v.value("draws", draws_);
    v.array("vertex_weight", self_weight_.view(), self_weight_.size());  // water changes it
  }
  void project(pbd::Substep<D>&, int) override {}
  void settle(pbd::Substep<D>& substep) override;
  void end(pbd::Substep<D>& substep) override;
  uint32_t vertices() const override { return contacts_.any() ? contacts_.vertices() : 0; }
  void to_contacts(pbd::View<const pbd::Vec4> values, pbd::View<pbd::Vec4> means) override;
  void to_vertices(pbd::View<const pbd::Vec4> values, pbd::View<pbd::Vec4> sums, float unit) override;
  bool had_room() const override { return contacts_.had_room(); }
  void make_room() override { contacts_.make_room(); }

 private:
  struct Loading final : pbd::ConstraintSet<D> {
    explicit Loading(FluidClothSet& owner) : set(owner) {}
    void begin(pbd::Substep<D>& substep) override { set.start(substep); }
    void project(pbd::Substep<D>& substep, int) override { set.push_back(substep, false); }
    void settle(pbd::Substep<D>& substep) override { set.push_back(substep, true); }
    FluidClothSet& set;
  };
  struct Carrying final : pbd::ConstraintSet<D> {
    explicit Carrying(FluidClothSet& owner) : set(owner) {}
    void project(pbd::Substep<D>& substep, int) override { set.carry(substep); }
    FluidClothSet& set;
  };

  void start(pbd::Substep<D>& substep);
  void push_back(pbd::Substep<D>& substep, bool last);
  void carry(pbd::Substep<D>& substep);
  void pass(pbd::Substep<D>& substep);
  template <class Kernel>
  void at_particles(const char* name, const Kernel& kernel);
  template <class Kernel>
  void at_vertices(const char* name, const Kernel& kernel);
  fluid_cloth_kernels::AtTouches at_touches(const pbd::Substep<D>& substep);
  fluid_cloth_kernels::LoadedVertices loaded_vertices();

  D& device_;
  pbd::Particles& particles_;
  FluidClothContacts<D>& contacts_;
  Loading loading_;
  Carrying carrying_;
  uint32_t draws_ = 0, draws_before_ = 0;  // substeps; each draws the passing particles anew
  pbd::WorldGravities gravities_{};
  float unit_ = 0;  // kg or kg·m: unit of the integers in which sums run
  pbd::Buffer<float> self_weight_{device_, "vertex masses"}, loaded_{device_, "loaded vertices"};
  pbd::Buffer<pbd::Vec4> change_{device_, "vertex changes"};
};

}  // namespace meniscus::collision
