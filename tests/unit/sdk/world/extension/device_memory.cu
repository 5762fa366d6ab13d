// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What a user of a GPU does with its memory and streams.
#include "tests/unit/sdk/world/extension/device_memory.h"

namespace meniscus::tests {

namespace {

__global__ void add_to_y(float* vectors, std::uint32_t count, float by) {
  const std::uint32_t i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i < count) vectors[4 * i + 1] += by;
}

}  // namespace

void copy_from_gpu(void* host, const void* memory, std::size_t bytes, void* stream) {
  cudaMemcpyAsync(host, memory, bytes, cudaMemcpyDeviceToHost, static_cast<cudaStream_t>(stream));
  cudaStreamSynchronize(static_cast<cudaStream_t>(stream));
}

void* make_gpu_stream() {
  cudaStream_t stream = nullptr;
  cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking);
  return stream;
}

void destroy_gpu_stream(void* stream) {
  cudaStreamDestroy(static_cast<cudaStream_t>(stream));
}

void add_on_gpu(float* vectors, std::uint32_t count, float by, void* stream) {
  if (count == 0) return;
  add_to_y<<<(count + 127) / 128, 128, 0, static_cast<cudaStream_t>(stream)>>>(vectors, count, by);
}

}  // namespace meniscus::tests
