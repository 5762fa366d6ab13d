// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The test that ends the density iterations of a substep on the device.
#pragma once

#include "fluid/density/iteration_end.h"
#include "pbd/substep.h"

namespace meniscus::fluid {

/// Ends a substep's density iterations when the mean of max(C, 0) over all fluid particles is at most a
/// tolerance: see IterationEnd.
///
/// An iteration first computes C from the positions of the previous one, so the test costs half an iteration.
/// Until the end, Multiplier::relieved holds C, and its usual value is stored here.
template <class D>
class DensityStop {
 public:
  explicit DensityStop(D& device) : device_(device), end_(device) {}

  void reserve(uint32_t size) { start_.resize_discard(size); }
  void start_step() { end_.start_step(); }

  template <class Kernel>
  density_kernels::UnlessEnded<Kernel> unless_ended(const Kernel& kernel) const {
    return end_.unless_ended(kernel);
  }
  bool is_over() const { return end_.is_over(); }

  /// Call it when the multipliers of the first iteration are known, before it tests the convergence.
  void start_substep(const pbd::Substep<D>& substep, pbd::View<density_kernels::Multiplier> multiplier) {
    device_.parallel_for("density/start", substep.particles.sorted,
                         density_kernels::KeepStart{multiplier, start_.view()});
  }
  /// Call it when the multipliers of an iteration are known, and have not moved any particle.
  void test_convergence(const pbd::Substep<D>& substep, pbd::View<density_kernels::Multiplier> multiplier,
                        float tolerance, bool may_end) {
    using namespace density_kernels;
    end_.test(substep.particles.sorted,
              MeanError{multiplier, substep.particles.phase, end_.progress(), device_.fixes_sums()},
              AddErrors{}, tolerance, may_end);
  }

  /// Call it when all iterations have been launched.
  void finish(const pbd::Substep<D>& substep, pbd::View<density_kernels::Multiplier> multiplier,
              pbd::View<const float> increment, density_kernels::Recorded recorded) {
    using namespace density_kernels;
    device_.parallel_for("density/finish", substep.particles.sorted,
                         Finish{multiplier, increment, start_.view(), end_.progress(), recorded});
    end_.finish();
  }

  uint32_t iterations() const { return end_.iterations(); }

 private:
  D& device_;
  pbd::Buffer<float> start_{device_, "density errors"};
  IterationEnd<D> end_;
};

}  // namespace meniscus::fluid
