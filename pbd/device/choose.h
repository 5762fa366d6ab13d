// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace meniscus::pbd {

/// What became of the search for a usable GPU.
struct CudaStatus {
  bool usable = false;
  std::string name;    ///< the GPU's, where there is one
  std::string reason;  ///< why it is not used
  size_t memory_bytes = 0;
};

/// Usable means: built in, a driver and a device are there, and a probe kernel ran and gave the right answer.
CudaStatus cuda_status();

}  // namespace meniscus::pbd
