// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The parts of Renderer: its passes, programs and buffers.
#pragma once

#include "sdk/render/moment_parts.h"
#include "sdk/render/passes/balls.h"
#include "sdk/render/passes/caustics.h"
#include "sdk/render/passes/foam.h"
#include "sdk/render/passes/grains.h"
#include "sdk/render/passes/slice.h"
#include "sdk/render/passes/solids.h"
#include "sdk/render/passes/vessels.h"
#include "sdk/render/pictures.h"
#include "sdk/render/renderer.h"

namespace meniscus::render {

/// Throws Error(invalid_argument) that names a side which is out of range, and Error(capacity).
void check_size(int width, int height);

inline constexpr int shadow_size = 2048, shadow_block = 8;  // pixels along a side

/// The objects that are made once, and the passes of a frame in their order.
struct Renderer::Parts {
  Parts(const io::PreviewScene& s, const Moment& first, const RenderSettings& set);
  /// Sets up the view of the stage at the present size.
  void look();
  /// Writes what the fluids do to light.
  void write_media();
  void load(const Moment& moment);
  void forget_fluid_shadows();
  void check_particles(const Moment& moment) const;
  void load_particles(const Moment& moment, bool shows_fluid);
  void load_view(const ViewData& view);
  void bind() const;
  void draw_solid_shadows();
  /// Whether any lit object is rasterised.
  bool has_triangles() const { return !solids.empty() || grains || !balls.empty(); }
  void draw_solids();
  void find_distances();
  void list_particles();
  /// Draws everything that is made of particles.
  void gather_fluid();
  void light_scene();
  void draw_fluid();
  /// The front layer (0) or the rest (1), whose surface is bound.
  void draw_layer(int layer, const Texture& behind, const Texture& over);
  /// Draws what must stay visible through reflections of the fluid.
  void draw_over();
  void draw_picture();
  /// Draws all but the picture itself.
  void paint_light();
  /// The last of `count` pictures draws their mean.
  void add_picture(int sample, int count);
  void smooth_edges();
  void check_success() const;

  io::PreviewScene scene;
  RenderSettings settings;
  Solids solids;
  Vessels vessels;
  Bounds bounds;
  Stage stage;
  FrameUniforms frame;
  DataBuffer frame_buffer, fluid_buffer, extinction_buffer, glow_buffer;
  Screen screen;
  float share = 1;  // fraction of the pixels at which the picture will be shown, along a side
  Particles particles;
  TileLists camera_lists{"tiles/list_for_camera.comp.glsl", 32};
  TileLists sun_lists{"tiles/list_for_sun.comp.glsl", 16};
  Foam foam;
  std::optional<Grains> grains;      // if the scene has any
  std::optional<Caustics> caustics;  // if the settings want them
  Balls balls{scene.fluid_colors};
  Needles needles;
  Slice slice;
  bool shows_normals = false;
  bool has_solid_shadows = false;  // of the last moment loaded
  PassTimer timer;

  Texture shadow{GL_DEPTH_COMPONENT32F, shadow_size, shadow_size, GL_LINEAR};
  Target to_shadow{{}, &shadow};
  /// Least and greatest depths of blocks of the shadow map.
  Texture shadow_spans{GL_RG32F, shadow_size / shadow_block, shadow_size / shadow_block};
  Program find_spans{"light/shadow_blocks.comp.glsl"};
  SamplerHandle plain_sampler = make_plain_sampler();
  std::unique_ptr<Pictures> to = std::make_unique<Pictures>(scene.width, scene.height);
  std::unique_ptr<Pictures> before;  // of the previous size, to which a window may return
  Program distance{"light/distance.comp.glsl"};
  Program light{"light/light.comp.glsl"};
  Program fluid{"light/fluid.comp.glsl"};
  Program tone{"screen/tone.comp.glsl"};
  Program add{"screen/add.comp.glsl"};
  std::optional<Texture> sums;  // of samples of the present size
  Program view_normals{"screen/screen.vert.glsl", "views/view_normals.frag.glsl"};
  Program smooth{"screen/smooth.comp.glsl"};
};

}  // namespace meniscus::render
