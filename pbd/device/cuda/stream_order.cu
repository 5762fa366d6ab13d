// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Orders two streams by an event.
#include "pbd/device/stream_order.h"

#include "pbd/device/choose.h"
#include "pbd/device/cuda/cuda_check.cuh"

namespace meniscus::pbd {

void put_after(void* earlier, void* later, int ordinal) {
  const CudaScope scope(ordinal);
  cudaEvent_t event = nullptr;
  check_cuda(cudaEventCreateWithFlags(&event, cudaEventDisableTiming), "creating an event");
  cudaError_t status = cudaEventRecord(event, static_cast<cudaStream_t>(earlier));
  if (status == cudaSuccess) status = cudaStreamWaitEvent(static_cast<cudaStream_t>(later), event);
  cudaEventDestroy(event);  // once both streams have passed it
  check_cuda(status, "ordering two streams");
}

}  // namespace meniscus::pbd
