// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Launches that are collected before they are sent.
#pragma once

#include <cuda_runtime.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "pbd/device/cuda/cuda_check.cuh"
#include "pbd/device/cuda/padding.h"

namespace meniscus::pbd {

/// A stream, a second one beside it, and the events by which they wait for each other.
struct CudaStreams {
  cudaStream_t main = nullptr, side = nullptr;
  cudaEvent_t forked = nullptr, joined = nullptr;

  cudaStream_t of(bool on_side) const { return on_side ? side : main; }
  void fork() const {
    check_cuda(cudaEventRecord(forked, main), "recording an event");
    check_cuda(cudaStreamWaitEvent(side, forked), "forking the stream");
  }
  /// An error here also makes the next launch fail.
  void join() const noexcept {
    cudaEventRecord(joined, side);
    cudaStreamWaitEvent(main, joined);
  }
};

/// A launch without its arguments.
struct CudaLaunch {
  const char* name;
  const void* kernel;
  uint32_t blocks, threads;
  bool overlaps;  ///< whether it may be prepared while the previous one still runs

  bool operator==(const CudaLaunch&) const = default;
  void send(cudaStream_t stream, void** arguments) const {
    cudaLaunchAttribute attribute{};
    attribute.id = cudaLaunchAttributeProgrammaticStreamSerialization;
    attribute.val.programmaticStreamSerializationAllowed = 1;
    cudaLaunchConfig_t config{};
    config.gridDim = blocks;
    config.blockDim = threads;
    config.stream = stream;
    config.attrs = &attribute;
    config.numAttrs = overlaps ? 1 : 0;
    check_cuda(cudaLaunchKernelExC(&config, kernel, arguments), name);
  }
};

/// Launches, copies, forks and joins in order, with all arguments. A call for which there is no memory leaves
/// the list as it was: a launch with a part of its arguments would read what is not its own.
class LaunchList {
 public:
  /// Makes room, so that forks, joins and copies take no memory up to this size.
  void reserve(size_t items) { items_.reserve(items); }
  bool empty() const { return items_.empty(); }
  size_t size() const { return items_.size(); }

  template <class... Arguments>
  void add(const CudaLaunch& launch, bool on_side, const Arguments&... arguments) {
    static_assert(sizeof...(arguments) <= most_arguments);
    make_room(offsets_, sizeof...(arguments));
    make_room(bytes_, (size_t{0} + ... + bytes_of<Arguments>()));
    add({.kind = Kind::launch, .on_side = on_side, .launch = launch});
    (put(arguments), ...);
  }
  void add_copy(void* to, const void* from, size_t bytes, bool on_side) {
    add({.kind = Kind::copy, .on_side = on_side, .to = to, .from = from, .bytes = bytes});
  }
  void add_fork() {
    add({.kind = Kind::fork});
    is_forked_ = true;
  }
  void add_join() {
    is_whole_ = is_whole_ && is_forked_;
    add({.kind = Kind::join});
    is_forked_ = false;
  }
  void clear() {
    items_.clear();
    offsets_.clear();
    bytes_.clear();
    is_forked_ = false;
    is_whole_ = true;
  }

  void send(const CudaStreams& streams) const;
  /// Sends one of these items; call it for each in order.
  void send(size_t item, const CudaStreams& streams) const;
  /// Whether every fork is joined, and no launch is on the side stream outside of them.
  bool is_whole() const { return is_whole_ && !is_forked_; }
  bool is_launch(size_t item) const { return items_[item].kind == Kind::launch; }
  bool is_on_side(size_t item) const { return items_[item].on_side; }

  /// Finds the launches that run the same kernel as before with other arguments or other numbers of blocks.
  /// True if there is no other difference, and at most `most` of them; else false.
  bool find_changes(const LaunchList& before, size_t most, std::vector<size_t>& changes) const;
  /// Gives a graph's node the arguments of launch `item`.
  cudaError_t set_node(cudaGraphExec_t graph, cudaGraphNode_t node, size_t item) const;
  /// Equal for lists that are equal.
  uint64_t hash() const;

 private:
  enum class Kind : uint32_t { launch, copy, fork, join };
  struct Item {
    Kind kind;
    bool on_side = false;
    CudaLaunch launch{};
    void* to = nullptr;
    const void* from = nullptr;
    size_t bytes = 0;
    size_t first = 0;  // of its arguments

    bool operator==(const Item&) const = default;
  };

  void add(Item item) {
    is_whole_ = is_whole_ && (is_forked_ || !item.on_side);
    item.first = offsets_.size();
    items_.push_back(item);
  }

  template <class T>
  static void make_room(std::vector<T>& in, size_t more) {
    if (in.capacity() - in.size() < more) in.reserve(std::max(2 * in.capacity(), in.size() + more));
  }
  template <class T>
  static constexpr size_t bytes_of() {
    return (sizeof(T) + word - 1) / word * word;
  }

  /// There must be room. Lists are compared by these bytes.
  template <class T>
  void put(T argument) {
    clear_padding(argument);
    offsets_.push_back(bytes_.size());
    bytes_.resize(bytes_.size() + bytes_of<T>());
    std::memcpy(bytes_.data() + offsets_.back(), &argument, sizeof(T));
  }
  void** arguments_of(size_t item) const;
  bool has_equal_arguments(size_t item, const LaunchList& other) const;

  static constexpr size_t word = sizeof(uint64_t), most_arguments = 16;

  std::vector<Item> items_;
  std::vector<size_t> offsets_;  // of all arguments in `bytes_`
  std::vector<std::byte> bytes_;
  bool is_forked_ = false, is_whole_ = true;
  mutable std::array<void*, most_arguments> arguments_;  // of the launch that is being sent
};

}  // namespace meniscus::pbd
