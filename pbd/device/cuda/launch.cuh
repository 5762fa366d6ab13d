// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace meniscus::pbd::cuda_kernels {

/// Where a kernel notes when it begins, if anywhere. An event between two launches would keep them apart.
struct TimeMark {
  uint64_t* at;  ///< ns
};

/// A launch overlaps the end of the one before (programmatic dependent launch, from compute capability 9.0
/// on): blocks are made ready while that one still runs.
__device__ __forceinline__ void let_next_begin() {
#if __CUDA_ARCH__ >= 900
  cudaTriggerProgrammaticLaunchCompletion();
#endif
}

/// For the launch before, and so for all that this one waited for.
__device__ __forceinline__ void wait_for_launch_before() {
#if __CUDA_ARCH__ >= 900
  cudaGridDependencySynchronize();
#endif
}

__device__ __forceinline__ void note_time(TimeMark mark) {
  if (mark.at && blockIdx.x == 0 && threadIdx.x == 0) {
    asm volatile("mov.u64 %0, %%globaltimer;" : "=l"(*mark.at));
  }
}

/// For what all launches before wrote.
__device__ __forceinline__ void wait_for_previous(TimeMark mark) {
  let_next_begin();
  wait_for_launch_before();
  note_time(mark);
}

}  // namespace meniscus::pbd::cuda_kernels
