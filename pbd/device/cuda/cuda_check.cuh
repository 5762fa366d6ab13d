// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Turns CUDA errors into exceptions.
#pragma once

#include <cuda_runtime.h>

#include <meniscus/error.h>
#include <string>

namespace meniscus::pbd {

/// Turns a CUDA status into an Error that names the operation.
inline void check_cuda(cudaError_t status, const char* what) {
  if (status == cudaSuccess) return;
  throw Error(ErrorCode::device, std::string("CUDA failed at ") + what + ": " + cudaGetErrorString(status));
}

}  // namespace meniscus::pbd
