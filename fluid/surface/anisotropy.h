// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The surface of a fluid as ellipsoids, one for each particle, which are flat along the surface (Yu & Turk
// 2013). From the neighbours, weighted by w = 1 − (r/h)³, follow the mean m and the covariance C (eqs. 9 and
// 10):
//   centre  x + λ (m − x)                                   (eq. 6)
//   axes    the eigenvectors of C; radii in proportion to the roots of its eigenvalues, none below 1/k of the
//           largest
// Departures from the paper: radii follow standard deviations, which are lengths, rather than variances.
// Every ellipsoid has the volume of a ball of radius `radius`, so that a thin layer gets wider as it gets
// flatter. With few neighbours the ellipsoid changes gradually to a small ball, so that a drop does not
// change its size suddenly.
#pragma once

#include <meniscus/outputs.h>

#include "fluid/surface/tuning.h"
#include "pbd/substep.h"

namespace meniscus::fluid {

struct AnisotropyParameters {
  float support = 0;                                    ///< h, m
  float smoothing = surface_tuning::smoothing;          ///< λ
  float ratio = surface_tuning::longest_over_shortest;  ///< k
  float radius = 0;                                     ///< m: with neighbours
  float lone_radius = 0;                                ///< m: of a single particle
  float grain_radius = 0;                               ///< m
  float surface_weight = 0;  ///< Σ w of a particle at a flat surface, itself included
};

/// For rest spacing s and support radius h, m. The radius is such that the surface of water at rest is half a
/// spacing above the centres of its topmost particles. A single particle is a ball of volume s³.
AnisotropyParameters calibrate_anisotropy(double spacing, double support_radius);

template <class D>
class Anisotropy {
 public:
  Anisotropy(D& device, const AnisotropyParameters& parameters) : device_(device), parameters_(parameters) {}

  /// One ellipsoid for each particle, by slot; grains are balls of their own size.
  void measure(const pbd::Substep<D>& substep, pbd::View<Ellipsoid> ellipsoids) const {
    measure(substep, substep.particles.slot, ellipsoids);
  }
  /// The same, in the order of the sorted particles.
  void measure_sorted(const pbd::Substep<D>& substep, pbd::View<Ellipsoid> ellipsoids) const {
    measure(substep, {}, ellipsoids);
  }

 private:
  void measure(const pbd::Substep<D>& substep, pbd::View<const uint32_t> slot,
               pbd::View<Ellipsoid> ellipsoids) const;

  D& device_;
  AnisotropyParameters parameters_;
};

}  // namespace meniscus::fluid
