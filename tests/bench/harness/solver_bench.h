// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Single stages of a substep on one device, with the device's type hidden: particles in, results out, both in
// the order in which the particles were given.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "collision/contact/shape.h"
#include "fluid/density/density_set.h"
#include "fluid/kernel/material.h"
#include "fluid/pressure_grid/node_table.h"
#include "pbd/device/device.h"

namespace meniscus::tests {

struct NeighbourLists {
  static constexpr uint32_t padding = 0xffffffff, broken = 0xfffffffe;

  std::vector<std::vector<uint32_t>> of;  ///< with `padding` at the end, to whole groups
  uint32_t group = 1;                     ///< entries a list is a multiple of
};

struct DensityCase {
  float support_radius = 0.1f;  ///< m
  fluid::Kernel kernel{};
  fluid::DensityParameters parameters;
  std::vector<pbd::Vec4> particles;  ///< w: inverse mass
  std::vector<Vec3> velocities;      ///< m/s; none: at rest
  std::vector<collision::Shape> planes;
  float dt = 0.0025f;
  int iterations = 1;
};

struct DensitySolution {
  std::vector<Vec3> positions;
  std::vector<Vec3> velocities;  ///< of solve_baseline
  std::vector<float> multipliers;
  std::vector<float> errors;  ///< C before the solve
};

struct SmoothingCase {
  float support_radius = 0.1f;  ///< m
  float spacing = 0.05f;        ///< m
  fluid::Kernel kernel{};
  std::vector<fluid::Material> materials;
  std::vector<pbd::Vec4> particles;  ///< w: inverse mass
  std::vector<uint32_t> groups;      ///< of each particle, among the materials
  std::vector<Vec3> velocities;
  std::vector<collision::Shape> planes;
  float dt = 0.0025f;
  int passes = 1;
};

/// An equation of fluid/pressure_grid/multigrid.h.
struct GridEquation {
  fluid::NodeTable table;
  std::vector<pbd::Vec4> coefficients;
  std::vector<float> right;
};

class SolverBench {
 public:
  virtual ~SolverBench() = default;

  virtual NeighbourLists neighbours(std::span<const Vec3> points, float support_radius) = 0;
  /// The iterations of one substep's density solve, with nothing else going on.
  virtual DensitySolution solve_density(const DensityCase& setup) = 0;
  /// A whole substep of a baseline, from positions that are predicted already.
  virtual DensitySolution solve_baseline(const DensityCase& setup) = 0;
  /// Positions once every particle's multiplier has pushed, when all of them are the same; kg·m². They are
  /// left from a substep of last_dt.
  virtual std::vector<Vec3> push(const DensityCase& setup, float multiplier, float last_dt) = 0;
  /// Velocities after passes of the viscosity over particles that stand still.
  virtual std::vector<Vec3> smooth(const SmoothingCase& setup) = 0;
  virtual std::vector<float> solve(const GridEquation& equation, int iterations) = 0;
};

std::unique_ptr<SolverBench> make_cpu_solver_bench();
/// Without what registers the processor has beyond the baseline.
std::unique_ptr<SolverBench> make_baseline_solver_bench();
std::unique_ptr<SolverBench> make_cuda_solver_bench();

inline std::unique_ptr<SolverBench> make_solver_bench(pbd::DeviceKind kind) {
#if MENISCUS_HAS_CUDA
  if (kind == pbd::DeviceKind::cuda) return make_cuda_solver_bench();
#endif
  return kind == pbd::DeviceKind::cpu ? make_cpu_solver_bench() : nullptr;
}

}  // namespace meniscus::tests
