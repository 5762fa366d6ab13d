// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace meniscus::collision {

/// A point of the support ball, seen from its centre.
struct QuadraturePoint {
  int32_t x, y, z;  ///< steps of the lattice of samples
  float weight;     ///< of the sample in B; they sum up to 1
  float slope;      ///< of x, y, z times the sample in ∇B, 1/m
};

/// How the integrals of a density map are taken: over samples of the solid's share in cubes of a lattice.
struct DensityQuadrature {
  uint32_t refinement;  ///< steps of that lattice a cell of the field
  uint32_t stride;      ///< steps from a sample to the next; each then is a mean over so many
  float step;           ///< m
  std::vector<QuadraturePoint> points;
};

/// The lattice has eight steps a support radius or more, on the field's own nodes where its cells are so
/// small; samples lie from h/8 to h/4 apart. The field's cells are divided into `most` steps at most, and
/// cells larger than h count as h. A sample is a mean over a cube, which smooths the kernel: to second order
/// that is taken back by W − σ²/2 ∇²W, with the cube's variance σ² along an axis.
DensityQuadrature density_quadrature(float cell_size, float h, uint32_t most);

}  // namespace meniscus::collision
