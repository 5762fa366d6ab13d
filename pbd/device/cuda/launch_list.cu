// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Sends, compares and hashes lists of launches.
#include "pbd/device/cuda/launch_list.h"

namespace meniscus::pbd {

void LaunchList::send(const CudaStreams& streams) const {
  try {
    for (size_t k = 0; k < size(); ++k) send(k, streams);
  } catch (...) {
    streams.join();
    throw;
  }
}

void LaunchList::send(size_t k, const CudaStreams& streams) const {
  const Item& item = items_[k];
  const cudaStream_t stream = streams.of(item.on_side);
  switch (item.kind) {
    case Kind::launch:
      return item.launch.send(stream, arguments_of(k));
    case Kind::copy:
      return check_cuda(cudaMemcpyAsync(item.to, item.from, item.bytes, cudaMemcpyDeviceToDevice, stream),
                        "copying on the GPU");
    case Kind::fork:
      return streams.fork();
    case Kind::join:
      return streams.join();
  }
}

bool LaunchList::find_changes(const LaunchList& before, size_t most, std::vector<size_t>& changes) const {
  changes.clear();
  if (items_.size() != before.items_.size() || offsets_ != before.offsets_) return false;
  for (size_t k = 0; k < items_.size(); ++k) {
    const Item& item = items_[k];
    const Item& old = before.items_[k];
    if (item == old && has_equal_arguments(k, before)) continue;
    Item resized = old;
    resized.launch.blocks = item.launch.blocks;
    if (!is_launch(k) || !(item == resized) || changes.size() == most) return false;
    changes.push_back(k);
  }
  return true;
}

cudaError_t LaunchList::set_node(cudaGraphExec_t graph, cudaGraphNode_t node, size_t item) const {
  const CudaLaunch& launch = items_[item].launch;
  cudaKernelNodeParams parameters{};
  parameters.func = const_cast<void*>(launch.kernel);
  parameters.gridDim = launch.blocks;
  parameters.blockDim = launch.threads;
  parameters.kernelParams = arguments_of(item);
  return cudaGraphExecKernelNodeSetParams(graph, node, &parameters);
}

uint64_t LaunchList::hash() const {
  uint64_t all = items_.size();
  const auto mix = [&](uint64_t value) {
    all = (all ^ value) * 0x9e3779b97f4a7c15u;
    all ^= all >> 32;
  };
  for (const Item& item : items_) {
    mix(reinterpret_cast<uintptr_t>(item.launch.kernel));
    mix(item.launch.blocks);
    mix(reinterpret_cast<uintptr_t>(item.to));
    mix(reinterpret_cast<uintptr_t>(item.from));
    mix(item.bytes);
  }
  for (size_t k = 0; k < bytes_.size(); k += word) {
    uint64_t value;
    std::memcpy(&value, bytes_.data() + k, word);
    mix(value);
  }
  return all;
}

void** LaunchList::arguments_of(size_t item) const {
  const size_t end = item + 1 < items_.size() ? items_[item + 1].first : offsets_.size();
  const size_t first = items_[item].first;
  for (size_t k = first; k < end; ++k)
    arguments_[k - first] = const_cast<std::byte*>(bytes_.data() + offsets_[k]);
  return arguments_.data();
}

bool LaunchList::has_equal_arguments(size_t item, const LaunchList& other) const {
  const auto place = [&](size_t k) { return k < offsets_.size() ? offsets_[k] : bytes_.size(); };
  const size_t begin = place(items_[item].first);
  const size_t end = item + 1 < items_.size() ? place(items_[item + 1].first) : bytes_.size();
  return std::memcmp(bytes_.data() + begin, other.bytes_.data() + begin, end - begin) == 0;
}

}  // namespace meniscus::pbd
