// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The CPU as a device: parallel loops over threads and SIMD lanes, reduce, scan and sort.
#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

#include "pbd/device/buffer.h"
#include "pbd/device/cpu/lanes.h"
#include "pbd/device/cpu/parallel_loop.h"
#include "pbd/device/cpu/wide_lanes.h"
#include "pbd/device/side_by_side.h"

namespace meniscus::pbd {

/// The cores of the processor, through oneTBB. Results do not depend on the number of threads.
class CpuDevice final : public Device {
 public:
  /// The scalar type of a neighbour loop: eight neighbours at a time.
  using Real = Lanes;
  using LaneIndex = pbd::LaneIndex;
  static constexpr uint32_t lane_count = Lanes::count;
  static constexpr bool interleaves_lists = false;  ///< see NeighbourView
  static constexpr bool runs_at_once = false;       ///< see at_once()
  using Lister = LaneLister;                        ///< tests candidates to list neighbours
  static bool leads() { return true; }

  enum class Registers { widest, baseline };

  /// threads = 0: one for each core. The choice of registers does not change the bits of the results.
  explicit CpuDevice(int threads = 0, Registers registers = Registers::widest);
  /// Without threads of its own: loops run in the user's.
  explicit CpuDevice(ParallelFor loop);

  DeviceKind kind() const override { return DeviceKind::cpu; }
  std::string name() const override;

  void copy_in(void* device_memory, const void* host, size_t bytes) override;
  void copy_out(void* host, const void* device_memory, size_t bytes) override;
  void copy(void* to, const void* from, size_t bytes) override;
  void fill(void* memory, unsigned char byte, size_t bytes) override;
  void wait() override {}
  void set_fence() override {}
  void wait_for_fence() override {}
  void mark_time(uint32_t mark) override;
  double elapsed_ms(uint32_t from, uint32_t to) const override;

  /// Runs kernel(i) for each i below count, concurrently and in any order. `name` describes the launch.
  template <class Kernel>
  void parallel_for(const char* /*name*/, uint32_t count, const Kernel& kernel) {
    if (count <= grain) {
      for (uint32_t i = 0; i < count; ++i) kernel(i);
      return;
    }
    loop(count, grain, [&](uint32_t begin, uint32_t end) {
      for (uint32_t i = begin; i < end; ++i) kernel(i);
    });
  }

  /// For loops over neighbours that a single GPU thread may run: calls kernel.run<D>(i) as parallel_for_long
  /// does, but never with a team.
  template <class Kernel>
  void parallel_for_neighbours(const char* name, uint32_t count, const Kernel& kernel) {
    parallel_for_long(name, count, kernel);
  }

  /// For kernels with long items: calls kernel.run<D>(i). D is this device, or CpuWide where the processor
  /// has AVX2, with the same bits. On a GPU with too few items to fill it D is CudaTeam, of which eight
  /// threads run each i.
  template <class Kernel>
  void parallel_for_long(const char* /*name*/, uint32_t count, const Kernel& kernel) {
    void (*const run)(const Kernel&, uint32_t, uint32_t) = choose_run<Kernel>();
    if (count <= grain) return run(kernel, 0, count);
    loop(count, grain, [&](uint32_t begin, uint32_t end) { run(kernel, begin, end); });
  }

  /// For kernels whose threads process as many items side by side as they have lanes: calls
  /// kernel.run(SideBySide<D>), with D as in parallel_for_long, but never a team.
  template <class Kernel>
  void parallel_for_lanes(const char* /*name*/, uint32_t count, const Kernel& kernel) {
    const ByLanes<Kernel> by_lanes{kernel, count};
    loop((count + lane_count - 1) / lane_count, grain / lane_count,
         [&, all = choose_run<ByLanes<Kernel>>()](uint32_t begin, uint32_t end) {
           all(by_lanes, begin, end);
         });
  }

  /// Runs kernel(group, scratch, n) for each n below count, each by a group of threads that share a scratch
  /// of type Kernel::Scratch. The kernel calls group.for_each(m, f), which runs f(i) for each i below m and
  /// waits for all of them. Here a group is one thread. On a GPU it is a block, with its scratch in shared
  /// memory. A thread has the lanes of D = Group::Device, as in parallel_for_long, but never a team. A kernel
  /// may have prepare(group, scratch, n), which runs first, on a GPU before earlier launches are done. It may
  /// only read memory that none of them writes.
  template <class Kernel>
  void parallel_for_groups(const char* /*name*/, uint32_t count, const Kernel& kernel) {
    run_in_one_thread(InOneThread<Kernel>{kernel}, count);
  }

  /// The same for kernels of which each thread processes as many n side by side as it has lanes. Runs
  /// kernel(group, scratch, k) for k below count over lanes, rounded up, with a scratch of type
  /// Kernel::Scratch<Group>.
  template <class Kernel>
  void parallel_for_lane_groups(const char* /*name*/, uint32_t count, const Kernel& kernel) {
    run_in_one_thread(LanesInOneThread<Kernel>{kernel}, (count + lane_count - 1) / lane_count);
  }

  /// Two independent launches of parallel_for_long, of which the second has fewer and longer items. A GPU
  /// runs them concurrently.
  template <class Kernel, class LongKernel>
  void parallel_for_both(const char* name, uint32_t count, const Kernel& kernel, uint32_t long_count,
                         const LongKernel& long_kernel) {
    parallel_for_long(name, count, kernel);
    parallel_for_long(name, long_count, long_kernel);
  }

  /// Runs two independent series of launches; a GPU runs them concurrently. At most one of the two may scan,
  /// reduce or sort, which share a scratch.
  template <class First, class Second>
  void at_once(const First& first, const Second& second) {
    first();
    second();
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

  /// out[i] = in[0] + … + in[i − 1], of unsigned integers. out has one element more than in: the total.
  /// note[0], where there is one, records the total.
  void exclusive_scan(const char* name, View<const uint32_t> in, View<uint32_t> out, uint32_t limit = ~0u,
                      View<SumNote> note = {});

  /// Sorts pairs by the low `bits` of the keys; equal keys keep their order. The inputs do not change.
  void sort_pairs(const char* name, View<const uint32_t> keys, View<uint32_t> sorted_keys,
                  View<const uint32_t> values, View<uint32_t> sorted_values, uint32_t bits);

 private:
  static constexpr uint32_t grain = 128;
  static constexpr uint32_t segment = 1024;

  /// Calls body(begin, end) for all of [0, count). It ends early if the call is cancelled.
  template <class Body>
  void loop(uint32_t count, uint32_t piece, const Body& body) {
    const CallMonitor& watched = monitor();
    parallel_loop(loop_of_user_, arena_, count, piece, [&](uint32_t begin, uint32_t end) {
      for (uint32_t next; begin < end && !watched.stops(); begin = next) {
        next = end - begin > piece ? begin + piece : end;
        body(begin, next);
      }
    });
    monitor().poll();
  }

  void* do_allocate(size_t bytes) override;
  void do_release(void* memory) noexcept override;
  void* do_allocate_shared(size_t bytes) override { return do_allocate(bytes); }
  void do_release_shared(void* memory) noexcept override { do_release(memory); }
  void radix_pass(View<const uint32_t> keys, View<uint32_t> keys_out, View<const uint32_t> values,
                  View<uint32_t> values_out, uint32_t shift, uint32_t digit_bits, View<uint32_t> offsets);

  template <class Kernel>
  struct ByLanes {
    const Kernel& kernel;
    uint32_t count;

    template <class D>
    void run(uint32_t k) const {
      kernel.run(SideBySide<D>(lane_count * k, count));
    }
  };

  template <class D>
  struct OneThread {
    using Device = D;
    static constexpr bool is_one_thread = true;

    template <class F>
    void for_each(uint32_t count, const F& f) const {
      for (uint32_t i = 0; i < count; ++i) f(i);
    }
  };

  template <class Kernel>
  struct InOneThread {
    const Kernel& kernel;

    template <class D>
    void run(uint32_t n) const {
      typename Kernel::Scratch scratch;
      const OneThread<D> group;
      if constexpr (requires { kernel.prepare(group, scratch, n); }) kernel.prepare(group, scratch, n);
      kernel(group, scratch, n);
    }
  };

  template <class Kernel>
  struct LanesInOneThread {
    const Kernel& kernel;

    template <class D>
    void run(uint32_t n) const {
      typename Kernel::template Scratch<OneThread<D>> scratch;
      const OneThread<D> group;
      if constexpr (requires { kernel.prepare(group, scratch, n); }) kernel.prepare(group, scratch, n);
      kernel(group, scratch, n);
    }
  };

  template <class Run>
  void run_in_one_thread(const Run& run, uint32_t count) {
    loop(count, 1, [&, all = choose_run<Run>()](uint32_t begin, uint32_t end) { all(run, begin, end); });
  }

  // All functions that the kernel calls are inlined, as only run_wide itself is compiled for AVX2.
  template <class Kernel>
  __attribute__((flatten)) static void run_lanes(const Kernel& kernel, uint32_t begin, uint32_t end) {
    for (uint32_t i = begin; i < end; ++i) kernel.template run<CpuDevice>(i);
  }
#ifdef MENISCUS_HAS_WIDE_LANES
  template <class Kernel>
  __attribute__((target("avx2"), flatten)) static void run_wide(const Kernel& kernel, uint32_t begin,
                                                                uint32_t end) {
    for (uint32_t i = begin; i < end; ++i) kernel.template run<CpuWide>(i);
  }
#endif
  template <class Kernel>
  auto choose_run() const -> void (*)(const Kernel&, uint32_t, uint32_t) {
#ifdef MENISCUS_HAS_WIDE_LANES
    if (wide_) return run_wide<Kernel>;
#endif
    return run_lanes<Kernel>;
  }

  template <class T>
  View<T> scratch(uint32_t count) {
    const size_t words = (count * sizeof(T) + sizeof(uint64_t) - 1) / sizeof(uint64_t);
    if (scratch_.size() < words) scratch_.resize_discard(std::max(words, 2 * scratch_.size()));
    return {reinterpret_cast<T*>(scratch_.view().data), count};
  }

  tbb::task_arena arena_;
  int threads_;  // 0: those of the user
  ParallelFor loop_of_user_;
  bool wide_;  // whether AVX2 is available and to be used
  Buffer<uint64_t> scratch_{*this, "CPU scratch"};
  std::vector<std::chrono::steady_clock::time_point> marks_;
};

}  // namespace meniscus::pbd
