// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The textures and targets that have the size of the picture.
#pragma once

#include "sdk/render/passes/fluid_surface.h"
#include "sdk/render/passes/fluid_thickness.h"
#include "sdk/render/passes/foam.h"

namespace meniscus::render {

/// All textures with the size of the picture; they are made anew when it changes.
struct Pictures {
  Pictures(int w, int h) : width(w), height(h) {}

  int width, height;
  bool has_fluid_shadows = false;             ///< of the last moment loaded
  Texture albedo{GL_RGBA16F, width, height};  ///< a: gloss
  Texture normal{GL_RGBA16F, width, height};  ///< both are empty where nothing is drawn
  Texture scene_color{GL_RGBA16F, width, height, GL_LINEAR};
  Texture scene_depth{GL_DEPTH_COMPONENT32F, width, height};  ///< of rasterised objects
  /// Distance along −z, m, including the ground and vessels. g: the kind of object, see
  /// shaders/light/scene.glsl.
  Texture scene_distance{GL_RG32F, width, height};
  Texture lit{GL_RGBA16F, width, height};
  Texture toned{GL_RGBA8, width, height, GL_LINEAR};
  Texture picture{GL_RGBA8, width, height};
  Texture behind_front{GL_RGBA16F, width, height,
                       GL_LINEAR};  ///< lit scene, and the fluid behind the front layer
  Foam::Sums foam{width, height};
  Target to_surfaces{{&albedo, &normal}, &scene_depth};
  Target to_behind_front{{&behind_front}, nullptr};
  Target to_lit{{&lit}, nullptr};
  Target to_over{{&lit}, &scene_depth};
  Target to_toned{{&toned}, nullptr};
  Target to_picture{{&picture}, nullptr};
  FluidSurface surface{width, height};
  FluidThickness thickness{width, height};
};

}  // namespace meniscus::render
