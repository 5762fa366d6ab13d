// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds, updates and builds the CUDA graph of a list of launches.
#include "pbd/device/cuda/launch_graphs.h"

#include <algorithm>

namespace meniscus::pbd {

namespace {

/// The node of the last launch on a stream that is captured.
cudaGraphNode_t last_node(cudaStream_t stream) {
  cudaStreamCaptureStatus status = cudaStreamCaptureStatusNone;
  const cudaGraphNode_t* nodes = nullptr;
  size_t count = 0;
#if CUDART_VERSION >= 13000
  const cudaGraphEdgeData* edges = nullptr;
  cudaStreamGetCaptureInfo(stream, &status, nullptr, nullptr, &nodes, &edges, &count);
#elif CUDART_VERSION >= 12030
  const cudaGraphEdgeData* edges = nullptr;
  cudaStreamGetCaptureInfo_v3(stream, &status, nullptr, nullptr, &nodes, &edges, &count);
#else
  cudaStreamGetCaptureInfo_v2(stream, &status, nullptr, nullptr, &nodes, &count);
#endif
  return status == cudaStreamCaptureStatusActive && count == 1 ? nodes[0] : nullptr;
}

}  // namespace

LaunchGraphs::~LaunchGraphs() {
  for (Graph& graph : graphs_) graph.destroy();
}

void LaunchGraphs::Graph::destroy() {
  if (executable) cudaGraphExecDestroy(executable);
  if (graph) cudaGraphDestroy(graph);
}

void LaunchGraphs::send(const LaunchList& list, const CudaStreams& streams) {
  if (list.size() < shortest || !list.is_whole() || !can_capture_) return list.send(streams);
  Graph* graph = find(list);
  if (graph) {
    misses_ = 0;
  } else {
    note_miss();
    if (graphs_.size() == most_graphs) graph = take_oldest(list);
    if (!graph && has_seen(list.hash())) graph = build(list, streams);
  }
  if (!graph) return list.send(streams);
  const auto place = static_cast<size_t>(graph - graphs_.data());
  graphs_[last_].next = place;
  last_ = place;
  if (cudaGraphLaunch(graph->executable, streams.main) != cudaSuccess) {
    cudaGetLastError();  // clears it: the first launch of a graph needs memory
    return list.send(streams);
  }
  graph->last_use = ++sent_;
}

void LaunchGraphs::note_miss() {
  if (++misses_ < most_misses) return;
  misses_ = 0;
  pause_ = pause;
}

/// The most likely graph is the one that followed last time. Only that one is modified: the others will recur
/// as well.
LaunchGraphs::Graph* LaunchGraphs::find(const LaunchList& list) {
  if (graphs_.empty()) return nullptr;
  const size_t likely = graphs_[last_].next;
  if (likely != none && list.find_changes(graphs_[likely].list, most_changes, changes_))
    return adopt(graphs_[likely], list);
  const auto found = std::find_if(graphs_.begin(), graphs_.end(), [&](const Graph& graph) {
    return list.find_changes(graph.list, 0, changes_);
  });
  return found == graphs_.end() ? nullptr : &*found;
}

/// Updates the graph to match the list.
LaunchGraphs::Graph* LaunchGraphs::adopt(Graph& graph, const LaunchList& list) {
  for (size_t item : changes_) {
    if (graph.nodes[item] && list.set_node(graph.executable, graph.nodes[item], item) == cudaSuccess)
      continue;
    cudaGetLastError();  // clears it
    graph.list.clear();  // it no longer matches any list
    return nullptr;
  }
  if (changes_.empty()) return &graph;
  try {
    graph.list = list;
  } catch (...) {
    graph.list.clear();  // the nodes have changed already
    throw;
  }
  return &graph;
}

/// Updates the oldest graph of the same kernels, which takes a tenth of the time of a new one.
LaunchGraphs::Graph* LaunchGraphs::take_oldest(const LaunchList& list) {
  Graph* oldest = nullptr;
  for (Graph& graph : graphs_) {
    if ((!oldest || graph.last_use < oldest->last_use) &&
        list.find_changes(graph.list, list.size(), changes_))
      oldest = &graph;
  }
  return oldest && list.find_changes(oldest->list, list.size(), changes_) ? adopt(*oldest, list) : nullptr;
}

/// Replaces the oldest graph where there are many.
LaunchGraphs::Graph* LaunchGraphs::build(const LaunchList& list, const CudaStreams& streams) {
  graphs_.reserve(most_graphs);  // nothing below takes memory once CUDA's objects are there
  Graph built{.list = list};
  if (!capture(built, streams)) {
    built.destroy();
    cudaGetLastError();  // clears it
    return nullptr;
  }
  if (graphs_.size() < most_graphs) {
    graphs_.push_back(std::move(built));
    return &graphs_.back();
  }
  Graph& oldest = *std::min_element(graphs_.begin(), graphs_.end(),
                                    [](const Graph& a, const Graph& b) { return a.last_use < b.last_use; });
  oldest.destroy();
  oldest = std::move(built);
  return &oldest;
}

/// Captures what the list does when it is sent. Before CUDA 12.3 overlapping launches cannot be captured.
bool LaunchGraphs::capture(Graph& to, const CudaStreams& streams) {
  to.nodes.reserve(to.list.size());
  if (cudaStreamBeginCapture(streams.main, cudaStreamCaptureModeThreadLocal) != cudaSuccess) return false;
  bool done = true;
  try {
    for (size_t k = 0; k < to.list.size(); ++k) {
      to.list.send(k, streams);
      to.nodes.push_back(to.list.is_launch(k) ? last_node(streams.of(to.list.is_on_side(k))) : nullptr);
    }
  } catch (...) {
    done = false;
  }
  can_capture_ = cudaStreamEndCapture(streams.main, &to.graph) == cudaSuccess && done;
  return can_capture_ && cudaGraphInstantiate(&to.executable, to.graph, 0) == cudaSuccess;
}

/// Whether a list with this hash was new before; records the hash.
bool LaunchGraphs::has_seen(uint64_t hash) {
  if (std::find(seen_.begin(), seen_.end(), hash) != seen_.end()) return true;
  seen_[next_seen_++ % most_seen] = hash;
  return false;
}

}  // namespace meniscus::pbd
