// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates DeviceEngine for CUDA.
#include "pbd/device/cuda/cuda_access.cuh"
#include "sdk/engine/engine.inl"

namespace meniscus {

std::unique_ptr<Engine> make_cuda_engine(const EngineDef& def, int ordinal, void* stream) {
  return std::make_unique<DeviceEngine<pbd::CudaDevice>>(def, pbd::CudaPlace{ordinal, stream});
}

}  // namespace meniscus
