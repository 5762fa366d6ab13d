// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The test that ends the density iterations of a substep on the device.
#pragma once

#include "fluid/density/stop_kernels.h"
#include "pbd/device/shared_buffer.h"
#include "pbd/substep.h"

namespace meniscus::fluid {

/// Ends a substep's density iterations when the mean of max(C, 0) over all fluid particles is at most a
/// tolerance. The device decides. The host continues to launch until it learns of the end, and superfluous
/// launches return at once.
///
/// An iteration first computes C from the positions of the previous one, so the test costs half an iteration.
/// Until the end, Multiplier::relieved holds C, and its usual value is stored here.
template <class D>
class DensityStop {
 public:
  explicit DensityStop(D& device) : device_(device) {
    progress_.resize_discard(1);
    sum_.resize_discard(1);
    progress_.fill(0);
    done_.resize_discard(1);
    ended_.resize_discard(1);
    ended_.host()[0] = 0;
    start_step();
  }

  void reserve(uint32_t size) { start_.resize_discard(size); }
  void start_step() {
    device_.parallel_for("density/begin", 1, density_kernels::Begin{progress_.view()});
    ++number_;
    done_.host()[0] = 0;
  }

  /// Wraps a kernel, so that it does nothing once the iterations have ended.
  template <class Kernel>
  density_kernels::UnlessEnded<Kernel> unless_ended(const Kernel& kernel) const {
    return {progress_.view(), kernel};
  }

  /// Whether the host knows that this substep's iterations have ended, so that no more launches are needed.
  /// The moment varies from run to run, without an effect on the results.
  bool is_over() const { return *static_cast<const volatile uint32_t*>(ended_.host().data()) == number_; }

  /// Call it when the multipliers of the first iteration are known, before it tests the convergence.
  void start_substep(const pbd::Substep<D>& substep, pbd::View<density_kernels::Multiplier> multiplier) {
    device_.parallel_for("density/start", substep.particles.sorted,
                         density_kernels::KeepStart{multiplier, start_.view()});
  }
  /// Call it when the multipliers of an iteration are known, and have not moved any particle.
  void test_convergence(const pbd::Substep<D>& substep, pbd::View<density_kernels::Multiplier> multiplier,
                        float tolerance, bool may_end) {
    using namespace density_kernels;
    const uint32_t fluid = substep.particles.sorted;
    device_.reduce("density/error", fluid, ErrorSum{},
                   MeanError{multiplier, substep.particles.phase, progress_.view()}, AddErrors{},
                   sum_.view());
    device_.parallel_for("density/end", 1,
                         Decide{sum_.view(), progress_.view(), ended_.view(), tolerance, may_end});
  }

  /// Call it when all iterations have been launched.
  void finish(const pbd::Substep<D>& substep, pbd::View<density_kernels::Multiplier> multiplier,
              pbd::View<const float> increment, density_kernels::Recorded recorded) {
    using namespace density_kernels;
    device_.parallel_for("density/finish", substep.particles.sorted,
                         Finish{multiplier, increment, start_.view(), progress_.view(), recorded});
    device_.parallel_for("density/report", 1, Report{progress_.view(), done_.view()});
    ++number_;
  }

  /// Iterations since the step's start, over its substeps. Call it when the device has finished.
  uint32_t iterations() const { return done_.host()[0]; }

 private:
  D& device_;
  pbd::Buffer<float> start_{device_, "density errors"};
  pbd::Buffer<density_kernels::Progress> progress_{device_, "density progress"};
  pbd::Buffer<density_kernels::ErrorSum> sum_{device_, "density error sum"};
  pbd::SharedBuffer<uint32_t> done_{device_, "density iterations"}, ended_{device_, "density's end"};
  uint32_t number_ = 0;  // the number of the substep: see Progress
};

}  // namespace meniscus::fluid
