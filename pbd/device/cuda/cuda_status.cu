// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Looks for a GPU and runs a probe kernel on it.
#include <cuda_runtime.h>

#include "pbd/device/choose.h"

namespace meniscus::pbd {

namespace {

constexpr int probe_answer = 0x6d656e69;

__global__ void probe(int* out) {
  *out = probe_answer;
}

std::string run_probe() {
  int* out = nullptr;
  cudaError_t status = cudaMalloc(&out, sizeof(int));
  int answer = 0;
  if (status == cudaSuccess) {
    probe<<<1, 1>>>(out);
    status = cudaGetLastError();
    if (status == cudaSuccess) status = cudaMemcpy(&answer, out, sizeof(int), cudaMemcpyDeviceToHost);
    cudaFree(out);
  }
  if (status != cudaSuccess) return std::string("a probe kernel failed: ") + cudaGetErrorString(status);
  return answer == probe_answer ? "" : "a probe kernel gave a wrong answer";
}

}  // namespace

CudaScope::CudaScope(int ordinal) : ordinal_(ordinal) {
  if (ordinal_ < 0 || cudaGetDevice(&before_) != cudaSuccess || before_ == ordinal_) return;
  cudaSetDevice(ordinal_);
}

CudaScope::~CudaScope() {
  if (before_ >= 0 && before_ != ordinal_) cudaSetDevice(before_);
}

CudaStatus cuda_status(int ordinal) {
  CudaStatus result;
  int devices = 0;
  const cudaError_t status = cudaGetDeviceCount(&devices);
  if (status != cudaSuccess || devices == 0) {
    result.reason = status != cudaSuccess ? cudaGetErrorString(status) : "no CUDA device found";
    cudaGetLastError();
    return result;
  }
  if (ordinal >= devices) {
    result.reason = "there is no CUDA device " + std::to_string(ordinal) + "; the first of " +
                    std::to_string(devices) + " is 0";
    return result;
  }
  const CudaScope scope(ordinal);
  cudaDeviceProp properties;
  if (cudaGetDeviceProperties(&properties, ordinal) == cudaSuccess) {
    result.name = properties.name;
    result.memory_bytes = properties.totalGlobalMem;
  }
  result.reason = run_probe();
  cudaGetLastError();
  result.usable = result.reason.empty();
  return result;
}

}  // namespace meniscus::pbd
