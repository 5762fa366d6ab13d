// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Pictures of a world by OpenGL 4.5: screen-space fluid (van der Laan, Green & Sainz 2009) from ellipsoids,
// with solids, cloth and ropes. It draws in the current context, with or without a screen.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "sdk/render/frame/moment.h"
#include "sdk/render/gl/pass_timer.h"
#include "sdk/render/passes/fluid_surface.h"

namespace meniscus::render {

struct RenderSettings {
  SurfaceFilter filter = SurfaceFilter::narrow_range;
  bool anisotropic = true;    ///< false: fluid is balls with a radius of one spacing, at Moment::positions
  float filter_reach = 1.3f;  ///< spacings, one standard deviation
  float filter_threshold = 3.0f;  ///< spacings: surfaces further apart in depth stay separate
  bool caustics = false;          ///< whether fluid gathers the light of the sun on what lies beneath it
};

class Renderer {
 public:
  /// The view is chosen once. It contains the scene with the objects at `first`, unless the scene has a
  /// camera. Throws Error(invalid_argument) unless width and height of the scene are 1 to 16384, and for more
  /// than 1024 fluids and granular materials. Throws Error(capacity) for more pixels than OpenGL's buffers
  /// hold; a million pixels take 4 MB. Throws Error(device) if OpenGL fails, and what solid_triangles throws.
  Renderer(const io::PreviewScene& scene, const Moment& first, const RenderSettings& settings = {});
  ~Renderer();

  /// A box around the objects at the first moment.
  Aabb box() const;
  const SceneCamera& camera() const;
  Vec3 up() const;  ///< unit, against gravity
  /// Sets the camera for later pictures; the light stays the same.
  void set_camera(const SceneCamera& camera);
  /// Sets what the fluids do to light in later pictures, as PreviewScene::media.
  void set_media(std::vector<std::optional<io::Medium>> media);
  /// Sets the size of later pictures, which will be shown at 1/share of it. Switching between two sizes costs
  /// nothing. Throws as the constructor does.
  void set_size(int width, int height, float share = 1);

  /// Loads the moment to draw. Throws Error(invalid_argument) if there are bodies, but not as many as in the
  /// scene. It also throws it unless there is one fluid per ellipsoid, one position for balls, and one
  /// velocity or none at all. Throws
  /// Error(capacity) for more particles than OpenGL's buffers hold; a million take 40 MB.
  void load(const Moment& moment);
  /// Draws the loaded moment.
  void paint();
  /// The same, as one of `count` pictures whose mean is wanted, in order from 0. After the last, image() is
  /// the mean.
  void add_sample(int sample, int count);
  /// The last picture. Throws Error(device) if OpenGL failed, as the next function does.
  io::Image image() const;
  /// Copies it to the window's own framebuffer, which has this size in pixels.
  void show(int width, int height) const;
  /// Switches the timing of later pictures, pass by pass.
  void time_passes(bool on);
  /// Times of the last timed picture on the GPU, in the order of the passes; waits for it.
  std::vector<PassTime> pass_times() const;
  /// Loads, draws and returns the picture.
  io::Image draw(const Moment& moment);
  /// Unit normals of the fluid in view space, and its distance along −z, row by row from the top; 0 where
  /// there is none. Of the last moment drawn.
  std::vector<std::array<float, 4>> fluid_normals();
  /// Metres of fluid along each line of sight, in the same rows and columns, of the last moment drawn.
  std::vector<float> fluid_thickness();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace meniscus::render
