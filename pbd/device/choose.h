// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Whether a GPU is usable, and if not, why.
#pragma once

#include <string>

namespace meniscus::pbd {

/// The result of the search for a usable GPU.
struct CudaStatus {
  bool usable = false;
  std::string name;    ///< of the GPU, where there is one
  std::string reason;  ///< why it is not used
  size_t memory_bytes = 0;
};

/// Usable means: CUDA is built in, a driver and a device exist, and a probe kernel returned the right answer.
CudaStatus cuda_status();

}  // namespace meniscus::pbd
