// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "pbd/device/buffer.h"
#include "pbd/device/cpu/lanes.h"
#include "pbd/device/scalar.h"

namespace meniscus::pbd {

/// The processor's cores, through oneTBB. Results do not depend on the number of threads.
class CpuDevice final : public Device {
 public:
  /// What a neighbour loop runs on: eight neighbours at a time.
  using Real = Lanes;
  using LaneIndex = pbd::LaneIndex;
  static constexpr uint32_t lane_count = Lanes::count;

  /// threads = 0: one a core.
  explicit CpuDevice(int threads = 0);

  DeviceKind kind() const override { return DeviceKind::cpu; }
  std::string name() const override;

  void copy_in(void* device_memory, const void* host, size_t bytes) override;
  void copy_out(void* host, const void* device_memory, size_t bytes) override;
  void copy(void* to, const void* from, size_t bytes) override;
  void fill(void* memory, unsigned char byte, size_t bytes) override;
  void wait() override {}
  void mark_time(uint32_t mark) override;
  double elapsed_ms(uint32_t from, uint32_t to) const override;

  /// Runs kernel(i) for each i below count, in any order and at once. `name` says what the launch does.
  template <class Kernel>
  void parallel_for(const char* /*name*/, uint32_t count, const Kernel& kernel) {
    if (count <= grain) {
      for (uint32_t i = 0; i < count; ++i) kernel(i);
      return;
    }
    arena_.execute([&] {
      tbb::parallel_for(tbb::blocked_range<uint32_t>(0, count, grain),
                        [&](const tbb::blocked_range<uint32_t>& range) {
                          for (uint32_t i = range.begin(); i < range.end(); ++i) kernel(i);
                        });
    });
  }

  /// out[0] = combine over map(i) for all i below count, in segments of fixed size: the same bits each time.
  template <class T, class Map, class Combine>
  void reduce(const char* name, uint32_t count, T identity, const Map& map, const Combine& combine,
              View<T> out) {
    const uint32_t segments = (count + segment - 1) / segment;
    View<T> partial = scratch<T>(segments);
    parallel_for(name, segments, [=](uint32_t s) {
      T total = identity;
      for (uint32_t i = s * segment; i < std::min(count, (s + 1) * segment); ++i)
        total = combine(total, map(i));
      partial[s] = total;
    });
    T total = identity;
    for (uint32_t s = 0; s < segments; ++s) total = combine(total, partial[s]);
    out[0] = total;
  }

  /// out[i] = in[0] + … + in[i − 1]; out has one element more than in: the total.
  void exclusive_scan(const char* name, View<const uint32_t> in, View<uint32_t> out);

  /// Sorts pairs by the low `bits` of the keys; equal keys keep their order. The inputs are left as they
  /// were.
  void sort_pairs(const char* name, View<const uint32_t> keys, View<uint32_t> sorted_keys,
                  View<const uint32_t> values, View<uint32_t> sorted_values, uint32_t bits);

 private:
  static constexpr uint32_t grain = 128;
  static constexpr uint32_t segment = 1024;

  void* do_allocate(size_t bytes) override;
  void do_release(void* memory) noexcept override;
  void radix_pass(View<const uint32_t> keys, View<uint32_t> keys_out, View<const uint32_t> values,
                  View<uint32_t> values_out, uint32_t shift, uint32_t digit_bits, View<uint32_t> offsets);

  template <class T>
  View<T> scratch(uint32_t count) {
    const auto words = static_cast<uint32_t>((count * sizeof(T) + sizeof(uint64_t) - 1) / sizeof(uint64_t));
    if (scratch_.size() < words) scratch_.resize_discard(std::max(words, 2 * scratch_.size()));
    return {reinterpret_cast<T*>(scratch_.view().data), count};
  }

  tbb::task_arena arena_;
  int threads_;
  Buffer<uint64_t> scratch_{*this, "CPU scratch"};
  std::vector<std::chrono::steady_clock::time_point> marks_;
};

}  // namespace meniscus::pbd
