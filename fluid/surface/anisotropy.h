// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Particles as the surface of their fluid: ellipsoids that lie flat along it (Yu & Turk 2013). From the
// neighbours, weighted by w = 1 − (r/h)³, come the mean m and the covariance C (eqs. 9 and 10):
//   centre  x + λ (m − x)                                   (eq. 6)
//   axes    the eigenvectors of C; radii in proportion to the roots of its eigenvalues, none below 1/k of the
//           largest
// Departures from the paper: radii follow standard deviations, which are lengths, rather than variances.
// Every ellipsoid has the volume of a ball of radius `radius`, so that a sheet, however thin, gets wider as
// it gets flatter. And what has few neighbours goes over to a small ball step by step, so that a drop does
// not change its size at once.
#pragma once

#include <meniscus/outputs.h>

#include "pbd/substep.h"

namespace meniscus::fluid {

struct AnisotropyParameters {
  float support = 0;         ///< h, m
  float smoothing = 0.9f;    ///< λ
  float ratio = 4;           ///< k: the longest radius over the shortest, at most
  float radius = 0;          ///< m: among neighbours
  float lone_radius = 0;     ///< m: of a particle on its own
  float grain_radius = 0;    ///< m
  float surface_weight = 0;  ///< Σ w of a particle at a flat surface, itself included
};

/// For rest spacing s and support radius h, m. The radius is such that the surface of water at rest lies half
/// a spacing above the centres of its topmost particles, where it is; a lone particle is a ball of the volume
/// s³.
AnisotropyParameters calibrate_anisotropy(double spacing, double support_radius);

template <class D>
class Anisotropy {
 public:
  Anisotropy(D& device, const AnisotropyParameters& parameters) : device_(device), parameters_(parameters) {}

  /// One ellipsoid a particle, by slot; grains are the balls that they are.
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
