// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Containers, as the light shaders read them.
#pragma once

#include <span>

#include "sdk/io/preview/preview.h"
#include "sdk/render/frame/uniforms.h"
#include "sdk/render/gl/objects.h"

namespace meniscus::render {

/// Containers as boxes at which compute shaders cast rays, see shaders/light/vessels.glsl. Floors are solid.
/// The other walls are glass, seen from inside. Edges are bars.
class Vessels {
 public:
  explicit Vessels(const io::PreviewScene& scene);

  /// `states` of the scene's bodies; empty: at their start.
  void place(std::span<const BodyState> states);
  /// Binds the buffers for compute shaders.
  void bind() const;

 private:
  struct Item {
    ContainerGeometry geometry;
    Pose pose;
    std::size_t body;  ///< index in the scene; no_body: none
  };
  void write();

  std::vector<Item> items_;
  Vec3 up_;
  DataBuffer vessels_, openings_, bars_;
};

}  // namespace meniscus::render
