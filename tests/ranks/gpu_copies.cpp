// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "tests/ranks/gpu_copies.h"

#include <meniscus/error.h>

#ifdef MENISCUS_HAS_CUDA
#include <cuda_runtime_api.h>
#endif

namespace meniscus::tests {

#ifdef MENISCUS_HAS_CUDA

namespace {

void copy(void* to, const void* from, std::size_t bytes, void* stream, cudaMemcpyKind kind) {
  const auto s = static_cast<cudaStream_t>(stream);
  cudaError_t status = cudaMemcpyAsync(to, from, bytes, kind, s);
  if (status == cudaSuccess) status = cudaStreamSynchronize(s);
  if (status != cudaSuccess) throw Error(ErrorCode::device, cudaGetErrorString(status));
}

}  // namespace

void copy_from_gpu(void* to, const void* from, std::size_t bytes, void* stream) {
  copy(to, from, bytes, stream, cudaMemcpyDeviceToHost);
}

void copy_to_gpu(void* to, const void* from, std::size_t bytes, void* stream) {
  copy(to, from, bytes, stream, cudaMemcpyHostToDevice);
}

#else

void copy_from_gpu(void*, const void*, std::size_t, void*) {
  throw Error(ErrorCode::device, "this build has no CUDA");
}

void copy_to_gpu(void*, const void*, std::size_t, void*) {
  throw Error(ErrorCode::device, "this build has no CUDA");
}

#endif

}  // namespace meniscus::tests
