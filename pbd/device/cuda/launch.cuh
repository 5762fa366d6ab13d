// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How a kernel waits for the launches before it, and notes the time.
#pragma once

#include <cstdint>

namespace meniscus::pbd::cuda_kernels {

/// Where a kernel notes when it begins, if anywhere. An event between two launches would prevent their
/// overlap.
struct TimeMark {
  uint64_t* at;  ///< ns
};

/// Lets the next launch overlap the end of this one (programmatic dependent launch, from compute
/// capability 9.0 on): its blocks are prepared while this one still runs.
__device__ __forceinline__ void let_next_begin() {
#if __CUDA_ARCH__ >= 900
  cudaTriggerProgrammaticLaunchCompletion();
#endif
}

/// Waits for the previous launch, and so for all launches for which that one waited.
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

/// Waits for the writes of all earlier launches.
__device__ __forceinline__ void wait_for_previous(TimeMark mark) {
  let_next_begin();
  wait_for_launch_before();
  note_time(mark);
}

}  // namespace meniscus::pbd::cuda_kernels
