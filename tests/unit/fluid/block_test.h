// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Blocks of particles on their rest lattice, for tests of the forces that change velocities alone.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "pbd/math/vec.h"
#include "tests/bench/harness/solver_bench.h"
#include "tests/devices.h"

namespace meniscus::tests {

class BlockTest : public OnDevice {
 protected:
  static constexpr float spacing = 0.05f, support = 0.1f;
  static constexpr float pi = 3.14159265f;

  std::unique_ptr<SolverBench> bench_ = make_solver_bench(GetParam());

  static SmoothingCase lattice(int nx, int ny, int nz) {
    SmoothingCase c;
    c.support_radius = support;
    c.kernel = fluid::calibrate(spacing, support);
    c.materials = {fluid::Material{}};
    const float inverse_mass = 1 / (1000 * spacing * spacing * spacing);
    for (int k = 0; k < nz; ++k) {
      for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
          const Vec3 cell{float(i) - 0.5f * float(nx - 1), float(j) - 0.5f * float(ny - 1),
                          float(k) - 0.5f * float(nz - 1)};
          c.particles.push_back(pbd::with_w(spacing * cell, inverse_mass));
        }
      }
    }
    c.groups.assign(c.particles.size(), 0);
    c.velocities.assign(c.particles.size(), {0, 0, 0});
    return c;
  }

  /// v = cos(k y) along x, with antinodes at the free ends.
  static SmoothingCase shear_wave(float wave_number) {
    SmoothingCase c = lattice(40, 40, 10);
    for (size_t i = 0; i < c.particles.size(); ++i)
      c.velocities[i].x = std::cos(wave_number * c.particles[i].y);
    return c;
  }

  /// The wave's amplitude along the core, away from the sides.
  double amplitude(const SmoothingCase& c, float wave_number) const {
    return amplitude_of(bench_->smooth(c), c, wave_number);
  }
  static double amplitude_of(std::span<const Vec3> v, const SmoothingCase& c, float wave_number) {
    double along = 0, norm = 0;
    for (size_t i = 0; i < v.size(); ++i) {
      const Vec3 x = c.particles[i].xyz();
      if (std::fabs(x.x) > spacing || std::fabs(x.z) > spacing || std::fabs(x.y) > 10 * spacing) continue;
      const double wave = std::cos(wave_number * x.y);
      along += v[i].x * wave;
      norm += wave * wave;
    }
    return along / norm;
  }

  static Vec3 momentum(const SmoothingCase& c, std::span<const Vec3> velocities) {
    double sum[3] = {};
    for (size_t i = 0; i < velocities.size(); ++i) {
      sum[0] += velocities[i].x / c.particles[i].w;
      sum[1] += velocities[i].y / c.particles[i].w;
      sum[2] += velocities[i].z / c.particles[i].w;
    }
    return {float(sum[0]), float(sum[1]), float(sum[2])};
  }
};

}  // namespace meniscus::tests
