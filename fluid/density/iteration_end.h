// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Ends iterations early, on the device.
#pragma once

#include "fluid/density/stop_kernels.h"
#include "pbd/device/shared_buffer.h"

namespace meniscus::fluid {

/// Ends the iterations of a substep when an error is at most a tolerance. The device decides. The host
/// continues to launch until it learns of the end, and superfluous launches return at once.
template <class D>
class IterationEnd {
 public:
  explicit IterationEnd(D& device) : device_(device) {
    progress_.resize_discard(1);
    sum_.resize_discard(1);
    progress_.fill(0);
    done_.resize_discard(1);
    ended_.resize_discard(1);
    ended_.host()[0] = 0;
    start_step();
  }

  void start_step() {
    device_.parallel_for("density/begin", 1, density_kernels::Begin{progress_.view()});
    ++number_;
    done_.host()[0] = 0;
  }

  pbd::View<density_kernels::Progress> progress() { return progress_.view(); }
  /// Wraps a kernel, so that it does nothing once the iterations have ended.
  template <class Kernel>
  density_kernels::UnlessEnded<Kernel> unless_ended(const Kernel& kernel) const {
    return {progress_.view(), kernel};
  }

  /// Whether the host knows that this substep's iterations have ended, so that no more launches are needed.
  /// The moment varies from run to run, without an effect on the results.
  bool is_over() const { return *static_cast<const volatile uint32_t*>(ended_.host().data()) == number_; }

  /// Ends the iterations if the error, which is `measure` of all fluid particles merged, is at most the
  /// tolerance times their number.
  template <class Measure, class Merge>
  void test(uint32_t fluid, const Measure& measure, const Merge& merge, float tolerance, bool may_end) {
    using namespace density_kernels;
    device_.reduce("density/error", fluid, ErrorSum{}, measure, merge, sum_.view());
    device_.parallel_for("density/end", 1,
                         Decide{sum_.view(), progress_.view(), ended_.view(), tolerance, may_end});
  }

  /// Call it when all iterations of the substep have been launched.
  void finish() {
    device_.parallel_for("density/report", 1, density_kernels::Report{progress_.view(), done_.view()});
    ++number_;
  }

  /// Iterations since the step's start, over its substeps. Call it when the device has finished.
  uint32_t iterations() const { return done_.host()[0]; }

 private:
  D& device_;
  pbd::Buffer<density_kernels::Progress> progress_{device_, "density progress"};
  pbd::Buffer<density_kernels::ErrorSum> sum_{device_, "density error sum"};
  pbd::SharedBuffer<uint32_t> done_{device_, "density iterations"}, ended_{device_, "density's end"};
  uint32_t number_ = 0;  // the number of the substep: see Progress
};

}  // namespace meniscus::fluid
