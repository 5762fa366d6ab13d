// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "sdk/io/preview/preview.h"
#include "sdk/render/frame/uniforms.h"
#include "sdk/render/gl/objects.h"

namespace meniscus::render {

/// Containers as boxes that compute shaders cast rays at, see shaders/light/vessels.glsl: floors are solid,
/// the other walls are glass and seen from inside, and edges are bars.
class Vessels {
 public:
  explicit Vessels(const io::PreviewScene& scene);

  /// `states` of the scene's bodies, or none, for where they start.
  void place(std::span<const BodyState> states);
  /// For compute shaders.
  void bind() const;

 private:
  struct Item {
    ContainerGeometry geometry;
    Pose pose;
    std::size_t body;  ///< of the scene; none: no_body
  };
  void write();

  std::vector<Item> items_;
  Vec3 up_;
  DataBuffer vessels_, openings_, bars_;
};

}  // namespace meniscus::render
