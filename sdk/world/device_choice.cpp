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

namespace {

/// Throws if the definition names a GPU or a stream, and the world is on the CPU.
void refuse_cuda_members(const WorldDef& def, const std::string& reason) {
  const char* const member = def.cuda_device ? "cuda_device" : def.cuda_stream ? "cuda_stream" : nullptr;
  if (!member) return;
  throw Error(ErrorCode::invalid_argument, std::string("WorldDef::") + member +
                                               " is of a GPU, and the world is on the CPU" +
                                               (reason.empty() ? "" : ": " + reason));
}

}  // namespace

std::unique_ptr<Engine> make_engine(const EngineDef& def, const WorldDef& world, DeviceInfo& info) {
  if (world.device != DeviceChoice::cpu) {
    const int ordinal = world.cuda_device.value_or(0);
    const pbd::CudaStatus cuda = pbd::cuda_status(ordinal);
    if (cuda.usable) {
#if MENISCUS_HAS_CUDA
      info = {"cuda", cuda.name, true, "", cuda.memory_bytes};
      const pbd::CudaScope scope(ordinal);
      return make_cuda_engine(def, ordinal, world.cuda_stream);
#endif
    }
    if (world.device == DeviceChoice::cuda) {
      throw Error(ErrorCode::device, "the CUDA device cannot be used: " + cuda.reason);
    }
    info.reason = "CUDA is not used: " + cuda.reason;
  }
  refuse_cuda_members(world, info.reason);
  std::unique_ptr<Engine> engine = make_cpu_engine(def, world.threads, world.parallel_for);
  info.kind = "cpu";
  info.name = engine->device().name();
  info.usable = true;
  return engine;
}

}  // namespace meniscus
