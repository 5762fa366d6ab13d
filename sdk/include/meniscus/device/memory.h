// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Arrays and loops of a user's constraints: on the CPU, and on a GPU where nvcc compiles them.
#pragma once

#include <meniscus/device/qualifiers.h>
#include <meniscus/error.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

namespace meniscus::device {

#ifdef __CUDACC__
/// Runs work(i) for each i below count.
template <class Work>
__global__ void run_each(uint32_t count, const Work work) {
  const uint32_t i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i < count) work(i);
}
#endif

/// Runs work(i) for each i below count, on the stream of a GPU, or at once on the CPU.
template <class Work>
void for_each(bool on_cuda, void* stream, uint32_t count, const Work& work) {
  if (count == 0) return;
#ifdef __CUDACC__
  if (on_cuda) {
    run_each<<<(count + 127) / 128, 128, 0, static_cast<cudaStream_t>(stream)>>>(count, work);
    if (cudaGetLastError() != cudaSuccess)
      throw Error(ErrorCode::device, "a constraint could not be launched");
    return;
  }
#endif
  static_cast<void>(stream);
  if (on_cuda)
    throw Error(ErrorCode::device, "the world is on a GPU; compile its constraints with nvcc, in a .cu file");
  for (uint32_t i = 0; i < count; ++i) work(i);
}

/// An array in the memory of the device that the world is on.
template <class T>
class Array {
 public:
  T* data() const { return memory_.get(); }   ///< on the device
  std::size_t size() const { return size_; }  ///< elements

  /// Sets the length, and loses the contents. Does nothing if it is so long already.
  void resize(bool on_cuda, std::size_t size) {
    if (size == size_) return;
    memory_.reset();
    memory_ = allocate(on_cuda, size * sizeof(T));
    size_ = size;
  }
  /// Copies from the host, in the order of the stream.
  void write(bool on_cuda, void* stream, std::span<const T> values) {
    resize(on_cuda, values.size());
#ifdef __CUDACC__
    if (on_cuda) {
      cudaMemcpyAsync(data(), values.data(), values.size_bytes(), cudaMemcpyHostToDevice,
                      static_cast<cudaStream_t>(stream));
      return;
    }
#endif
    static_cast<void>(stream);
    if (!values.empty()) std::memcpy(data(), values.data(), values.size_bytes());
  }

 private:
  static std::shared_ptr<T> allocate(bool on_cuda, std::size_t bytes) {
    if (bytes == 0) return nullptr;
#ifdef __CUDACC__
    if (on_cuda) {
      void* memory = nullptr;
      if (cudaMalloc(&memory, bytes) != cudaSuccess)
        throw Error(ErrorCode::out_of_memory, "the GPU has no memory for constraints");
      return {static_cast<T*>(memory), [](T* held) { cudaFree(held); }};
    }
#endif
    if (on_cuda)
      throw Error(ErrorCode::device,
                  "the world is on a GPU; compile its constraints with nvcc, in a .cu file");
    return {static_cast<T*>(::operator new(bytes)), [](T* held) { ::operator delete(held); }};
  }

  std::shared_ptr<T> memory_;
  std::size_t size_ = 0;
};

}  // namespace meniscus::device
