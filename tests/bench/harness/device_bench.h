// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The parallel algorithms of a device with the device's type hidden, so that one test body serves all of
// them.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "pbd/device/device.h"
#include "pbd/device/scalar.h"

namespace meniscus::tests {

struct SortedPairs {
  std::vector<uint32_t> keys, places;  ///< places: where each key stood before
};

class DeviceBench {
 public:
  virtual ~DeviceBench() = default;

  virtual pbd::Device& device() = 0;
  virtual SortedPairs sort(std::span<const uint32_t> keys, uint32_t bits) = 0;
  /// With a note, that is taken on.
  virtual std::vector<uint32_t> scan(std::span<const uint32_t> values, uint32_t limit = ~0u,
                                     pbd::SumNote* note = nullptr) = 0;
  virtual float sum(std::span<const float> values) = 0;
  /// How often parallel_for ran each index below count, and one element more.
  virtual std::vector<uint32_t> visits(uint32_t count) = 0;
  /// What rounds of the same work leave, each of which starts from nothing: launches that each count `count`
  /// visits, on two streams, and one that counts round % period less; a copy, and a sum. Then the host waits.
  virtual std::vector<uint32_t> rounds(uint32_t count, uint32_t launches, uint32_t rounds,
                                       uint32_t period = 1) = 0;
  /// What a kernel is given in an array of pairs, with a flag and a number behind it: twice their sums, and
  /// the number.
  virtual std::vector<float> doubled(const std::array<float, 32>& pairs, float number) = 0;
  /// How often a list of launches was sent as a graph.
  virtual uint64_t graphs_sent() const = 0;
  /// A buffer that held 0, 1, 2, … after resize_keep(size, kept); the first `kept` elements.
  virtual std::vector<uint32_t> resized(uint32_t from, uint32_t size, uint32_t kept) = 0;
};

std::unique_ptr<DeviceBench> make_cpu_bench(int threads);
std::unique_ptr<DeviceBench> make_cuda_bench();

inline std::unique_ptr<DeviceBench> make_device_bench(pbd::DeviceKind kind) {
#if MENISCUS_HAS_CUDA
  if (kind == pbd::DeviceKind::cuda) return make_cuda_bench();
#endif
  return kind == pbd::DeviceKind::cpu ? make_cpu_bench(0) : nullptr;
}

}  // namespace meniscus::tests
