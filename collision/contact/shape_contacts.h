// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The source of contacts between particles and shapes, fixed and moving.
#pragma once

#include "collision/contact/candidates.h"
#include "collision/contact/tuning.h"
#include "pbd/substep.h"

namespace meniscus::collision {

/// What a particle collides with, and the contact radius at which its centre stops, m.
struct Touch {
  CollisionFilter filter;
  float radius;
};

namespace shape_contact_kernels {

/// The distance (m) by which an overlapping particle leaves a solid in a substep. If it left at once, it
/// would get the speed of that displacement.
MENISCUS_HD inline float exit_distance(float contact_radius, float dt) {
  return contact_radius * dt / shape_tuning::exit_time;
}

/// How a particle collides with solids, by its fluid or its piece of cloth. A vertex does not collide with
/// the body that it is attached to.
struct Touches {
  pbd::View<const pbd::Phase> phase;
  pbd::View<const CollisionFilter> by_fluid;
  pbd::View<const Touch> by_piece;
  float fluid_radius;
  pbd::View<const uint32_t> attached_body;  ///< by vertex; no_index where it is attached to none
  uint32_t sorted = 0;                      ///< see ParticleView

  MENISCUS_HD Touch of(uint32_t i) const {
    if (by_piece.count && is_vertex(i)) return by_piece[pbd::phase_group(phase[i])];
    return {by_fluid.count ? by_fluid[pbd::phase_group(phase[i])] : CollisionFilter{}, fluid_radius};
  }
  MENISCUS_HD bool is_vertex(uint32_t i) const { return (phase[i] & pbd::phase_vertex) != 0; }
  MENISCUS_HD bool is_face(uint32_t i) const { return by_piece.count && (phase[i] & pbd::phase_face) != 0; }
  MENISCUS_HD bool may_overlap(uint32_t i) const { return (phase[i] & pbd::phase_overlapping) != 0; }
  /// The body that i is attached to, or no_index.
  MENISCUS_HD uint32_t body_of(uint32_t i) const {
    return i >= sorted && i - sorted < attached_body.count ? attached_body[i - sorted] : pbd::no_index;
  }
};

}  // namespace shape_contact_kernels

/// Finds the contacts of particles with shapes, fixed and moving.
template <class D>
class ShapeContacts final : public pbd::ContactSource<D> {
 public:
  ShapeContacts(D& device, pbd::Particles& particles, float support_radius, float contact_radius)
      : device_(device),
        particles_(particles),
        support_radius_(support_radius),
        contact_radius_(contact_radius),
        largest_radius_(contact_radius),
        candidates_(device),
        filters_(device, "fluid filters"),
        pieces_(device, "cloth surfaces") {}

  /// The views must stay valid until the next call.
  void set_shapes(const ShapeSet& shapes, bool fixed_are_planes);
  /// One filter a fluid.
  void set_filters(std::span<const CollisionFilter> filters);
  /// One filter a fluid, or empty where all collide with everything. Valid until the next set_filters().
  pbd::View<const CollisionFilter> filters() const { return filters_.view(); }
  /// One entry a piece of cloth.
  void set_pieces(std::span<const Touch> pieces);
  /// By vertex: the body that it is attached to, or no_index. Must stay valid until the next call.
  void set_attached_bodies(pbd::View<const uint32_t> bodies) { attached_body_ = bodies; }

  void reserve(uint32_t particles) override;
  bool any() const override { return shapes_.shapes.count > 0; }
  bool any_moving() const override { return shapes_.fixed < shapes_.shapes.count; }
  bool any_but_fixed_planes() const { return !only_fixed_planes() && any(); }
  bool limits_motion() const override { return shapes_.fixed > 0 && !fixed_are_planes_; }
  void limit_motion(const pbd::MotionView& motion, bool planes_too) override;
  void count(const pbd::Substep<D>& substep, const pbd::ContactCounter& counter) override;
  bool counts_all() const override { return any(); }
  void fill(const pbd::Substep<D>& substep, const pbd::ContactWriter& writer) override;

  /// Rolls back motions that have passed through a moving shape since the substep began. Shapes are at their
  /// final poses, and have moved by `furthest` (m) at most. A particle may be carried that far, and meet
  /// another shape there.
  void limit_beside_moving(const pbd::MotionView& motion, float furthest);
  shape_contact_kernels::Touches touches(pbd::View<const pbd::Phase> phase, uint32_t sorted) const {
    return {phase, filters_.view(), pieces_.view(), contact_radius_, attached_body_, sorted};
  }
  /// Finds the shapes that are within `reach` (m) of the particles' positions.
  CandidateView find_near(pbd::View<const pbd::Vec4> position, uint32_t particles, float reach);

  const ShapeSet& shapes() const { return shapes_; }
  /// The largest contact radius of all fluids and pieces of cloth, m.
  float largest_radius() const { return largest_radius_; }

 private:
  template <bool only_fixed_planes>
  auto finder(const pbd::Substep<D>& substep) const;
  /// A tank with nothing in it, which is common: its kernels need a third of the registers.
  bool only_fixed_planes() const { return fixed_are_planes_ && !any_moving(); }

  D& device_;
  pbd::Particles& particles_;
  float support_radius_, contact_radius_, largest_radius_;
  ShapeSet shapes_;
  bool fixed_are_planes_ = true;
  uint32_t room_ = 0;  // particles
  Candidates candidates_;
  pbd::Buffer<CollisionFilter> filters_;
  pbd::Buffer<Touch> pieces_;
  pbd::View<const uint32_t> attached_body_;
};

}  // namespace meniscus::collision
