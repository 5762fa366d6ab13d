// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fluid/pressure_grid/multigrid_kernels.h"
#include "pbd/device/buffer.h"

namespace meniscus::fluid {

/// Solves Σ_f c_f (p − p_f) + extra p = b on the nodes of a table, by conjugate gradients with a V-cycle of a
/// geometric multigrid as the preconditioner (Tatebe 1993; McAdams, Sifakis & Teran 2010 for fluids): sweeps
/// of Gauss and Seidel's on a chequerboard, coarse nodes of up to eight fine ones. Cycles alone are faster in
/// a basin, but thin sheets and ragged edges can make them diverge; with conjugate gradients nothing can.
/// All scalars stay on the device: the host never waits.
template <class D>
class Multigrid {
 public:
  explicit Multigrid(D& device) : device_(device) {}

  /// The shape of the finest table. Makes room where there was never so much.
  void fit(const NodeTable& table);
  /// The equation, to be written before solve(), which leaves the residual in the place of the right side.
  multigrid_kernels::Level finest() { return levels_.front(); }
  void solve(int iterations);
  pbd::View<const float> solution() const { return {solution_.view().data, levels_.front().table.count()}; }

 private:
  void coarsen();
  void cycle(size_t level);
  multigrid_kernels::SmallLevels small() const;

  D& device_;
  std::vector<multigrid_kernels::Level> levels_;
  size_t first_small_ = 0;  // the level from which on one group does all
  pbd::Buffer<multigrid_kernels::Coefficients> coefficients_{device_, "pressure equation"};
  pbd::Buffer<float> pressure_{device_, "grid corrections"};
  pbd::Buffer<float> right_{device_, "grid residuals"};
  pbd::Buffer<float> solution_{device_, "grid pressures"};
  pbd::Buffer<float> direction_{device_, "grid search directions"};
  pbd::Buffer<float> image_{device_, "grid search directions"};
  pbd::Buffer<double> products_{device_, "grid products"};
};

}  // namespace meniscus::fluid
