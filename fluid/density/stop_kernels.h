// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of stop.h.
#pragma once

#include "fluid/kernel/density_kernels.h"

namespace meniscus::fluid::density_kernels {

/// Where the iterations stand.
struct Progress {
  uint32_t ended;       ///< 1 once this substep's are at their end
  uint32_t iterations;  ///< since the step's start
  uint32_t number;      ///< of the substep, counted from the first one on
};

/// Begins a step, whatever has become of the last one.
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
};

/// Puts C at the substep's start aside.
struct KeepStart {
  View<const Multiplier> multiplier;
  View<float> start;

  MENISCUS_HD void operator()(uint32_t i) const { start[i] = multiplier[i].relieved; }
};

struct ErrorSum {
  double error = 0;
  uint32_t fluid = 0;  ///< particles
};

struct AddErrors {
  MENISCUS_HD ErrorSum operator()(const ErrorSum& a, const ErrorSum& b) const {
    return {a.error + b.error, a.fluid + b.fluid};
  }
};

struct MeanError {
  View<const Multiplier> multiplier;
  View<const pbd::Phase> phase;
  View<const Progress> progress;

  MENISCUS_HD ErrorSum operator()(uint32_t i) const {
    if (progress[0].ended || pbd::is_grain(phase[i])) return {};
    return {double{pbd::max(multiplier[i].relieved, 0.0f)}, 1};
  }
};

struct Decide {
  View<const ErrorSum> sum;
  View<Progress> progress;
  View<uint32_t> ended;  ///< the number of the substep that has; the host looks there
  float tolerance;
  bool may_end;  ///< at this iteration

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

/// Takes back what the iteration that found the end had wanted to add, and leaves the multipliers as the next
/// substep expects them.
struct Finish {
  View<Multiplier> multiplier;
  View<const float> increment, start;
  View<const Progress> progress;
  bool keeps_error;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Multiplier m = multiplier[i];
    const float value = progress[0].ended ? pbd::max(m.value - increment[i], 0.0f) : m.value;
    multiplier[i] = {value, keeps_error ? m.relieved : start[i] - m.relieved};
  }
};

/// Makes ready for the next substep, and tells the host.
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
