// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The constraint set of Cosserat rods.
#pragma once

#include <span>
#include <vector>

#include "cloth/rods/rod.h"
#include "cloth/rods/rod_kernels.h"
#include "pbd/substep.h"

namespace meniscus::cloth {

/// Cosserat rods (Kugelstadt & Schömer 2016, "Position and Orientation Based Cosserat Rods"). A segment
/// between vertices a and b has a frame q with axes d₁, d₂, d₃. Two successive segments form a joint:
///
///   stretch and shear   C = x_b − x_a − l d₃   energy ½ (EA C₃² + κGA (C₁² + C₂²))/l, along the axes
///   bending and twist   C = θ − θ₀             energy ½ (EI (C₁² + C₂²) + GJ C₃²)/l
///
/// θ is the rotation vector from a frame to the next one. The paper has 2 Im(q̄ q₊) instead. The two agree to
/// first order, and θ stays exact at large bending and twist.
///
/// Each iteration solves all constraints of a rod at once, with XPBD's compliance. The system of their
/// multipliers is a band matrix (Deul, Kugelstadt, Weiler & Bender 2018, "Direct Position-Based Solver for
/// Stiff Rods"), solved by one thread for each rod. So the stiffness depends neither on the resolution nor on
/// the number of iterations. A closed rod is cut at one place in an iteration, and at the opposite place in
/// the next.
///
/// A held segment is rigid, so that a rod bends from the end of that segment on. To clamp the end of a rod,
/// hold a first segment and both of its vertices. The torque ω × Iω of the section's own inertia is omitted.
template <class D>
class RodSet final : public pbd::ConstraintSet<D> {
 public:
  explicit RodSet(D& device) : device_(device) {}

  /// Replaces the model. Segments that existed before keep their state.
  void set_model(const RodModel& model);
  uint32_t segment_count() const { return segments_; }

  std::vector<SegmentState> states(uint32_t first, uint32_t count) const;
  void set_states(uint32_t first, std::span<const SegmentState> states);
  /// Sets all spins to 0.
  void stop();

  /// N·m, of each segment, in the world's axes: the torque on it in the last substep, from its joints and
  /// from the forces at its ends. A held segment must be held against this torque.
  std::vector<Vec3> torques(uint32_t first, uint32_t count) const;

  void predict(float dt) override;
  void begin(pbd::Substep<D>& substep) override;
  void project(pbd::Substep<D>& substep, int iteration) override;
  void end(pbd::Substep<D>& substep) override;
  void save() override;
  void restore() override;
  void visit_state(pbd::StateVisitor& v);

 private:
  rod_kernels::RodView view(const pbd::Substep<D>& substep);

  D& device_;
  uint32_t segments_ = 0, chains_ = 0;
  float dt_ = 0;  // s, of the last substep
  pbd::Buffer<RodChain> chain_{device_, "rods"};
  pbd::Buffer<RodSegment> segment_{device_, "rod segments"};
  pbd::Buffer<pbd::Vec4> frame_{device_, "rod frames"};
  pbd::Buffer<pbd::Vec4> spin_{device_, "rod spins"};
  pbd::Buffer<pbd::Vec4> previous_{device_, "rod frames of before"};
  pbd::Buffer<pbd::Vec4> saved_frame_{device_, "saved rod frames"};
  pbd::Buffer<pbd::Vec4> saved_spin_{device_, "saved rod spins"};
  pbd::Buffer<rod_kernels::Strain> start_{device_, "rod strains at the start"};
  pbd::Buffer<rod_kernels::Strain> multiplier_{device_, "rod multipliers"};
  pbd::Buffer<rod_kernels::Link> link_{device_, "rod links"};
  pbd::Buffer<BandRow> row_{device_, "rod equations"};
  pbd::Buffer<pbd::Vec4> torque_{device_, "rod torques"};
  pbd::Buffer<float> pull_{device_, "rod tensions"};
  pbd::Buffer<float> saved_pull_{device_, "saved rod tensions"};
};

}  // namespace meniscus::cloth
