// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Engines without a world, for tests that count what a device allocates.
#pragma once

#include <memory>

#include "sdk/engine/engine.h"

namespace meniscus::tests {

constexpr float engine_spacing = 0.05f;  // m

/// Null where the device is not built in.
inline std::unique_ptr<Engine> make_engine_on(pbd::DeviceKind kind, const EngineDef& def) {
#if MENISCUS_HAS_CUDA
  if (kind == pbd::DeviceKind::cuda) return make_cuda_engine(def, 0, nullptr);
#endif
  return kind == pbd::DeviceKind::cpu ? make_cpu_engine(def, 0) : nullptr;
}

inline EngineDef engine_def(collision::RigidWorld& rigid) {
  EngineDef def;
  def.particle_spacing = engine_spacing;
  def.kernel = fluid::calibrate(engine_spacing, 2 * engine_spacing);
  def.solver.support_radius = 2 * engine_spacing;
  def.solver.contact_radius = 0.5f * engine_spacing;
  def.density.correction_limit = 0.25f * engine_spacing;
  def.rigid = &rigid;
  return def;
}

}  // namespace meniscus::tests
