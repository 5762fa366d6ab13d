// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of iteration_end.h and stop.h.
#pragma once

#include "fluid/kernel/density_kernels.h"

namespace meniscus::fluid::density_kernels {

/// The progress of the iterations.
struct Progress {
  uint32_t ended;       ///< 1 once the iterations of this substep have ended
  uint32_t iterations;  ///< since the start of the step
  uint32_t number;      ///< the number of the substep, counted from the first one
};

/// Begins a step, whatever the state after the last one.
struct Begin {
  View<Progress> progress;

  MENISCUS_HD void operator()(uint32_t) const { progress[0] = {0, 0, progress[0].number + 1}; }
};

template <class Kernel>
struct UnlessEnded {
  View<const Progress> progress;
  Kernel kernel;

  template <class D>
  MENISCUS_HD void run(uint32_t i) const {
    if (!progress[0].ended) kernel.template run<D>(i);
  }
  MENISCUS_HD void operator()(uint32_t i) const {
    if (!progress[0].ended) kernel(i);
  }
};

/// Saves C at the substep's start.
struct KeepStart {
  View<const Multiplier> multiplier;
  View<float> start;

  MENISCUS_HD void operator()(uint32_t i) const { start[i] = multiplier[i].relieved; }
};

struct ErrorSum {
  double error = 0;
  uint32_t fluid = 0;  ///< number of particles
};

struct AddErrors {
  MENISCUS_HD ErrorSum operator()(const ErrorSum& a, const ErrorSum& b) const {
    return {a.error + b.error, a.fluid + b.fluid};
  }
};

/// `fixed`: errors are multiples of 2⁻²⁴, at most 16, whose sum over 2²⁵ particles is exact in any order.
struct MeanError {
  View<const Multiplier> multiplier;
  View<const pbd::Phase> phase;
  View<const Progress> progress;
  bool fixed;

  MENISCUS_HD ErrorSum operator()(uint32_t i) const {
    if (progress[0].ended || pbd::is_grain(phase[i])) return {};
    const float error = pbd::max(multiplier[i].relieved, 0.0f);
    if (!fixed) return {double{error}, 1};
    return {double{rintf(pbd::min(error, 16.0f) * 0x1p24f)} * 0x1p-24, 1};
  }
};

struct Decide {
  View<const ErrorSum> sum;
  View<Progress> progress;
  View<uint32_t> ended;  ///< the number of the substep that has ended, for the host
  float tolerance;
  bool may_end;  ///< whether this iteration may end

  MENISCUS_HD void operator()(uint32_t) const {
    Progress& p = progress[0];
    if (p.ended) return;
    if (may_end && sum[0].error <= double{tolerance} * static_cast<double>(sum[0].fluid)) {
      p.ended = 1;
      ended[0] = p.number;
    } else {
      ++p.iterations;
    }
  }
};

/// Undoes the increments of the iteration at which the end was found, and prepares the multipliers for the
/// next substep.
struct Finish {
  View<Multiplier> multiplier;
  View<const float> increment, start;
  View<const Progress> progress;
  Recorded recorded;  ///< last_error or decrease

  MENISCUS_HD void operator()(uint32_t i) const {
    const Multiplier m = multiplier[i];
    const float value = progress[0].ended ? pbd::max(m.value - increment[i], 0.0f) : m.value;
    multiplier[i] = {value, recorded == Recorded::last_error ? m.relieved : start[i] - m.relieved};
  }
};

/// Prepares the next substep, and informs the host.
struct Report {
  View<Progress> progress;
  View<uint32_t> iterations;

  MENISCUS_HD void operator()(uint32_t) const {
    progress[0].ended = 0;
    ++progress[0].number;
    iterations[0] = progress[0].iterations;
  }
};

}  // namespace meniscus::fluid::density_kernels
