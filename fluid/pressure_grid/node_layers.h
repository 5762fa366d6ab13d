// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Layers of the pressure grid's nodes: where ranks share a world, each works on the layers of its slab.
#pragma once

#include "fluid/pressure_grid/node_table.h"
#include "pbd/device/base/view.h"
#include "pbd/particles.h"

namespace meniscus::fluid::grid_kernels {

/// The nodes of consecutive layers along an axis, y or z, in a table that is wide enough for all of them.
struct NodeLayers {
  NodeTable nodes;
  int axis = 2;
  int32_t first = 0;
  uint32_t layers = 0;

  MENISCUS_HD uint32_t each() const { return nodes.count() >> nodes.bits[axis]; }
  MENISCUS_HD uint32_t count() const { return layers * each(); }

  /// Node k of them, below count().
  MENISCUS_HD uint32_t node(uint32_t k) const {
    const int across = 3 - axis;
    const uint32_t row = k >> nodes.bits[0];
    NodeCoordinates c{{static_cast<int32_t>(k & ((1u << nodes.bits[0]) - 1)), 0, 0}};
    c.at[across] = static_cast<int32_t>(row & ((1u << nodes.bits[across]) - 1));
    c.at[axis] = first + static_cast<int32_t>(row >> nodes.bits[across]);
    return nodes.index(c);
  }
  /// The k of a node in the first layer; of others each() or more.
  MENISCUS_HD uint32_t place(uint32_t node) const {
    const int across = 3 - axis;
    const NodeCoordinates c = nodes.coordinates(node);
    const uint32_t layer =
        (static_cast<uint32_t>(c.at[axis]) - static_cast<uint32_t>(first)) & ((1u << nodes.bits[axis]) - 1);
    const uint32_t row = (layer << nodes.bits[across]) + static_cast<uint32_t>(c.at[across]);
    return (row << nodes.bits[0]) + static_cast<uint32_t>(c.at[0]);
  }
};

/// Runs a kernel over the nodes, or parts of nodes, of some layers.
template <class Kernel>
struct InLayers {
  NodeLayers layers;
  Kernel kernel;

  MENISCUS_HD void operator()(uint32_t k) const {
    const uint32_t count = layers.count(), part = k / count;
    kernel(part * layers.nodes.count() + layers.node(k - part * count));
  }
};

/// What the rank below has found of the nodes of the first layer, whose contacts are on both ranks. Without
/// values it has found nothing.
template <class T>
struct FromBelow {
  NodeLayers layers;
  pbd::View<const T> values;

  MENISCUS_HD T of(uint32_t node) const {
    if (values.count == 0) return {};
    const uint32_t k = layers.place(node);
    return k < values.count ? values[k] : T{};
  }
};

struct PackNodes {
  NodeLayers layers;
  pbd::WordArray from;
  uint32_t* to;

  MENISCUS_HD void operator()(uint32_t k) const {
    const uint32_t* source = from.data + size_t{layers.node(k)} * from.words;
    for (uint32_t w = 0; w < from.words; ++w) to[size_t{k} * from.words + w] = source[w];
  }
};

struct UnpackNodes {
  NodeLayers layers;
  const uint32_t* from;
  pbd::WordArray to;

  MENISCUS_HD void operator()(uint32_t k) const {
    uint32_t* target = to.data + size_t{layers.node(k)} * to.words;
    for (uint32_t w = 0; w < to.words; ++w) target[w] = from[size_t{k} * to.words + w];
  }
};

}  // namespace meniscus::fluid::grid_kernels
