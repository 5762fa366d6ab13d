// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Lists the devices, makes the engine for a chosen one, and names the stages of a step.
#include <meniscus/error.h>

#include "pbd/device/choose.h"
#include "pbd/device/cpu/cpu_device.h"
#include "sdk/world/world_impl.h"

namespace meniscus {

const char* stage_name(Stage stage) {
  switch (stage) {
    case Stage::predict:
      return "predict";
    case Stage::neighbours:
      return "neighbours";
    case Stage::contacts:
      return "contacts";
    case Stage::solve:
      return "solve";
    case Stage::velocity:
      return "velocity";
    case Stage::exchange:
      return "exchange";
    case Stage::finish:
      return "finish";
  }
  return "";
}

std::vector<DeviceInfo> list_devices() {
  const pbd::CudaStatus cuda = pbd::cuda_status();
  return {{"cuda", cuda.name, cuda.usable, cuda.reason, cuda.memory_bytes},
          {"cpu", pbd::CpuDevice().name(), true, "", 0}};
}

std::unique_ptr<Engine> make_engine(const EngineDef& def, DeviceChoice choice, int threads,
                                    DeviceInfo& info) {
  if (choice != DeviceChoice::cpu) {
    const pbd::CudaStatus cuda = pbd::cuda_status();
    if (cuda.usable) {
#if MENISCUS_HAS_CUDA
      info = {"cuda", cuda.name, true, "", cuda.memory_bytes};
      return make_cuda_engine(def);
#endif
    }
    if (choice == DeviceChoice::cuda) {
      throw Error(ErrorCode::device, "the CUDA device cannot be used: " + cuda.reason);
    }
    info.reason = "CUDA is not used: " + cuda.reason;
  }
  std::unique_ptr<Engine> engine = make_cpu_engine(def, threads);
  info.kind = "cpu";
  info.name = engine->device().name();
  info.usable = true;
  return engine;
}

}  // namespace meniscus
