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

/// Usable means: CUDA is built in, a driver and this device exist, and a probe kernel returned the right
/// answer.
CudaStatus cuda_status(int ordinal = 0);

/// While it lives, the calling thread uses this GPU. A negative ordinal changes nothing.
class CudaScope {
 public:
  explicit CudaScope(int ordinal);
  ~CudaScope();
  CudaScope(const CudaScope&) = delete;
  CudaScope& operator=(const CudaScope&) = delete;

 private:
  int ordinal_, before_ = -1;
};

}  // namespace meniscus::pbd
