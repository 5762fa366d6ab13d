// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Weights of the Chebyshev semi-iteration, which accelerates Jacobi iterations.
#pragma once

#include <cmath>

#include "pbd/tuning.h"

namespace meniscus::pbd {

/// Weights of one iteration: increment = momentum · last increment + step · residual.
struct IterationWeights {
  float momentum, step;
};

/// The Chebyshev semi-iteration with m iterations, on the interval [bound (1.5/m)², bound] of a spectrum. The
/// lower end is the least eigenvalue that m iterations still resolve. Golub & Van Loan, Matrix Computations,
/// section 11.2.8.
class Chebyshev {
 public:
  explicit Chebyshev(float bound) : bound_(bound) {}

  IterationWeights next(int iteration, int iterations) {
    const float m = static_cast<float>(iterations);
    const float high = bound_;
    const float low = high * std::fmin(chebyshev_tuning::most_low, chebyshev_tuning::resolved2 / (m * m));
    const float centre = 0.5f * (high + low), radius = 0.5f * (high - low);
    const float sigma = centre / radius;
    if (iteration == 0) {
      rho_ = 1 / sigma;
      return {0, 1 / centre};
    }
    const float next = 1 / (2 * sigma - rho_);
    const IterationWeights weights{next * rho_, 2 * next / radius};
    rho_ = next;
    return weights;
  }

 private:
  float bound_;
  float rho_ = 0;  // of the recurrence over iterations
};

}  // namespace meniscus::pbd
