// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Rods and ropes alone in a solver on one device, with the device's type hidden.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "cloth/rods/rod.h"
#include "pbd/device/device.h"

namespace meniscus::tests {

struct RodScene {
  cloth::RodModel rods, ropes;  ///< their vertices numbered over both
  std::vector<Vec3> points;     ///< of all vertices
  std::vector<float> masses;    ///< kg; 0: held fast

  Vec3 gravity{0, -9.81f, 0};
  int substeps = 10, iterations = 10;

  /// Returns the first of its vertices.
  uint32_t add(std::span<const Vec3> along, const cloth::RodParameters& parameters);
  void hold(uint32_t vertex) { masses[vertex] = 0; }
};

class RodBench {
 public:
  virtual ~RodBench() = default;

  virtual void step(float dt) = 0;
  virtual std::vector<Vec3> positions() = 0;
  virtual std::vector<Vec3> velocities() = 0;
  virtual void set_velocities(std::span<const Vec3> velocities) = 0;
  virtual std::vector<cloth::SegmentState> states() = 0;
  virtual void set_state(uint32_t segment, const cloth::SegmentState& state) = 0;
  virtual std::vector<Vec3> torques() = 0;
  virtual std::vector<float> tensions() = 0;
  /// N, what pulls at each vertex that is held, in the last substep of a step of dt.
  virtual std::vector<Vec3> reactions(float dt) = 0;
  /// Takes the rods back to where they were before the last step, as a solver does that has had no room.
  virtual void save() = 0;
  virtual void restore() = 0;

  virtual void set_rods(const cloth::RodModel& model) = 0;

  void run(int steps, float dt = 1.0f / 60) {
    for (int k = 0; k < steps; ++k) step(dt);
  }
  /// Runs, and scales the velocities by `share` after each step.
  void settle(int steps, float share);
};

std::unique_ptr<RodBench> make_cpu_rod_bench(const RodScene& scene, int threads);
std::unique_ptr<RodBench> make_cuda_rod_bench(const RodScene& scene);

inline std::unique_ptr<RodBench> make_rod_bench(pbd::DeviceKind kind, const RodScene& scene) {
#if MENISCUS_HAS_CUDA
  if (kind == pbd::DeviceKind::cuda) return make_cuda_rod_bench(scene);
#endif
  return kind == pbd::DeviceKind::cpu ? make_cpu_rod_bench(scene, 0) : nullptr;
}

/// Points from a to b.
std::vector<Vec3> straight(Vec3 a, Vec3 b, uint32_t segments);
/// A rod along x from 0 to 1 m, with a stub before it that is to be clamped. Its weight is `load` times
/// EI/L².
RodScene cantilever(float load, uint32_t segments, int substeps);
/// Holds the first segment's frame; its vertices must be held too.
void clamp_first(RodBench& bench);

}  // namespace meniscus::tests
