// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The constraint set of ropes.
#pragma once

#include "cloth/rods/rod.h"
#include "cloth/rods/rope_kernels.h"
#include "pbd/substep.h"

namespace meniscus::cloth {

/// Ropes and linked chains, which have only a length: C = |x_b − x_a| − l between successive vertices, with
/// XPBD's compliance l/EA. Each iteration solves for all multipliers of a rope at once, in one thread for
/// each rope. So the stretch depends neither on the number of vertices nor on the number of iterations. A
/// load on a rope may weigh a million times as much as a vertex. A closed rope is cut at one place in an
/// iteration, and at the opposite place in the next.
template <class D>
class RopeSet final : public pbd::ConstraintSet<D> {
 public:
  explicit RopeSet(D& device) : device_(device) {}

  /// Replaces the model.
  void set_model(const RodModel& model);
  uint32_t segment_count() const { return segments_; }

  /// N, of each segment: the size of its force in the last substep.
  std::vector<float> tensions(uint32_t first, uint32_t count) const;

  void begin(pbd::Substep<D>& substep) override;
  void project(pbd::Substep<D>& substep, int iteration) override;
  void save() override;
  void restore() override;
  void visit_state(pbd::StateVisitor& v) {
    v.value("dt", dt_);
    v.array("pull", pull_.view(), segments_);
  }

 private:
  rope_kernels::RopeView view(const pbd::Substep<D>& substep);

  D& device_;
  uint32_t segments_ = 0, chains_ = 0;
  float dt_ = 0;  // s, of the last substep
  pbd::Buffer<RodChain> chain_{device_, "ropes"};
  pbd::Buffer<RodSegment> segment_{device_, "rope segments"};
  pbd::Buffer<float> start_{device_, "rope strains at the start"};
  pbd::Buffer<Vec3> multiplier_{device_, "rope multipliers"};
  pbd::Buffer<float> pull_{device_, "rope tensions"};
  pbd::Buffer<float> saved_pull_{device_, "saved rope tensions"};
  pbd::Buffer<rope_kernels::Row> row_{device_, "rope equations"};
};

}  // namespace meniscus::cloth
