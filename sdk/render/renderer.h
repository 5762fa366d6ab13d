// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Pictures of a world by OpenGL 4.5: screen-space fluid (van der Laan, Green & Sainz 2009) over ellipsoids,
// among solids, cloth and ropes. It draws with whatever context is current, with or without a screen.
#pragma once

#include <memory>

#include "sdk/render/frame/moment.h"
#include "sdk/render/gl/pass_timer.h"
#include "sdk/render/passes/fluid_surface.h"

namespace meniscus::render {

struct RenderSettings {
  SurfaceFilter filter = SurfaceFilter::narrow_range;
  bool anisotropic = true;        ///< else fluid is balls of one spacing's radius, at Moment::positions
  float filter_reach = 1.3f;      ///< spacings, one standard deviation
  float filter_threshold = 3.0f;  ///< spacings: surfaces that are further apart in depth are kept apart
};

class Renderer {
 public:
  /// The view is chosen once: it holds the scene and what there is of it at `first`, unless the scene has a
  /// camera. Throws Error(invalid_argument) unless width and height of the scene are 1 to 16384,
  /// and for more than 1024 fluids and granular materials;
  /// Error(capacity) for more pixels than OpenGL's buffers hold, of which a million take 4 MB;
  /// Error(device) where OpenGL fails; and what solid_triangles throws.
  Renderer(const io::PreviewScene& scene, const Moment& first, const RenderSettings& settings = {});
  ~Renderer();

  /// A box around what there was at first.
  Aabb box() const;
  const SceneCamera& camera() const;
  /// From here on it is seen from there, in the same light.
  void set_camera(const SceneCamera& camera);
  /// Of the pictures from here on, which will be shown at 1/share of that; to go to and fro between two sizes
  /// costs nothing. Throws as the constructor does.
  void set_size(int width, int height, float share = 1);

  /// What is to be drawn. Throws Error(invalid_argument) where there are bodies, but not one a body of the
  /// scene, or not one fluid and, for balls, one position an ellipsoid;
  /// Error(capacity) for more particles than OpenGL's buffers hold, of which a million take 40 MB.
  void load(const Moment& moment);
  /// Draws it.
  void paint();
  /// What was drawn last. Throws Error(device) where OpenGL failed, as the next one does.
  io::Image image() const;
  /// Puts it over the window's own framebuffer, which is so large in pixels.
  void show(int width, int height) const;
  /// Whether pictures from here on are timed pass by pass.
  void time_passes(bool on);
  /// Of the last picture that was, in the order of the passes, on what draws; waits for it.
  std::vector<PassTime> pass_times() const;
  /// All of these at once.
  io::Image draw(const Moment& moment);
  /// Unit normals of the fluid in view space, and its distance along −z, row by row from the top; 0 where
  /// none is seen. Of the last moment drawn.
  std::vector<std::array<float, 4>> fluid_normals();
  /// Metres of fluid along each line of sight, in as many rows and columns, likewise.
  std::vector<float> fluid_thickness();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace meniscus::render
