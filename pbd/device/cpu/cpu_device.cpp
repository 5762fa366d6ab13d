// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Memory, scan and radix sort of the CPU device.
#include "pbd/device/cpu/cpu_device.h"

#include <tbb/info.h>

#include <meniscus/error.h>
#include <pthread.h>

#include <cstdlib>
#include <cstring>
#include <latch>
#include <utility>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace meniscus::pbd {

namespace {

constexpr uint32_t sort_block =
    8192;  // elements; fixed, so that the order does not depend on the number of threads

bool has_wide_lanes() {
#ifdef MENISCUS_HAS_WIDE_LANES
  return __builtin_cpu_supports("avx2");
#else
  return false;
#endif
}

/// Starts and ends this many threads at once. oneTBB starts its own when there is work, some of them from one
/// another, where a failure ends the process. So a failure is found here first. The C library keeps the
/// stacks of these threads for those of oneTBB.
int tried(int threads) {
  constexpr size_t stack = size_t{4} << 20;  // bytes, as oneTBB asks for
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, stack);
  std::latch all_started(1);
  const auto wait = [](void* latch) -> void* {
    static_cast<std::latch*>(latch)->wait();
    return nullptr;
  };
  std::vector<pthread_t> started;
  started.reserve(static_cast<size_t>(threads));
  int failure = 0;
  while (failure == 0 && static_cast<int>(started.size()) + 1 < threads) {
    pthread_t thread;
    failure = pthread_create(&thread, &attributes, wait, &all_started);
    if (failure == 0) started.push_back(thread);
  }
  all_started.count_down();
  for (const pthread_t thread : started) pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
  if (failure == 0) return threads;
  throw Error(ErrorCode::out_of_memory, "the system has room for " + std::to_string(started.size() + 1) +
                                            " of the " + std::to_string(threads) +
                                            " threads of the CPU device. Fewer may be asked for");
}

int threads_or_all(int threads) {
  return threads > 0 ? threads : tbb::info::default_concurrency();
}

}  // namespace

CpuDevice::CpuDevice(int threads, Registers registers)
    : arena_(tried(threads_or_all(threads))),
      threads_(threads_or_all(threads)),
      wide_(registers == Registers::widest && has_wide_lanes()) {}

CpuDevice::CpuDevice(ParallelFor loop)
    : arena_(1), threads_(0), loop_of_user_(std::move(loop)), wide_(has_wide_lanes()) {}

std::string CpuDevice::name() const {
  if (loop_of_user_) return "CPU, threads of the program";
  return "CPU, " + std::to_string(threads_) + (threads_ == 1 ? " thread" : " threads");
}

void* CpuDevice::do_allocate(size_t bytes) {
  const auto aligned = [bytes](size_t to) { return std::aligned_alloc(to, (bytes + to - 1) / to * to); };
#ifdef __linux__
  // Neighbour lists and the particles in them are accessed at random. With small pages most accesses would
  // miss the TLB.
  constexpr size_t large_page = size_t{1} << 21;
  if (bytes >= 4 * large_page) {
    void* const memory = aligned(large_page);
    if (memory) madvise(memory, bytes, MADV_HUGEPAGE);
    return memory;
  }
#endif
  return aligned(64);
}

void CpuDevice::do_release(void* memory) noexcept {
  std::free(memory);
}

// An array of no bytes may have no memory, and memcpy must not be given a null pointer.
void CpuDevice::copy_in(void* device_memory, const void* host, size_t bytes) {
  if (bytes) std::memcpy(device_memory, host, bytes);
}

void CpuDevice::copy_out(void* host, const void* device_memory, size_t bytes) {
  if (bytes) std::memcpy(host, device_memory, bytes);
}

void CpuDevice::copy(void* to, const void* from, size_t bytes) {
  if (bytes) std::memcpy(to, from, bytes);
}

void CpuDevice::fill(void* memory, unsigned char byte, size_t bytes) {
  if (bytes) std::memset(memory, byte, bytes);
}

void CpuDevice::mark_time(uint32_t mark) {
  if (marks_.size() <= mark) marks_.resize(mark + 1);
  marks_[mark] = std::chrono::steady_clock::now();
}

double CpuDevice::elapsed_ms(uint32_t from, uint32_t to) const {
  return std::chrono::duration<double, std::milli>(marks_[to] - marks_[from]).count();
}

void CpuDevice::exclusive_scan(const char* name, View<const uint32_t> in, View<uint32_t> out, uint32_t limit,
                               View<SumNote> note) {
  const SumUpTo sum{limit};
  const uint32_t count = in.count;
  const uint32_t blocks = (count + sort_block - 1) / sort_block;
  View<uint32_t> base = scratch<uint32_t>(blocks + 1);
  parallel_for(name, blocks, [=](uint32_t b) {
    uint32_t total = 0;
    for (uint32_t i = b * sort_block; i < std::min(count, (b + 1) * sort_block); ++i)
      total = sum(total, in[i]);
    base[b] = total;
  });
  uint32_t running = 0;
  for (uint32_t b = 0; b < blocks; ++b) running = sum(running, std::exchange(base[b], running));
  parallel_for(name, blocks, [=](uint32_t b) {
    uint32_t total = base[b];
    for (uint32_t i = b * sort_block; i < std::min(count, (b + 1) * sort_block); ++i) {
      out[i] = total;
      total = sum(total, in[i]);
    }
  });
  out[count] = running;
  if (note.count) note[0].take(running);
}

void CpuDevice::sort_pairs(const char* /*name*/, View<const uint32_t> keys, View<uint32_t> sorted_keys,
                           View<const uint32_t> values, View<uint32_t> sorted_values, uint32_t bits) {
  const uint32_t count = keys.count;
  // The number of passes need not be even. Each pass reads one pair of arrays and writes the other, and the
  // first target is chosen so that the last pass writes the caller's arrays.
  const uint32_t passes = std::max(1u, (bits + 10) / 11);
  const uint32_t digit_bits = std::max(1u, (bits + passes - 1) / passes);
  const uint32_t blocks = (count + sort_block - 1) / sort_block;
  View<uint32_t> memory = scratch<uint32_t>(2 * count + (blocks << digit_bits));
  View<uint32_t> spare_keys{memory.data, count}, spare_values{memory.data + count, count};
  View<uint32_t> offsets{memory.data + 2 * size_t{count}, blocks << digit_bits};
  for (uint32_t pass = 0; pass < passes; ++pass) {
    const bool into_caller = (passes - pass) % 2 == 1;
    View<uint32_t> keys_out = into_caller ? sorted_keys : spare_keys;
    View<uint32_t> values_out = into_caller ? sorted_values : spare_values;
    const uint32_t shift = pass * digit_bits;
    radix_pass(keys, keys_out, values, values_out, shift, std::min(digit_bits, bits - std::min(bits, shift)),
               offsets);
    keys = keys_out;
    values = values_out;
  }
}

// One stable pass of a least-significant-digit radix sort: a histogram for each block, offsets by digit then
// block, scatter.
void CpuDevice::radix_pass(View<const uint32_t> keys, View<uint32_t> keys_out, View<const uint32_t> values,
                           View<uint32_t> values_out, uint32_t shift, uint32_t digit_bits,
                           View<uint32_t> offsets) {
  const uint32_t count = keys.count;
  const uint32_t blocks = (count + sort_block - 1) / sort_block;
  const uint32_t digits = 1u << digit_bits;
  const auto digit_of = [=](uint32_t key) { return (key >> shift) & (digits - 1); };
  const auto for_each_block = [&](const auto& visit) {
    loop(blocks, 1, [&](uint32_t begin, uint32_t end) {
      for (uint32_t b = begin; b < end; ++b) visit(b);
    });
  };
  for_each_block([=](uint32_t b) {
    uint32_t* histogram = offsets.data + size_t{b} * digits;
    std::fill_n(histogram, digits, 0u);
    for (uint32_t i = b * sort_block; i < std::min(count, (b + 1) * sort_block); ++i)
      ++histogram[digit_of(keys[i])];
  });
  uint32_t running = 0;
  for (uint32_t d = 0; d < digits; ++d) {
    for (uint32_t b = 0; b < blocks; ++b) running += std::exchange(offsets[b * digits + d], running);
  }
  for_each_block([=](uint32_t b) {
    uint32_t* next = offsets.data + size_t{b} * digits;
    for (uint32_t i = b * sort_block; i < std::min(count, (b + 1) * sort_block); ++i) {
      const uint32_t place = next[digit_of(keys[i])]++;
      keys_out[place] = keys[i];
      values_out[place] = values[i];
    }
  });
}

}  // namespace meniscus::pbd
