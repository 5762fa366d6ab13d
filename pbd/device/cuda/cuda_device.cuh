// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cub/block/block_reduce.cuh>
#include <vector>

#include "pbd/device/buffer.h"
#include "pbd/device/cuda/cuda_check.cuh"
#include "pbd/device/scalar.h"

namespace meniscus::pbd {

namespace cuda_kernels {

constexpr uint32_t block_size = 128;
constexpr uint32_t reduce_block = 256;
constexpr uint32_t segment = 1024;

template <class Kernel>
__global__ void __launch_bounds__(block_size)
    for_each(uint32_t count, const __grid_constant__ Kernel kernel) {
  const uint32_t i = blockIdx.x * block_size + threadIdx.x;
  if (i < count) kernel(i);
}

// A block takes one segment: each thread every 256th element, then CUB's fixed tree. No order is left to
// chance.
template <class T, class Map, class Combine>
__global__ void __launch_bounds__(reduce_block)
    reduce_segments(uint32_t count, uint32_t length, T identity, const __grid_constant__ Map map,
                    Combine combine, T* out) {
  using BlockReduce = cub::BlockReduce<T, reduce_block>;
  __shared__ typename BlockReduce::TempStorage storage;
  const uint32_t begin = blockIdx.x * length;
  const uint32_t end = min(count, begin + length);
  T total = identity;
  for (uint32_t i = begin + threadIdx.x; i < end; i += reduce_block) total = combine(total, map(i));
  total = BlockReduce(storage).Reduce(total, combine);
  if (threadIdx.x == 0) out[blockIdx.x] = total;
}

template <class T>
struct ReadPartial {
  const T* partial;
  __device__ T operator()(uint32_t i) const { return partial[i]; }
};

}  // namespace cuda_kernels

/// One NVIDIA GPU and one stream on it.
class CudaDevice final : public Device {
 public:
  /// What a neighbour loop runs on: one neighbour at a time, a particle a thread.
  using Real = float;
  static constexpr uint32_t lane_count = 1;

  CudaDevice();
  ~CudaDevice() override;

  DeviceKind kind() const override { return DeviceKind::cuda; }
  std::string name() const override { return name_; }

  void copy_in(void* device_memory, const void* host, size_t bytes) override;
  void copy_out(void* host, const void* device_memory, size_t bytes) override;
  void copy(void* to, const void* from, size_t bytes) override;
  void fill(void* memory, unsigned char byte, size_t bytes) override;
  void wait() override;
  void mark_time(uint32_t mark) override;
  double elapsed_ms(uint32_t from, uint32_t to) const override;

  /// See CpuDevice, whose members these mirror.
  template <class Kernel>
  void parallel_for(const char* name, uint32_t count, const Kernel& kernel) {
    if (count == 0) return;
    using namespace cuda_kernels;
    for_each<<<(count + block_size - 1) / block_size, block_size, 0, stream_>>>(count, kernel);
    check_cuda(cudaGetLastError(), name);
  }

  template <class T, class Map, class Combine>
  void reduce(const char* name, uint32_t count, T identity, const Map& map, const Combine& combine,
              View<T> out) {
    using namespace cuda_kernels;
    const uint32_t segments = count ? (count + segment - 1) / segment : 1;
    T* partial = static_cast<T*>(scratch(segments * sizeof(T)));
    reduce_segments<<<segments, reduce_block, 0, stream_>>>(count, segment, identity, map, combine, partial);
    reduce_segments<<<1, reduce_block, 0, stream_>>>(segments, segments, identity, ReadPartial<T>{partial},
                                                     combine, out.data);
    check_cuda(cudaGetLastError(), name);
  }

  void exclusive_scan(const char* name, View<const uint32_t> in, View<uint32_t> out);
  void sort_pairs(const char* name, View<const uint32_t> keys, View<uint32_t> sorted_keys,
                  View<const uint32_t> values, View<uint32_t> sorted_values, uint32_t bits);

 private:
  void* do_allocate(size_t bytes) override;
  void do_release(void* memory) noexcept override;
  void* scratch(size_t bytes);

  cudaStream_t stream_ = nullptr;
  std::string name_;
  std::vector<cudaEvent_t> marks_;
  void* pinned_ = nullptr;  // small results come back through it, at a pinned copy's latency
  Buffer<uint64_t> scratch_{*this, "CUDA scratch"};
};

}  // namespace meniscus::pbd
