// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The pass that draws a plane of distances to solids.
#pragma once

#include <optional>

#include "sdk/render/frame/views.h"
#include "sdk/render/gl/program.h"

namespace meniscus::render {

/// A plane of distances to solids, in colours and with lines at equal distances.
class Slice {
 public:
  void set(const DistanceSlice& slice, const Scale& scale);
  void clear() { values_.reset(); }
  bool empty() const { return !values_; }
  /// Call it last: it blends over what is there already.
  void draw() const;

 private:
  DistanceSlice place_;
  Scale scale_;
  std::optional<Texture> values_;
  Texture colors_ = balance_colors();
  VertexArrayHandle array_ = make_vertex_array();
  Program program_{"views/slice.vert.glsl", "views/slice.frag.glsl"};

  static Texture balance_colors();
};

}  // namespace meniscus::render
