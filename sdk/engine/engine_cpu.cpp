// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates DeviceEngine for the CPU.
#include "pbd/device/cpu/cpu_access.h"
#include "sdk/engine/engine.inl"

namespace meniscus {

std::unique_ptr<Engine> make_cpu_engine(const EngineDef& def, int threads, const ParallelFor& loop) {
  if (loop) return std::make_unique<DeviceEngine<pbd::CpuDevice>>(def, loop);
  return std::make_unique<DeviceEngine<pbd::CpuDevice>>(def, threads);
}

}  // namespace meniscus
