// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Conjugate gradients with a multigrid preconditioner, for the pressure grid.
#pragma once

#include <vector>

#include "fluid/pressure_grid/multigrid_kernels.h"
#include "pbd/device/buffer.h"

namespace meniscus::fluid {

/// Solves Σ_f c_f (p − p_f) + extra p = b on the nodes of a table, by conjugate gradients. The preconditioner
/// is a V-cycle of a geometric multigrid (Tatebe 1993; McAdams, Sifakis & Teran 2010 for fluids), with
/// red-black Gauss–Seidel sweeps and coarse nodes of up to eight fine ones. Cycles alone are faster in a
/// basin, but can diverge with thin layers and irregular surfaces; conjugate gradients cannot. All scalars
/// stay on the device, so the host never waits.
template <class D>
class Multigrid {
 public:
  explicit Multigrid(D& device) : device_(device) {}

  /// Sets the shape of the finest table. Allocates if it is larger than any before.
  void fit(const NodeTable& table);
  /// The equation. Write it before solve(), which replaces the right side by the residual.
  multigrid_kernels::Level finest() { return levels_.front(); }
  void solve(int iterations);
  pbd::View<const float> solution() const { return {solution_.view().data, levels_.front().table.count()}; }

 private:
  void coarsen();
  void cycle(size_t level);
  multigrid_kernels::SmallLevels small() const;

  D& device_;
  std::vector<multigrid_kernels::Level> levels_;
  size_t first_small_ = 0;  // from this level on one group of threads solves all levels
  pbd::Buffer<multigrid_kernels::Coefficients> coefficients_{device_, "pressure equation"};
  pbd::Buffer<float> pressure_{device_, "grid corrections"};
  pbd::Buffer<float> right_{device_, "grid residuals"};
  pbd::Buffer<float> solution_{device_, "grid pressures"};
  pbd::Buffer<float> direction_{device_, "grid search directions"};
  pbd::Buffer<float> image_{device_, "grid search directions"};
  pbd::Buffer<double> products_{device_, "grid products"};
};

}  // namespace meniscus::fluid
