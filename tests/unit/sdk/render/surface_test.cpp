// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The surface in a picture, against the surface of the particles.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "sdk/io/preview/camera.h"
#include "tests/bench/harness/render_bench.h"

namespace meniscus::tests {
namespace {

constexpr float spacing = 0.05f;

using render::SurfaceFilter;

constexpr std::pair<const char*, SurfaceFilter> filters[] = {
    {"none", SurfaceFilter::none},
    {"bilateral", SurfaceFilter::bilateral},
    {"curvature-flow", SurfaceFilter::curvature_flow},
    {"narrow-range", SurfaceFilter::narrow_range}};

class SurfaceTest : public RenderTest {
 protected:
  /// Degrees, root mean square, between the normals that are drawn and `expected(point in the world)`, which
  /// is {0, 0, 0} where it does not matter.
  template <class Expected>
  double normal_error(const io::PreviewScene& scene, const Water& water, const Expected& expected,
                      SurfaceFilter filter = SurfaceFilter::narrow_range, bool anisotropic = true) {
    render::RenderSettings settings;
    settings.filter = filter;
    settings.anisotropic = anisotropic;
    render::Renderer renderer(scene, water.moment(), settings);
    renderer.draw(water.moment());
    const auto normals = renderer.fluid_normals();
    const io::Camera camera(*scene.camera, {0, 1, 0}, scene.width, scene.height);
    double sum = 0;
    int count = 0;
    for (int y = 0; y < scene.height; ++y) {
      for (int x = 0; x < scene.width; ++x) {
        const auto& pixel = normals[static_cast<std::size_t>(y) * scene.width + x];
        if (pixel[3] <= 0) continue;
        const Vec3 wanted = expected(camera.position() + pixel[3] * camera.world_ray(x, y));
        if (wanted == Vec3{0, 0, 0}) continue;
        const Vec3 v = camera.direction_to_view(wanted);  // z forward, where OpenGL has it backward
        const double cosine = pixel[0] * v.x + pixel[1] * v.y - pixel[2] * v.z;
        const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
        sum += angle * angle;
        ++count;
      }
    }
    EXPECT_GT(count, 3000) << "too few pixels to judge by";
    return std::sqrt(sum / count) * 180 / std::numbers::pi;
  }

  /// Degrees.
  struct Errors {
    double ours, least_other;
  };

  /// Prints a column of the table in docs/pictures.md: the error of each filter, over balls and over
  /// ellipsoids.
  template <class Expected>
  Errors compare(const char* surface, const io::PreviewScene& scene, const Water& water,
                 const Expected& expected) {
    Errors errors{0, 180};
    for (const bool anisotropic : {false, true}) {
      for (const auto& [name, filter] : filters) {
        const double error = normal_error(scene, water, expected, filter, anisotropic);
        std::printf("%s, %s, %s: %.2f\n", surface, anisotropic ? "ellipsoids" : "balls", name, error);
        const bool ours = anisotropic && filter == SurfaceFilter::narrow_range;
        if (ours)
          errors.ours = error;
        else
          errors.least_other = std::min(errors.least_other, error);
      }
    }
    return errors;
  }

  static io::PreviewScene from_above(Vec3 eye) {
    io::PreviewScene scene = small_scene(spacing);
    scene.width = 320;
    scene.height = 240;
    scene.camera = SceneCamera{eye, {0, 0, 0}, 35};
    return scene;
  }
};

/// A pool whose surface is at y = 0, some way from its borders.
Vec3 upwards(Vec3 p) {
  return std::abs(p.x) < 0.75f && std::abs(p.z) < 0.75f ? Vec3{0, 1, 0} : Vec3{0, 0, 0};
}

std::vector<Vec3> pool() {
  return points_where(spacing, {1, 1, 1}, [](Vec3 p) { return p.y < 0 && p.y > -0.3f; });
}

TEST_F(SurfaceTest, APoolIsFlat) {
  const Water water(pool(), spacing);
  EXPECT_LT(compare("pool", from_above({0, 1.6f, 2.2f}), water, upwards).ours, 1.5);
  EXPECT_LT(normal_error(from_above({0, 0.7f, 2.6f}), water, upwards), 1.5) << "at a low angle";
}

TEST_F(SurfaceTest, ABallIsRound) {
  const Water water(points_where(spacing, {0.65f, 0.65f, 0.65f}, [](Vec3 p) { return length(p) < 0.6f; }),
                    spacing);
  const auto outwards = [](Vec3 p) {
    const Vec3 n = normalized_or(p, {0, 0, 0});
    return n.z > 0.35f ? n : Vec3{0, 0, 0};  // all but a rim, which is seen edgewise
  };
  const Errors errors = compare("ball", from_above({0, 0, 3}), water, outwards);
  EXPECT_LT(errors.ours, 4);
  EXPECT_LT(errors.ours, 0.6 * errors.least_other) << "what is round is what tells filters apart";
}

TEST_F(SurfaceTest, AWaveHasItsShape) {
  constexpr float k = 2 * std::numbers::pi_v<float> / 0.8f, height = 0.06f;
  // Water that has been sheared into a wave, as it would flow into one.
  std::vector<Vec3> points = pool();
  for (Vec3& p : points) p.y += height * std::sin(k * p.x);
  const Water water(points, spacing);
  const auto slope = [&](Vec3 p) {
    if (std::abs(p.x) > 0.75f || std::abs(p.z) > 0.75f) return Vec3{0, 0, 0};
    return normalized_or({-k * height * std::cos(k * p.x), 1, 0}, {0, 1, 0});
  };
  EXPECT_LT(compare("wave", from_above({0, 2.2f, 1.6f}), water, slope).ours, 4);
}

TEST_F(SurfaceTest, EachFilterSmoothes) {
  const Water water(pool(), spacing);
  const io::PreviewScene scene = from_above({0, 1.6f, 2.2f});
  const double raw = normal_error(scene, water, upwards, SurfaceFilter::none);
  EXPECT_GT(raw, 3);
  EXPECT_LT(normal_error(scene, water, upwards, SurfaceFilter::bilateral), 0.7 * raw);
  EXPECT_LT(normal_error(scene, water, upwards, SurfaceFilter::curvature_flow), 0.7 * raw);
  EXPECT_LT(normal_error(scene, water, upwards, SurfaceFilter::narrow_range), 0.5 * raw);
}

/// Two walls of water that face the camera, one half of the picture each, 0.5 m apart in depth.
TEST_F(SurfaceTest, FiltersKeepDistantSurfacesApart) {
  const Water water(
      points_where(spacing, {1.2f, 0.8f, 0.5f}, [](Vec3 p) { return p.x < 0 ? p.z > 0.2f : p.z < -0.2f; }),
      spacing);
  const io::PreviewScene scene = from_above({0, 0, 3});
  for (const auto filter :
       {SurfaceFilter::narrow_range, SurfaceFilter::bilateral, SurfaceFilter::curvature_flow}) {
    render::RenderSettings settings;
    settings.filter = filter;
    render::Renderer renderer(scene, water.moment(), settings);
    renderer.draw(water.moment());
    const auto normals = renderer.fluid_normals();
    int between = 0;
    for (int y = 60; y < 180; ++y) {
      for (int x = 100; x < 220; ++x) {
        const float z = normals[static_cast<std::size_t>(y) * scene.width + x][3];
        EXPECT_GT(z, 2);
        // The near wall is 2.5 m away, and the far one 3.2; 0.1 m is its own unevenness and rounded edge.
        between += z > 2.6f && z < 3.1f;
      }
    }
    EXPECT_LT(between, 120 * 2) << "filter " << static_cast<int>(filter) << ": two pixels a row at most";
  }
}

TEST_F(SurfaceTest, TheSurfaceIsWhereTheWaterEnds) {
  const Water water(pool(), spacing);
  const io::PreviewScene scene = from_above({0, 3, 0.01f});
  render::Renderer renderer(scene, water.moment());
  renderer.draw(water.moment());
  double sum = 0;
  int count = 0;
  for (const auto& pixel : renderer.fluid_normals()) {
    if (pixel[3] <= 0 || pixel[2] < 0.99f) continue;
    sum += pixel[3];
    ++count;
  }
  ASSERT_GT(count, 3000);
  // It is 3 m away; the filter lies in the hollows between the topmost particles.
  EXPECT_NEAR((sum / count - 3) / spacing, 0, 0.2);
}

}  // namespace
}  // namespace meniscus::tests
