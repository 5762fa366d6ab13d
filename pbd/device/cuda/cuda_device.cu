// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Memory, copies, time marks, scan and sort of the GPU device, and when its launches are sent.
#include "pbd/device/cuda/cuda_device.cuh"

#include <algorithm>
#include <cstring>
#include <cub/device/device_radix_sort.cuh>

#include "pbd/device/cuda/scan.cuh"

namespace meniscus::pbd {

namespace {

constexpr size_t pinned_bytes = 4096;

struct FillWords {
  uint32_t* at;
  uint32_t words, word;

  __device__ void operator()(uint32_t i) const {
    const uint32_t first = 4 * i;
    if (first + 4 <= words) {
      reinterpret_cast<uint4*>(at)[i] = {word, word, word, word};
    } else {
      for (uint32_t k = first; k < words; ++k) at[k] = word;
    }
  }
};

}  // namespace

CudaDevice::CudaDevice(CudaPlace place) : place_(place) {
  if (place.stream == cudaStreamLegacy)
    throw Error(ErrorCode::invalid_argument,
                "WorldDef::cuda_stream is the legacy default stream; it must be a stream of its own");
  cudaDeviceProp properties;
  check_cuda(cudaGetDeviceProperties(&properties, place.ordinal), "reading the device's properties");
  name_ = properties.name;
  overlaps_launches_ = properties.major >= 9;
  multiprocessors_ = static_cast<uint32_t>(properties.multiProcessorCount);
  multiprocessor_bytes_ = properties.sharedMemPerMultiprocessor;
  streams_.main = static_cast<cudaStream_t>(place.stream);
  if (!place.stream)
    check_cuda(cudaStreamCreateWithFlags(&streams_.main, cudaStreamNonBlocking), "creating a stream");
  // Launches on the side stream have few threads and run long, so they get the highest priority.
  int least = 0, most = 0;
  check_cuda(cudaDeviceGetStreamPriorityRange(&least, &most), "reading the stream priorities");
  check_cuda(cudaStreamCreateWithPriority(&streams_.side, cudaStreamNonBlocking, most), "creating a stream");
  for (cudaEvent_t* event : {&streams_.forked, &streams_.joined, &fence_})
    check_cuda(cudaEventCreateWithFlags(event, cudaEventDisableTiming), "creating an event");
  check_cuda(cudaMallocHost(&pinned_, pinned_bytes + sizeof(uint32_t)), "allocating pinned memory");
  blocks_done_.resize_discard(1);
  blocks_done_.fill(0);
  list_.reserve(LaunchGraphs::longest + 2);  // with a fork and a join that come last
}

CudaDevice::~CudaDevice() {
  list_.clear();
  cudaStreamSynchronize(streams_.main);
  scratch_.resize_discard(0);
  tile_sums_.resize_discard(0);
  blocks_done_.resize_discard(0);
  for (cudaEvent_t event : {streams_.forked, streams_.joined, fence_}) cudaEventDestroy(event);
  cudaFreeHost(pinned_);
  cudaFreeHost(times_);
  cudaStreamDestroy(streams_.side);
  if (!place_.stream) cudaStreamDestroy(streams_.main);
}

void* CudaDevice::do_allocate(size_t bytes) {
  return allocate_cuda(bytes);
}

void* allocate_cuda(size_t bytes) {
  void* memory = nullptr;
  const cudaError_t status = cudaMalloc(&memory, bytes);
  if (status == cudaErrorMemoryAllocation) {
    cudaGetLastError();  // clears it: the caller reports the error, and the device stays usable
    return nullptr;
  }
  check_cuda(status, "allocating memory");
  return memory;
}

/// Earlier launches may still use the memory: cudaFree waits for them.
void CudaDevice::do_release(void* memory) noexcept {
  send_list_or_note();
  cudaFree(memory);
}

void* CudaDevice::do_allocate_shared(size_t bytes) {
  void* memory = nullptr;
  if (cudaMallocHost(&memory, bytes) == cudaSuccess) return memory;
  cudaGetLastError();
  return nullptr;
}

void CudaDevice::do_release_shared(void* memory) noexcept {
  send_list_or_note();
  cudaFreeHost(memory);
}

void* CudaDevice::scratch(size_t bytes) {
  const size_t words = (bytes + sizeof(uint64_t) - 1) / sizeof(uint64_t);
  if (scratch_.size() < words) {
    wait();
    scratch_.resize_discard(std::max(words, scratch_.size() + scratch_.size() / 2));
  }
  return scratch_.view().data;
}

/// The fraction of a multiprocessor's memory, in percent, that so many concurrent blocks use.
int CudaDevice::carveout_for(uint32_t blocks, size_t scratch_bytes) const {
  constexpr size_t of_system = 1024;  // bytes a block
  const size_t bytes = (blocks + multiprocessors_ - 1) / multiprocessors_ * (scratch_bytes + of_system);
  if (bytes >= multiprocessor_bytes_) return cudaSharedmemCarveoutDefault;
  return static_cast<int>((100 * bytes + multiprocessor_bytes_ - 1) / multiprocessor_bytes_);
}

void CudaDevice::copy_in(void* device_memory, const void* host, size_t bytes) {
  check_cuda(cudaMemcpyAsync(device_memory, host, bytes, cudaMemcpyHostToDevice, stream()),
             "copying to the GPU");
}

/// Small copies use a kernel, which need not wait as a copy would, and can note the time.
void CudaDevice::copy_out(void* host, const void* device_memory, size_t bytes) {
  const bool in_words = (reinterpret_cast<uintptr_t>(device_memory) | bytes) % sizeof(uint32_t) == 0;
  if (!in_words || bytes > pinned_bytes) {
    check_cuda(cudaMemcpyAsync(host, device_memory, bytes, cudaMemcpyDeviceToHost, stream()),
               "copying from the GPU");
    return wait();
  }
  // The kernel of a read that failed before it was awaited may still set the flag.
  if (std::exchange(is_read_open_, true)) wait();
  volatile uint32_t* const done = pinned_ + pinned_bytes / sizeof(uint32_t);
  *done = 0;
  launch("copying from the GPU", 1, cuda_kernels::block_size, cuda_kernels::copy_words,
         static_cast<const uint32_t*>(device_memory), pinned_,
         static_cast<uint32_t>(bytes / sizeof(uint32_t)), done);
  send_off();
  wait_until_set(done);
  is_read_open_ = false;
  std::memcpy(host, pinned_, bytes);
}

/// The flag is set before the stream reports completion.
void CudaDevice::wait_until_set(const volatile uint32_t* flag) const {
  constexpr uint32_t patience = 1u << 16;  // polls, before the stream is asked whether it has failed
  for (uint32_t looks = 1; !*flag; ++looks) {
    if (looks % patience) continue;
    const cudaError_t status = cudaStreamQuery(streams_.of(on_side_));
    if (status == cudaErrorNotReady) continue;
    check_cuda(status, "running the kernels launched before");
    break;
  }
  std::atomic_thread_fence(std::memory_order_acquire);
}

void CudaDevice::copy(void* to, const void* from, size_t bytes) {
  if (has_list()) return list_.add_copy(to, from, bytes, on_side_);
  check_cuda(cudaMemcpyAsync(to, from, bytes, cudaMemcpyDeviceToDevice, streams_.of(on_side_)),
             "copying on the GPU");
}

void CudaDevice::fill(void* memory, unsigned char byte, size_t bytes) {
  // cudaMemsetAsync would separate two launches, so a kernel fills the memory.
  const uint32_t word = 0x01010101u * byte;
  const bool is_aligned = reinterpret_cast<uintptr_t>(memory) % sizeof(uint4) == 0;
  if (is_aligned && bytes % sizeof(uint32_t) == 0 && bytes < size_t{1} << 32) {
    const auto words = static_cast<uint32_t>(bytes / sizeof(uint32_t));
    parallel_for("filling memory", (words + 3) / 4, FillWords{static_cast<uint32_t*>(memory), words, word});
  } else {
    check_cuda(cudaMemsetAsync(memory, byte, bytes, stream()), "filling memory");
  }
}

/// Whether launches are collected at present. A list that reaches the limit is sent at once.
bool CudaDevice::has_list() {
  if (list_.size() >= LaunchGraphs::longest) end_list();
  return is_listing_;
}

/// Sends the list; launches are sent directly until the next send_off().
void CudaDevice::end_list() {
  if (!is_listing_) return;
  is_listing_ = false;
  graphs_.note_miss();
  const Clearing clearing{list_};
  list_.send(streams_);
}

void CudaDevice::send_off() {
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  send_list();
}

void CudaDevice::send_list() {
  if (!is_listing_) graphs_.note_none();
  is_listing_ = graphs_.wants_lists();
  goes_back_ = false;  // otherwise every second list would have the opposite order of blocks
  if (list_.empty()) return;
  const Clearing clearing{list_};
  graphs_.send(list_, streams_);
}

/// For places that must not throw: the next send_off() throws instead.
void CudaDevice::send_list_or_note() noexcept {
  try {
    send_list();
  } catch (...) {
    failure_ = std::current_exception();
  }
}

void CudaDevice::wait() {
  flush_mark();
  check_cuda(cudaStreamSynchronize(stream()), "running the kernels launched before");
}

void CudaDevice::set_fence() {
  check_cuda(cudaEventRecord(fence_, stream()), "recording an event");
}

void CudaDevice::wait_for_fence() {
  flush_mark();
  send_off();
  check_cuda(cudaEventSynchronize(fence_), "running the kernels launched before");
}

void CudaDevice::fork() {
  has_list() ? list_.add_fork() : streams_.fork();
}

void CudaDevice::join() noexcept {
  is_listing_ ? list_.add_join() : streams_.join();
}

/// The number of blocks for long items beside `count` others, such that they take about half as long as the
/// others.
uint32_t CudaDevice::blocks_beside(uint32_t count, uint32_t long_count) const {
  using cuda_kernels::block_size;
  constexpr uint32_t resident = 10;  // blocks of the others on a multiprocessor, if they run alone
  const uint32_t waves = count / (multiprocessors_ * resident * block_size);
  return (long_count + block_size - 1) / block_size / std::max(1u, waves / 2) + 1;
}

void CudaDevice::mark_time(uint32_t mark) {
  flush_mark();
  if (mark >= times_capacity_) {
    wait();
    uint64_t* more = nullptr;
    const uint32_t capacity = std::max(256u, 2 * mark);
    check_cuda(cudaMallocHost(&more, capacity * sizeof(uint64_t)), "allocating pinned memory");
    std::copy(times_, times_ + times_capacity_, more);
    cudaFreeHost(times_);
    times_ = more;
    times_capacity_ = capacity;
  }
  pending_mark_.at = times_ + mark;
}

/// For a mark that no launch has noted.
void CudaDevice::flush_mark() {
  if (pending_mark_.at) launch("note time", 1, 1, cuda_kernels::note_time_alone);
}

double CudaDevice::elapsed_ms(uint32_t from, uint32_t to) const {
  return 1e-6 * static_cast<double>(times_[to] - times_[from]);
}

void CudaDevice::exclusive_scan(const char* name, View<const uint32_t> in, View<uint32_t> out, uint32_t limit,
                                View<SumNote> note) {
  using namespace cuda_kernels;
  const uint32_t tiles = in.count ? (in.count + scan_tile - 1) / scan_tile : 1;
  if (tile_sums_.size() < tiles + 1 || scans_ == TileSums::most_runs) {
    wait();
    tile_sums_.resize_discard(std::max<size_t>(tiles + 1 + tiles / 2, tile_sums_.size()));
    tile_sums_.fill(0);
    scans_ = 0;
  }
  ++scans_;
  uint64_t* const memory = tile_sums_.view().data;
  launch(name, tiles, scan_block, scan_tiles, in, out.data, note, SumUpTo{limit}, memory, memory + 1);
}

void CudaDevice::sort_pairs(const char* name, View<const uint32_t> keys, View<uint32_t> sorted_keys,
                            View<const uint32_t> values, View<uint32_t> sorted_values, uint32_t bits) {
  const auto sort = [&](void* memory, size_t& bytes) {
    check_cuda(
        cub::DeviceRadixSort::SortPairs(memory, bytes, keys.data, sorted_keys.data, values.data,
                                        sorted_values.data, keys.count, 0, static_cast<int>(bits), stream()),
        name);
  };
  size_t bytes = 0;
  sort(nullptr, bytes);
  sort(scratch(bytes), bytes);
}

}  // namespace meniscus::pbd
