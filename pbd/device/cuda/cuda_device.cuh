// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// An NVIDIA GPU as a device: parallel loops over threads, teams and blocks, and reductions.
#pragma once

#include <atomic>
#include <cub/block/block_reduce.cuh>
#include <exception>
#include <type_traits>
#include <utility>
#include <vector>

#include "pbd/device/buffer.h"
#include "pbd/device/cuda/batch.h"
#include "pbd/device/cuda/cuda_check.cuh"
#include "pbd/device/cuda/launch.cuh"
#include "pbd/device/cuda/launch_graphs.h"
#include "pbd/device/cuda/own_row.h"
#include "pbd/device/cuda/team.h"
#include "pbd/device/side_by_side.h"

namespace meniscus::pbd {

class CudaDevice;

namespace cuda_kernels {

constexpr uint32_t block_size = cuda_block_size;
constexpr uint32_t reduce_block = 256;
constexpr uint32_t segment = 1024;
constexpr uint32_t most_warps = 1u << 12;       // for particles at walls, beside teams for the others
constexpr uint32_t most_teams = 1u << 16;       // this many fill a large GPU
constexpr uint32_t most_half_teams = 1u << 17;  // likewise
constexpr uint32_t most_for_one_launch =
    7u << 15;  // items; above, occupancy matters more than the cost of a launch
constexpr uint32_t least_blocks_to_turn = 1024;  // with fewer blocks all data stay in the second-level cache

/// Only notes the time.
static __global__ void note_time_alone(TimeMark mark) {
  wait_for_previous(mark);
}

/// Copies words to the host's memory, and sets a flag there when it is done.
static __global__ void copy_words(TimeMark mark, const uint32_t* from, uint32_t* to, uint32_t words,
                                  volatile uint32_t* done) {
  wait_for_previous(mark);
  for (uint32_t i = threadIdx.x; i < words; i += block_size) to[i] = from[i];
  __threadfence_system();
  __syncthreads();
  if (threadIdx.x == 0) *done = 1;
}

/// How many blocks of a kernel a multiprocessor is to hold, if the kernel says so; else 0. The compiler then
/// spends the registers that this leaves on several gathers in flight. By default it saves registers, and
/// each gather waits for the one before.
template <class Kernel>
constexpr uint32_t resident_blocks() {
  if constexpr (requires { Kernel::resident_blocks; }) return Kernel::resident_blocks;
  return 0;
}

/// Launches over many items alternate their direction: the items that one processes last, the next finds in
/// the second-level cache. Each block has the items of block |turn − block|, where the turn is 0 or the last
/// block.
__device__ __forceinline__ uint32_t item_of_thread(uint32_t turn) {
  const int block = static_cast<int>(turn) - static_cast<int>(blockIdx.x);
  return static_cast<uint32_t>(block < 0 ? -block : block) * block_size + threadIdx.x;
}

template <class Kernel>
__global__ void __launch_bounds__(block_size, resident_blocks<Kernel>())
    for_each(TimeMark mark, uint32_t turn, uint32_t count, const __grid_constant__ Kernel kernel) {
  wait_for_previous(mark);
  const uint32_t i = item_of_thread(turn);
  if (i < count) kernel(i);
}

/// Threads of a group: as many as the kernel says, else 128.
template <class Kernel>
constexpr uint32_t group_size() {
  if constexpr (requires { Kernel::group_threads; }) return Kernel::group_threads;
  return 128;
}

/// See CpuDevice::parallel_for_groups.
template <uint32_t threads>
struct Block {
  using Device = CudaDevice;
  static constexpr bool is_one_thread = false;

  template <class F>
  __device__ void for_each(uint32_t count, const F& f) const {
    for (uint32_t i = threadIdx.x; i < count; i += threads) f(i);
    __syncthreads();
  }
  /// The same; returns whether f() is true of any. Only for groups of several threads.
  template <class F>
  __device__ bool any(uint32_t count, const F& f) const {
    bool found = false;
    for (uint32_t i = threadIdx.x; i < count; i += threads) found = f(i) || found;
    return __syncthreads_or(found);
  }
};

template <class Kernel>
using BlockOf = Block<group_size<Kernel>()>;

/// Whether a block can do part of its work while the previous launch still runs.
template <class Kernel, class Scratch>
constexpr bool prepares = requires(const Kernel& kernel, const BlockOf<Kernel>& block, Scratch& scratch) {
  kernel.prepare(block, scratch, 0u);
};

/// The part of a block that belongs to the kernel, with its preparation.
template <class Kernel, class Scratch>
__device__ void run_group(TimeMark mark, const Kernel& kernel, Scratch& scratch) {
  const BlockOf<Kernel> block;
  if constexpr (prepares<Kernel, Scratch>) {
    let_next_begin();
    kernel.prepare(block, scratch, blockIdx.x);
  }
  wait_for_previous(mark);
  kernel(block, scratch, blockIdx.x);
}

template <class Kernel>
__global__ void __launch_bounds__(group_size<Kernel>(), resident_blocks<Kernel>())
    for_each_group(TimeMark mark, const __grid_constant__ Kernel kernel) {
  __shared__ typename Kernel::Scratch scratch;
  run_group(mark, kernel, scratch);
}

template <class Kernel>
__global__ void __launch_bounds__(group_size<Kernel>())
    for_each_lane_group(TimeMark mark, const __grid_constant__ Kernel kernel) {
  __shared__ typename Kernel::template Scratch<BlockOf<Kernel>> scratch;
  run_group(mark, kernel, scratch);
}

template <class D, class Kernel>
struct RunLong {
  static constexpr uint32_t resident_blocks = cuda_kernels::resident_blocks<Kernel>();

  Kernel kernel;
  __device__ void operator()(uint32_t i) const { kernel.template run<D>(i); }
};

template <class D, class Kernel>
struct RunAlone {
  Kernel kernel;
  __device__ void operator()(uint32_t i) const { kernel.run(SideBySide<D>(i, i + 1)); }
};

/// The number of teams in a block.
template <class Team>
constexpr uint32_t teams = block_size / Team::lane_count;

template <class Team, class Kernel>
__global__ void __launch_bounds__(block_size)
    for_each_team(TimeMark mark, uint32_t count, const __grid_constant__ Kernel kernel) {
  wait_for_previous(mark);
  const uint32_t i = blockIdx.x * teams<Team> + threadIdx.x / Team::lane_count;
  if (i < count) kernel.template run<Team>(i);
}

// Two independent launches side by side in one stream. Only the first waits for the launches before it. The
// second begins when all blocks of the first have begun. So the first has few blocks, each of which processes
// many items, while those of the second run beside them.

template <class Kernel>
__global__ void __launch_bounds__(block_size, resident_blocks<Kernel>())
    for_each_beside_next(TimeMark mark, uint32_t count, const __grid_constant__ Kernel kernel) {
  wait_for_launch_before();
  let_next_begin();
  note_time(mark);
  for (uint32_t i = blockIdx.x * block_size + threadIdx.x; i < count; i += gridDim.x * block_size) kernel(i);
}

template <class Kernel>
__global__ void __launch_bounds__(block_size, resident_blocks<Kernel>())
    for_each_beside_previous(TimeMark, uint32_t turn, uint32_t count, const __grid_constant__ Kernel kernel) {
  let_next_begin();
  const uint32_t i = item_of_thread(turn);
  if (i < count) kernel(i);
  if (blockIdx.x == gridDim.x - 1)
    wait_for_launch_before();  // so that this launch does not end before the previous one
}

// Teams come first, because their work takes longer. A few of them need so many registers that others would
// not fit on the multiprocessor; those spill. Where teams are warps, there are fewer others.
template <class Team, class Others, class Kernel, class TeamKernel>
__global__ void __launch_bounds__(block_size, Team::lane_count > 8 ? 4 : 8)
    for_each_of_both(TimeMark mark, uint32_t count, const __grid_constant__ Kernel kernel,
                     uint32_t team_count, uint32_t team_blocks,
                     const __grid_constant__ TeamKernel team_kernel) {
  wait_for_previous(mark);
  if (blockIdx.x < team_blocks) {
    const uint32_t i = blockIdx.x * teams<Team> + threadIdx.x / Team::lane_count;
    if (i < team_count) team_kernel.template run<Team>(i);
  } else {
    const uint32_t i = (blockIdx.x - team_blocks) * teams<Others> + threadIdx.x / Others::lane_count;
    if (i < count) kernel.template run<Others>(i);
  }
}

// A block reduces one segment: each thread every 256th element, then CUB's fixed tree. The block that ends
// last reduces the segments' results in the same way. So the order is always the same.
template <class T, class Map, class Combine>
__global__ void __launch_bounds__(reduce_block)
    reduce_segments(TimeMark mark, uint32_t count, T identity, const __grid_constant__ Map map,
                    Combine combine, T* partial, uint32_t* blocks_done, T* out) {
  wait_for_previous(mark);
  using BlockReduce = cub::BlockReduce<T, reduce_block>;
  __shared__ typename BlockReduce::TempStorage storage;
  __shared__ bool is_last;
  const auto over = [&](uint32_t begin, uint32_t end, const auto& element) {
    T total = identity;
    for (uint32_t i = begin + threadIdx.x; i < end; i += reduce_block) total = combine(total, element(i));
    return BlockReduce(storage).Reduce(total, combine);
  };
  const T total = over(blockIdx.x * segment, min(count, (blockIdx.x + 1) * segment), map);
  if (threadIdx.x == 0) {
    partial[blockIdx.x] = total;
    __threadfence();
    is_last = atomicInc(blocks_done, gridDim.x - 1) == gridDim.x - 1;  // back at 0 after the last block
  }
  __syncthreads();
  if (!is_last) return;
  __threadfence();
  const T all = over(0, gridDim.x, [&](uint32_t i) { return partial[i]; });
  if (threadIdx.x == 0) *out = all;
}

}  // namespace cuda_kernels

/// The GPU of a device, and the caller's stream on it. Null: the device makes one of its own.
struct CudaPlace {
  int ordinal = 0;
  void* stream = nullptr;  ///< cudaStream_t
};

/// Memory of the current GPU; null if there is too little. Any other failure throws.
void* allocate_cuda(size_t bytes);

/// One NVIDIA GPU and one stream on it. Launches are collected until the host has to wait, or uses the stream
/// for something else, and then sent: see LaunchGraphs.
class CudaDevice final : public Device {
 public:
  /// The scalar type of a neighbour loop: one neighbour at a time, and a particle a thread.
  using Real = float;
  static constexpr uint32_t lane_count = 1;
  static constexpr bool interleaves_lists = true, runs_at_once = true;
  /// Up to this many items parallel_for_long uses a team for each, unless sums are fixed.
  static constexpr uint32_t most_teams = cuda_kernels::most_teams;
  using Lister = CudaLister<4>;
  MENISCUS_HD static bool leads() { return true; }

  /// Throws Error(invalid_argument) for the legacy default stream, on which no graph can be captured.
  explicit CudaDevice(CudaPlace place = {});
  ~CudaDevice() override;

  DeviceKind kind() const override { return DeviceKind::cuda; }
  std::string name() const override { return name_; }
  int ordinal() const { return place_.ordinal; }
  /// For the work of others. All earlier launches and time marks are on it.
  void* stream_for_others() {
    flush_mark();
    return stream();
  }

  void copy_in(void* device_memory, const void* host, size_t bytes) override;
  void copy_out(void* host, const void* device_memory, size_t bytes) override;
  void copy(void* to, const void* from, size_t bytes) override;
  void fill(void* memory, unsigned char byte, size_t bytes) override;
  void wait() override;
  void send_off() override;
  void set_fence() override;
  void wait_for_fence() override;
  void mark_time(uint32_t mark) override;
  double elapsed_ms(uint32_t from, uint32_t to) const override;
  /// For the work of other libraries. All earlier launches are on it.
  cudaStream_t stream() {
    send_off();
    return streams_.of(on_side_);
  }
  /// How often a graph was launched instead of a list of launches.
  uint64_t graphs_sent() const { return graphs_.sent(); }

  /// See CpuDevice, whose members these mirror.
  template <class Kernel>
  void parallel_for(const char* name, uint32_t count, const Kernel& kernel) {
    if (count == 0) return;
    using namespace cuda_kernels;
    if (count >= busy_without_lists) end_list();
    const uint32_t blocks = (count + block_size - 1) / block_size;
    launch(name, blocks, block_size, for_each<Kernel>, next_turn(blocks), count, kernel);
  }

  template <class Kernel>
  void parallel_for_neighbours(const char* name, uint32_t count, const Kernel& kernel) {
    using namespace cuda_kernels;
    if (fixes_sums() || count > most_half_teams)
      return parallel_for(name, count, RunLong<CudaDevice, Kernel>{kernel});
    run_teams<CudaHalfTeam>(name, count, kernel);
  }

  template <class Kernel>
  void parallel_for_lanes(const char* name, uint32_t count, const Kernel& kernel) {
    parallel_for(name, count, cuda_kernels::RunAlone<CudaDevice, Kernel>{kernel});
  }

  template <class Kernel>
  void parallel_for_groups(const char* name, uint32_t count, const Kernel& kernel) {
    using namespace cuda_kernels;
    run_groups<typename Kernel::Scratch>(name, count, for_each_group<Kernel>, kernel);
  }

  template <class Kernel>
  void parallel_for_lane_groups(const char* name, uint32_t count, const Kernel& kernel) {
    using namespace cuda_kernels;
    run_groups<typename Kernel::template Scratch<BlockOf<Kernel>>>(name, count, for_each_lane_group<Kernel>,
                                                                   kernel);
  }

  template <class Kernel>
  void parallel_for_long(const char* name, uint32_t count, const Kernel& kernel) {
    using namespace cuda_kernels;
    if (fixes_sums() || count > most_teams)
      return parallel_for(name, count, RunLong<CudaDevice, Kernel>{kernel});
    run_teams<CudaTeam>(name, count, kernel);
  }

  template <class Kernel, class LongKernel>
  void parallel_for_both(const char* name, uint32_t count, const Kernel& kernel, uint32_t long_count,
                         const LongKernel& long_kernel) {
    using namespace cuda_kernels;
    const bool by_threads = fixes_sums() || count > most_for_one_launch;
    if (overlaps_launches_ && by_threads && count > 0 && long_count > 0) {
      // In one launch the first kernel would be limited to the second one's registers. Beside it, one thread
      // for each item is the least work, however few items there are.
      launch(name, blocks_beside(count, long_count), block_size,
             for_each_beside_next<RunLong<CudaDevice, LongKernel>>, long_count,
             RunLong<CudaDevice, LongKernel>{long_kernel});
      const uint32_t blocks = (count + block_size - 1) / block_size;
      launch(name, blocks, block_size, for_each_beside_previous<RunLong<CudaDevice, Kernel>>,
             next_turn(blocks), count, RunLong<CudaDevice, Kernel>{kernel});
      return;
    }
    if (fixes_sums()) {
      parallel_for(name, count, RunLong<CudaDevice, Kernel>{kernel});
      parallel_for(name, long_count, RunLong<CudaDevice, LongKernel>{long_kernel});
    } else if (count <= most_warps) {
      run_both<CudaWarp, CudaTeam>(name, count, kernel, long_count, long_kernel);
    } else if (count <= most_teams) {
      run_both<CudaTeam, CudaDevice>(name, count, kernel, long_count, long_kernel);
    } else {  // beside work that fills the GPU by itself: the variant with the least total work
      run_both<CudaHalfTeam, CudaDevice>(name, count, kernel, long_count, long_kernel);
    }
  }

  template <class First, class Second>
  void at_once(const First& first, const Second& second) {
    fork();
    const Joining joining{*this};
    {
      const OnSideStream on_side(*this);
      second();
    }
    first();
  }

  template <class T, class Map, class Combine>
  void reduce(const char* name, uint32_t count, T identity, const Map& map, const Combine& combine,
              View<T> out) {
    using namespace cuda_kernels;
    const uint32_t segments = count ? (count + segment - 1) / segment : 1;
    T* partial = static_cast<T*>(scratch(segments * sizeof(T)));
    launch(name, segments, reduce_block, reduce_segments<T, Map, Combine>, count, identity, map, combine,
           partial, blocks_done_.view().data, out.data);
  }

  void exclusive_scan(const char* name, View<const uint32_t> in, View<uint32_t> out, uint32_t limit = ~0u,
                      View<SumNote> note = {});
  void sort_pairs(const char* name, View<const uint32_t> keys, View<uint32_t> sorted_keys,
                  View<const uint32_t> values, View<uint32_t> sorted_values, uint32_t bits);

 private:
  void* do_allocate(size_t bytes) override;
  void do_release(void* memory) noexcept override;
  void* do_allocate_shared(size_t bytes) override;
  void do_release_shared(void* memory) noexcept override;
  void* scratch(size_t bytes);
  int carveout_for(uint32_t blocks, size_t scratch_bytes) const;
  void flush_mark();
  void wait_until_set(const volatile uint32_t* flag) const;
  /// See item_of_thread().
  uint32_t next_turn(uint32_t blocks) {
    if (blocks < cuda_kernels::least_blocks_to_turn) return 0;
    goes_back_ = !goes_back_;
    return goes_back_ ? blocks - 1 : 0;
  }
  uint32_t blocks_beside(uint32_t count, uint32_t long_count) const;
  void fork();           // later launches on the side stream follow the earlier ones on the main stream
  void join() noexcept;  // later launches follow those on the side stream

  struct Joining {
    CudaDevice& device;
    ~Joining() { device.join(); }
  };
  /// While such an object exists, launches go to the side stream.
  struct OnSideStream {
    explicit OnSideStream(CudaDevice& on) : device(on) { device.on_side_ = true; }
    ~OnSideStream() { device.on_side_ = false; }
    CudaDevice& device;
  };

  template <class Team>
  static uint32_t blocks_of(uint32_t count) {
    return (count + cuda_kernels::teams<Team> - 1) / cuda_kernels::teams<Team>;
  }
  template <class Team, class Kernel>
  void run_teams(const char* name, uint32_t count, const Kernel& kernel) {
    using namespace cuda_kernels;
    if (count) launch(name, blocks_of<Team>(count), block_size, for_each_team<Team, Kernel>, count, kernel);
  }
  /// By default the driver reserves as much first-level cache for scratch memory as a full set of blocks
  /// would use. With few blocks that memory serves better as cache for their gathers.
  template <class Scratch, class Kernel>
  void run_groups(const char* name, uint32_t count, void (*run)(cuda_kernels::TimeMark, Kernel),
                  const Kernel& kernel) {
    if (count == 0) return;
    static std::atomic<int> last = cudaSharedmemCarveoutDefault;  // over the launches of all worlds
    const int carveout = carveout_for(count, sizeof(Scratch));
    if (last.exchange(carveout) != carveout)
      check_cuda(cudaFuncSetAttribute(run, cudaFuncAttributePreferredSharedMemoryCarveout, carveout), name);
    // A kernel that prepares, and fills the GPU, is slower in a graph.
    if (cuda_kernels::prepares<Kernel, Scratch> && count > multiprocessors_) end_list();
    launch(name, count, cuda_kernels::group_size<Kernel>(), run, kernel);
  }
  template <class Team, class Others, class Kernel, class TeamKernel>
  void run_both(const char* name, uint32_t count, const Kernel& kernel, uint32_t team_count,
                const TeamKernel& team_kernel) {
    using namespace cuda_kernels;
    const uint32_t team_blocks = blocks_of<Team>(team_count);
    const uint32_t blocks = team_blocks + blocks_of<Others>(count);
    if (blocks == 0) return;
    launch(name, blocks, block_size, for_each_of_both<Team, Others, Kernel, TeamKernel>, count, kernel,
           team_count, team_blocks, team_kernel);
  }

  /// A launch of this many threads keeps the GPU busy while others are sent. In a graph, the launches of the
  /// pressure grid would be slower.
  static constexpr uint32_t busy_without_lists = 1'000'000;

  template <class... Parameters>
  void launch(const char* name, uint32_t blocks, uint32_t threads,
              void (*kernel)(cuda_kernels::TimeMark, Parameters...),
              std::type_identity_t<Parameters>... parameters) {
    cuda_kernels::TimeMark mark = std::exchange(pending_mark_, {});
    const CudaLaunch launch{name, reinterpret_cast<const void*>(kernel), blocks, threads, overlaps_launches_};
    if (has_list()) return list_.add(launch, on_side_, mark, parameters...);
    void* arguments[] = {&mark, &parameters...};
    launch.send(streams_.of(on_side_), arguments);
  }
  bool has_list();
  void end_list();
  void send_list();
  void send_list_or_note() noexcept;

  /// Clears the list, whether sending it succeeds or not.
  struct Clearing {
    LaunchList& list;
    ~Clearing() { list.clear(); }
  };

  CudaPlace place_;
  CudaStreams streams_;
  cudaEvent_t fence_ = nullptr;
  bool on_side_ = false;    // the stream of the next launch
  bool is_listing_ = true;  // whether launches are collected until the next send_off()
  LaunchList list_;
  LaunchGraphs graphs_;
  std::exception_ptr failure_;  // of a list that was sent where nothing may be thrown
  std::string name_;
  bool overlaps_launches_ = false;
  bool goes_back_ = false;  // the direction of the last launch over many items
  uint32_t multiprocessors_ = 1;
  size_t multiprocessor_bytes_ = 0;        // of scratch memory
  cuda_kernels::TimeMark pending_mark_{};  // for the next launch
  uint64_t* times_ = nullptr;              // pinned, written by kernels
  uint32_t times_capacity_ = 0;
  bool is_read_open_ = false;  // copy_out has launched a kernel, and has not seen its flag
  uint32_t* pinned_ =
      nullptr;  // receives small results, followed by a word that is set when they are complete
  Buffer<uint64_t> scratch_{*this, "CUDA scratch"};
  Buffer<uint64_t> tile_sums_{*this, "CUDA prefix sums"};
  uint32_t scans_ = 0;
  Buffer<uint32_t> blocks_done_{*this, "CUDA block count"};  // 0 between launches
};

}  // namespace meniscus::pbd
