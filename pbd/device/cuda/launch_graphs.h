// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A cache of CUDA graphs for lists of launches that recur.
#pragma once

#include <array>
#include <vector>

#include "pbd/device/cuda/launch_list.h"

namespace meniscus::pbd {

/// Sends lists of launches. Lists that recur are sent as a CUDA graph, which takes the host as long as one
/// launch. Steps without changes recur after six, when all rotating arrays have had their turn. Each step may
/// be several lists. A list that differs from the expected one by a few launches uses its graph, with these
/// launches updated. When there are many graphs, a new list replaces the one that was unused for the longest
/// time.
class LaunchGraphs {
 public:
  LaunchGraphs() = default;
  LaunchGraphs(const LaunchGraphs&) = delete;
  LaunchGraphs& operator=(const LaunchGraphs&) = delete;
  ~LaunchGraphs();

  /// Longer lists keep the GPU busy while they are launched, and need not be collected.
  static constexpr size_t longest = 160;

  /// Whether lists are useful at present: after many new lists they are suspended for some time.
  bool wants_lists() const { return can_capture_ && pause_ == 0; }
  void send(const LaunchList& list, const CudaStreams& streams);
  /// Counts a list that is new, or not suitable for a graph.
  void note_miss();
  /// Takes the place of a list where none is collected.
  void note_none() {
    if (pause_ > 0) --pause_;
  }

  /// How often a graph was launched.
  uint64_t sent() const { return sent_; }

 private:
  static constexpr size_t none = ~size_t{0};

  struct Graph {
    LaunchList list;
    cudaGraph_t graph = nullptr;
    cudaGraphExec_t executable = nullptr;
    std::vector<cudaGraphNode_t> nodes;  // by item, of launches
    uint64_t last_use = 0;
    size_t next = none;  // the graph that followed it last time

    void destroy();
  };

  static constexpr size_t shortest = 4, most_graphs = 24, most_seen = 64;
  static constexpr size_t most_changes = 12;  // each costs a third of a launch
  static constexpr uint32_t most_misses = 48, pause = 1024;

  Graph* find(const LaunchList& list);
  Graph* adopt(Graph& graph, const LaunchList& list);
  Graph* take_oldest(const LaunchList& list);
  Graph* build(const LaunchList& list, const CudaStreams& streams);
  bool capture(Graph& graph, const CudaStreams& streams);
  bool has_seen(uint64_t hash);

  std::vector<Graph> graphs_;
  size_t last_ = 0;  // the graph that was launched last
  std::vector<size_t> changes_;
  std::array<uint64_t, most_seen> seen_{};  // hashes of lists that were new
  size_t next_seen_ = 0;
  uint32_t misses_ = 0;  // since the last use of a graph
  uint32_t pause_ = 0;   // how many more lists are not collected
  uint64_t sent_ = 0;
  bool can_capture_ = true;
};

}  // namespace meniscus::pbd
