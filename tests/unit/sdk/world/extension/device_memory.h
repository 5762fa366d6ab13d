// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What a user of a GPU does with its memory and streams, and the same on the CPU.
#pragma once

#include <meniscus/device_arrays.h>
#include <meniscus/hooks.h>

#include <cstring>
#include <vector>

namespace meniscus::tests {

#if MENISCUS_HAS_CUDA
void copy_from_gpu(void* host, const void* memory, std::size_t bytes, void* stream);
void* make_gpu_stream();
void destroy_gpu_stream(void* stream);
/// vector[i].y += by, on the stream.
void add_on_gpu(float* vectors, std::uint32_t count, float by, void* stream);
#endif

/// Waits for the stream of the array, and copies it to the host.
template <class T>
std::vector<T> on_host(const DeviceArray& array) {
  std::vector<T> values(static_cast<std::size_t>(array.shape[0]));
  const std::size_t bytes = values.size() * sizeof(T);
#if MENISCUS_HAS_CUDA
  if (array.on_cuda) {
    copy_from_gpu(values.data(), array.data, bytes, array.stream);
    return values;
  }
#endif
  if (bytes) std::memcpy(values.data(), array.data, bytes);
  return values;
}

/// Adds to the y of each vector of four floats, as a kernel on the GPU where there is one.
inline void add_y(float* vectors, std::uint32_t count, float by, const SubstepView& view) {
#if MENISCUS_HAS_CUDA
  if (view.on_cuda) return add_on_gpu(vectors, count, by, view.stream);
#endif
  static_cast<void>(view);
  for (std::uint32_t i = 0; i < count; ++i) vectors[4 * i + 1] += by;
}

}  // namespace meniscus::tests
