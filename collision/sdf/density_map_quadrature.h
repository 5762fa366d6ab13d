// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The quadrature of the integrals of a density map.
#pragma once

#include <cstdint>
#include <vector>

namespace meniscus::collision {

/// A point of the support ball, relative to its centre.
struct QuadraturePoint {
  int32_t x, y, z;  ///< steps of the lattice of samples
  float weight;     ///< of the sample in B; the weights sum to 1
  float slope;      ///< of x, y, z times the sample in ∇B, 1/m
};

/// The quadrature of a density map: over samples of the solid's fraction in cubes of a lattice.
struct DensityQuadrature {
  uint32_t refinement;  ///< steps of that lattice per cell of the field
  uint32_t stride;      ///< steps from a sample to the next; each sample is then a mean over as many steps
  float step;           ///< m
  std::vector<QuadraturePoint> points;
};

/// The lattice has at least eight steps per support radius, and uses the field's own nodes where its cells
/// are that small. Samples are h/8 to h/4 apart. The field's cells are divided into `most` steps at most, and
/// cells larger than h count as h. A sample is a mean over a cube, which smooths the kernel. To second order
/// W − σ²/2 ∇²W undoes this, with the cube's variance σ² along an axis.
DensityQuadrature density_quadrature(float cell_size, float h, uint32_t most);

}  // namespace meniscus::collision
