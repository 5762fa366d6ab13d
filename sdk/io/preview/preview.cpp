// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Puts together the drawing of a preview and renders it.
#include "sdk/io/preview/preview.h"

#include <algorithm>

#include "sdk/io/preview/cloth.h"
#include "sdk/io/preview/palette.h"
#include "sdk/io/preview/shading.h"
#include "sdk/io/preview/shapes.h"

namespace meniscus::io {
namespace {

constexpr int samples = 2;              // along a pixel's side
constexpr float particle_size = 0.58f;  // radius in spacings: neighbours overlap a little
constexpr int whitenings = 32;          // shades of a fluid between clear and white

struct Bounds {
  Vec3 lower{Raster::far_away, Raster::far_away, Raster::far_away};
  Vec3 upper = -lower;

  void add(Vec3 low, Vec3 high) {
    lower = min(lower, low);
    upper = max(upper, high);
  }
  bool empty() const { return !(lower.x <= upper.x); }
};

Bounds bounds_of(const Drawing& drawing) {
  Bounds bounds;
  for (const Triangle& t : drawing.triangles) {
    for (const Vec3 p : t.corners) bounds.add(p, p);
  }
  for (const Sphere& s : drawing.spheres) {
    const Vec3 r{s.radius, s.radius, s.radius};
    bounds.add(s.center - r, s.center + r);
  }
  for (const Edge& e : drawing.edges) bounds.add(min(e.from, e.to), max(e.from, e.to));
  return bounds;
}

/// Bounds of all values but a few outliers.
std::pair<float, float> usual_range(std::span<const Vec3> points, float Vec3::*axis) {
  std::vector<float> values;
  for (const Vec3& p : points) {
    if (is_finite(p)) values.push_back(p.*axis);
  }
  if (values.empty()) return {Raster::far_away, -Raster::far_away};
  const std::size_t strays = values.size() / 500;
  const auto low = values.begin() + static_cast<std::ptrdiff_t>(strays);
  std::nth_element(values.begin(), low, values.end());
  const float lower = *low;
  const auto high = values.end() - 1 - static_cast<std::ptrdiff_t>(strays);
  std::nth_element(values.begin(), high, values.end());
  return {lower, *high};
}

Bounds bounds_of(std::span<const Vec3> points, float margin) {
  const auto [x0, x1] = usual_range(points, &Vec3::x);
  const auto [y0, y1] = usual_range(points, &Vec3::y);
  const auto [z0, z1] = usual_range(points, &Vec3::z);
  const Vec3 m{margin, margin, margin};
  return {Vec3{x0, y0, z0} - m, Vec3{x1, y1, z1} + m};
}

/// 0 for NaN.
float smooth_step(float t) {
  t = t > 0 ? std::min(t, 1.0f) : 0;
  return t * t * (3 - 2 * t);
}

/// The colours of each fluid from clear to white, as consecutive surfaces; grains have one colour.
class FluidPaint {
 public:
  FluidPaint(Drawing& drawing, std::vector<Vec3> colors, std::size_t first_granular)
      : fluids_(colors.size()) {
    colors.push_back(FluidDef{}.color);
    first_ = static_cast<uint32_t>(drawing.surfaces.size());
    for (std::size_t k = 0; k < colors.size(); ++k) {
      const Vec3 color = colors[k];
      const bool dull = k >= first_granular && k < fluids_;
      for (int i = 0; i < whitenings; ++i) {
        const float t = static_cast<float>(i) / (whitenings - 1);
        if (dull)
          drawing.add_surface({color, 0.05f});
        else
          drawing.add_surface({color + 0.9f * t * (Vec3{0.92f, 0.95f, 0.97f} - color), 0.8f * (1 - t)});
      }
    }
  }

  uint32_t surface(uint32_t fluid, float whiteness) const {
    const auto shade = static_cast<uint32_t>(whiteness * (whitenings - 1) + 0.5f);
    return first_ + std::min(fluid, static_cast<uint32_t>(fluids_)) * whitenings + shade;
  }

 private:
  std::size_t fluids_;
  uint32_t first_ = 0;
};

/// The speed at which fluid is white, m/s: half of the speed of a fall through the height of the scene. It is
/// an empirical choice for foam.
float fast_speed(const PreviewScene& scene, float height) {
  return std::max(0.5f * std::sqrt(2 * length(scene.gravity) * height), 20 * scene.particle_spacing);
}

/// The foam fraction of a particle, 0 to 1: from its speed and, if density errors are known, from the missing
/// water around it. A particle at an edge lacks half of the rest density, a drop four fifths.
float whiteness(const ParticleFrame& frame, std::size_t i, float fast) {
  const float speed = smooth_step((length(frame.velocities[i]) / fast - 0.25f) / 0.75f);
  if (frame.density_errors.empty()) return speed;
  const float spray = smooth_step((-frame.density_errors[i] - 0.4f) / 0.35f);
  return 0.2f * speed + 0.5f * spray;  // never fully white, so that drops of two fluids differ
}

void add_particles(Drawing& drawing, const ParticleFrame& frame, const PreviewScene& scene, float height) {
  const FluidPaint paint(drawing, scene.fluid_colors, scene.first_granular);
  const float fast = fast_speed(scene, height);
  for (std::size_t i = 0; i < frame.size(); ++i) {
    if (!is_finite(frame.positions[i]) || !is_finite(frame.velocities[i])) continue;
    drawing.spheres.push_back({frame.positions[i], particle_size * scene.particle_spacing,
                               paint.surface(frame.fluids[i], whiteness(frame, i, fast))});
  }
}

void add_shapes(Drawing& drawing, const PreviewScene& scene, Vec3 up) {
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    add_solid(drawing, scene.shapes[i].geometry, scene.shapes[i].pose, up,
              drawing.add_surface({shape_color(i), 0.15f}));
  }
}

void add_bodies(Drawing& drawing, const PreviewScene& scene, std::span<const BodyState> states, Vec3 up) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const BodyDef& body = scene.bodies[i];
    add_solid(drawing, body.geometry, states.empty() ? body.pose : states[i].pose, up,
              drawing.add_surface({body_color(i), 0.2f}));
  }
}

void check_states(std::span<const BodyState> states, const std::vector<BodyDef>& bodies) {
  if (states.empty() || states.size() == bodies.size()) return;
  throw Error(ErrorCode::invalid_argument, "states has " + std::to_string(states.size()) +
                                               " elements, but the scene has " +
                                               std::to_string(bodies.size()) + " bodies");
}

/// From over the viewer's left shoulder.
Vec3 lamp_direction(const SceneCamera& view, Vec3 up) {
  const Vec3 forward = normalized_or(view.target - view.position, {0, 0, -1});
  const Vec3 right = normalized_or(cross(forward, up), {1, 0, 0});
  return normalized_or(1.25f * up - 0.75f * right - 0.35f * cross(up, right), up);
}

/// The smallest detail, m: a particle, or an edge of the cloth if there is no fluid.
float grain_of(const ParticleFrame& frame, const ClothFrame& cloth, float spacing) {
  if (cloth.triangles.empty()) return spacing;
  double sum = 0;
  for (const auto& t : cloth.triangles) {
    const float edge = length(cloth.vertices[t[1]] - cloth.vertices[t[0]]);
    if (std::isfinite(edge)) sum += edge;
  }
  const float mean = static_cast<float>(sum / static_cast<double>(cloth.triangles.size()));
  return frame.size() > 0 ? std::min(mean, spacing) : mean;
}

Studio studio_of(const Bounds& bounds, const SceneCamera& view, Vec3 up, float grain) {
  return {.up = up,
          .towards_lamp = lamp_direction(view, up),
          .center = 0.5f * (bounds.lower + bounds.upper),
          .radius = std::max(0.5f * length(bounds.upper - bounds.lower), grain),
          .grain = grain};
}

}  // namespace

PreviewScene preview_of(const Scene& scene) {
  PreviewScene preview;
  preview.shapes = scene.shapes;
  preview.bodies = bodies_of(scene);
  preview.gravity = scene.world.gravity;
  preview.particle_spacing = scene.world.particle_spacing;
  preview.camera = scene.camera;
  for (const FluidDef& fluid : scene.fluids) preview.fluid_colors.push_back(fluid.color);
  preview.media.resize(scene.fluids.size());
  for (const SceneLook& look : scene.looks) {
    for (std::size_t i = 0; i < scene.fluids.size(); ++i) {
      if (scene.fluids[i].name == look.fluid) preview.media[i] = medium_of(look);
    }
  }
  preview.first_granular = scene.fluids.size();
  for (const GranularDef& granular : scene.granulars) preview.fluid_colors.push_back(granular.color);
  for (const ClothDef& cloth : scene.cloths) preview.cloth_colors.push_back(cloth.color);
  for (const RopeDef& rope : scene.ropes) preview.rope_colors.push_back(rope.color);
  return preview;
}

Image render_preview(const ParticleFrame& frame, const PreviewScene& scene, std::span<const BodyState> states,
                     const ClothFrame& cloth, const RopeFrame& ropes) {
  check_states(states, scene.bodies);
  const Vec3 up = normalized_or(-scene.gravity, {0, 1, 0});
  Drawing drawing;
  add_shapes(drawing, scene, up);
  add_bodies(drawing, scene, states, up);
  add_cloth(drawing, cloth, scene.cloth_colors);
  add_ropes(drawing, ropes, scene.rope_colors);
  Bounds bounds = bounds_of(drawing);
  const Bounds fluid = bounds_of(frame.positions, scene.particle_spacing);
  bounds.add(fluid.lower, fluid.upper);
  if (bounds.empty()) bounds.add({-1, -1, -1}, {1, 1, 1});
  const Vec3 extent = bounds.upper - bounds.lower;
  add_particles(drawing, frame, scene, dot(extent, abs(up)));
  for (const ShapeDef& shape : scene.shapes) add_ground(drawing, shape, up, max_component(extent));

  const float aspect = static_cast<float>(scene.width) / static_cast<float>(scene.height);
  const SceneCamera view = scene.camera ? *scene.camera : view_of({bounds.lower, bounds.upper}, up, aspect);
  Raster raster(Camera(view, up, samples * scene.width, samples * scene.height));
  raster.draw(drawing);
  const float grain = grain_of(frame, cloth, scene.particle_spacing);
  return shade(raster, drawing, studio_of(bounds, view, up, grain), samples);
}

}  // namespace meniscus::io
