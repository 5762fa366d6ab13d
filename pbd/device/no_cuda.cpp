// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Stands in for device/cuda/ in a build without CUDA.
#include "pbd/device/choose.h"

namespace meniscus::pbd {

CudaStatus cuda_status() {
  return {.usable = false, .name = "", .reason = "built without CUDA", .memory_bytes = 0};
}

}  // namespace meniscus::pbd
