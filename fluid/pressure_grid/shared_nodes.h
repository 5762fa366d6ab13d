// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The nodes of a pressure grid in a world that ranks share.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <vector>

#include "fluid/pressure_grid/node_layers.h"
#include "pbd/device/buffer.h"
#include "pbd/ghosts.h"
#include "pbd/grid.h"

namespace meniscus::fluid {

template <class T>
pbd::WordArray words_of(pbd::View<T> values) {
  static_assert(sizeof(T) % sizeof(uint32_t) == 0);
  return {reinterpret_cast<uint32_t*>(values.data), sizeof(T) / sizeof(uint32_t)};
}

/// Each rank finds what its layers of nodes have, from its own particles and its ghosts, in the order of a
/// world alone. Then all ranks get the values of all nodes, so that each solves the whole equation. Without
/// ranks, all nodes are this rank's.
template <class D>
class SharedNodes {
  using NodeLayers = grid_kernels::NodeLayers;

 public:
  explicit SharedNodes(D& device) : device_(device) {}

  /// Call it first in each solve. Returns whether any rank has particles.
  bool start(pbd::GhostExchange* exchange, const pbd::GridView& cells, const NodeTable& nodes) {
    exchange_ = exchange;
    nodes_ = nodes;
    layers_.clear();
    if (!exchange) return true;
    const int axis = cells.layers_along_y ? 1 : 2;
    occupied_ = {INT32_MAX, INT32_MIN};
    for (const pbd::GhostExchange::Layers& l : exchange->corner_layers()) {
      const int32_t count = std::max(l.end - l.first, 0);
      layers_.push_back({nodes, axis, l.first, static_cast<uint32_t>(count)});
      if (count > 0) occupied_ = {std::min(occupied_.first, l.first + 1), std::max(occupied_.end, l.end - 1)};
    }
    return occupied_.first < occupied_.end;
  }
  bool are_shared() const { return exchange_ != nullptr; }
  /// The layers of cells with particles, on any rank. The corners beside them are one more on either side.
  pbd::GhostExchange::Layers occupied() const { return occupied_; }

  /// Runs a kernel over this rank's nodes, or over so many parts of each.
  template <class Kernel>
  void for_each(const char* name, const Kernel& kernel, uint32_t parts = 1) {
    if (!exchange_) return device_.parallel_for(name, parts * nodes_.count(), kernel);
    device_.parallel_for(name, parts * own().count(), grid_kernels::InLayers<Kernel>{own(), kernel});
  }

  /// Gives all ranks what each has found of its nodes.
  void share(std::initializer_list<pbd::WordArray> arrays) {
    if (!exchange_) return;
    uint32_t words = 0;
    for (const pbd::WordArray& a : arrays) words += a.words;
    std::vector<size_t> starts{0};
    for (const NodeLayers& l : layers_) starts.push_back(starts.back() + size_t{l.count()} * words);
    make_room(all_, starts.back());
    const auto visit = [&](size_t rank, const auto& launch) {
      uint32_t* place = all_.view().data + starts[rank];
      for (const pbd::WordArray& a : arrays) {
        launch(a, place);
        place += size_t{layers_[rank].count()} * a.words;
      }
    };
    const auto self = static_cast<size_t>(exchange_->rank());
    visit(self, [&](const pbd::WordArray& a, uint32_t* place) {
      device_.parallel_for("grid/pack", own().count(), grid_kernels::PackNodes{own(), a, place});
    });
    exchange_->share(all_.view().data, starts);
    for (size_t r = 0; r < layers_.size(); ++r) {
      if (r == self) continue;
      visit(r, [&](const pbd::WordArray& a, uint32_t* place) {
        device_.parallel_for("grid/unpack", layers_[r].count(),
                             grid_kernels::UnpackNodes{layers_[r], place, a});
      });
    }
  }

  /// What the rank below has found of this rank's first layer. kernel(layers, values) is what finds it, for
  /// the rank above.
  template <class T, class MakeKernel>
  grid_kernels::FromBelow<T> from_below(const char* name, const MakeKernel& kernel) {
    if (!exchange_) return {};
    const uint32_t each = own().each();
    const size_t words = size_t{each} * (sizeof(T) / sizeof(uint32_t));
    make_room(above_, words);
    make_room(below_, words);
    const auto values = [&](pbd::Buffer<uint32_t>& buffer) {
      return pbd::View<T>{reinterpret_cast<T*>(buffer.view().data), each};
    };
    const auto above = static_cast<size_t>(exchange_->rank()) + 1;
    if (above < layers_.size()) {
      const NodeLayers first{nodes_, own().axis, layers_[above].first, 1};
      device_.parallel_for(name, each, kernel(first, values(above_)));
    }
    exchange_->pass_up(above_.view().data, below_.view().data, words);
    if (exchange_->rank() == 0) return {};
    return {own(), values(below_)};
  }

 private:
  const NodeLayers& own() const { return layers_[static_cast<size_t>(exchange_->rank())]; }
  static void make_room(pbd::Buffer<uint32_t>& buffer, size_t words) {
    if (words > buffer.size()) buffer.resize_discard(words + words / 4);
  }

  D& device_;
  pbd::GhostExchange* exchange_ = nullptr;
  NodeTable nodes_;
  std::vector<NodeLayers> layers_;  // by rank
  pbd::GhostExchange::Layers occupied_{0, 0};
  pbd::Buffer<uint32_t> all_{device_, "grid messages"};
  pbd::Buffer<uint32_t> above_{device_, "grid messages"}, below_{device_, "grid messages"};
};

}  // namespace meniscus::fluid
