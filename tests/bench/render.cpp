// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The benchmark of the renderer.
#include "tests/bench/render.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "sdk/render/egl_context.h"
#include "sdk/render/renderer.h"

namespace meniscus::bench {

namespace {

using Clock = std::chrono::steady_clock;

double ms_between(Clock::time_point begin, Clock::time_point end) {
  return std::chrono::duration<double, std::milli>(end - begin).count();
}

render::Moment moment_of(const World& world) {
  return {.world = &world};
}

/// So that the tank is as wide as the picture.
SceneCamera before(const ShapeDef& tank) {
  const Vec3 half = std::get<ContainerGeometry>(tank.geometry).half_extents;
  const Vec3 target{half.x, 0.7f * half.y, half.z};
  return {target + 2.1f * half.x * normalized_or({0.25f, 0.45f, 1}, {0, 0, 1}), target, 35};
}

/// A camera that goes around what it looks at, to and fro by a quarter of a degree a picture.
class Orbit {
 public:
  Orbit(render::Renderer& renderer, const SceneCamera& camera) : renderer_(renderer), camera_(camera) {}

  void step() {
    constexpr int there = 40;  // pictures
    const int k = pictures_++ % (2 * there), turns = k < there ? k : 2 * there - k;
    const float angle = 0.25f * static_cast<float>(turns) * std::numbers::pi_v<float> / 180;
    const Vec3 away = camera_.position - camera_.target;
    SceneCamera turned = camera_;
    turned.position = camera_.target + rotate({0, std::sin(0.5f * angle), 0, std::cos(0.5f * angle)}, away);
    renderer_.set_camera(turned);
  }

 private:
  render::Renderer& renderer_;
  SceneCamera camera_;
  int pictures_ = 0;
};

/// Means over some pictures, one straight after the other, each from elsewhere, ms; without a moment nothing
/// new is loaded.
struct FrameTimes {
  double whole = 0;
  double load = 0, paint = 0;  ///< the host's own: it goes on before they are done

  void run(render::Renderer& renderer, Orbit& orbit, const std::optional<render::Moment>& moment, int count) {
    *this = {};
    glFinish();
    const auto begin = Clock::now();
    for (int k = 0; k < count; ++k) {
      const auto start = Clock::now();
      orbit.step();
      if (moment) renderer.load(*moment);
      const auto loaded = Clock::now();
      renderer.paint();
      load += ms_between(start, loaded) / count;
      paint += ms_between(loaded, Clock::now()) / count;
    }
    glFinish();
    whole = ms_between(begin, Clock::now()) / count;
  }
};

/// Medians over some pictures.
Json pass_times(render::Renderer& renderer, Orbit& orbit, const render::Moment& moment, int times) {
  std::vector<const char*> order;
  std::map<std::string, std::vector<double>> ms;
  renderer.time_passes(true);
  for (int k = 0; k < times; ++k) {
    orbit.step();
    renderer.load(moment);
    renderer.paint();
    for (const render::PassTime& pass : renderer.pass_times()) {
      if (k == 0) order.push_back(pass.name);
      ms[pass.name].push_back(pass.ms);
    }
  }
  renderer.time_passes(false);
  Json medians;
  for (const char* name : order) medians[name] = quantile(ms[name], 0.5);
  return medians;
}

/// Of all pixels, those in which fluid is seen.
double covered_share(render::Renderer& renderer) {
  const auto normals = renderer.fluid_normals();
  const auto covered = std::count_if(normals.begin(), normals.end(), [](const auto& n) { return n[3] > 0; });
  return static_cast<double>(covered) / static_cast<double>(normals.size());
}

Json run_case(const CommonOptions& common, const RenderOptions& o, int particles) {
  Dam dam(common, o.dam, particles, o.dam.iterations.front());
  // A step moves water by so many spacings, and a larger dam has more of them.
  const auto warm = static_cast<int>(o.dam.warm_steps * std::cbrt(1e-5 * particles));
  for (int k = 0; k < warm; ++k) dam.world.step(dam.dt);
  io::PreviewScene scene;
  scene.particle_spacing = dam.world.def().particle_spacing;
  scene.width = o.width;
  scene.height = o.height;
  scene.shapes = {dam.tank};
  scene.camera = before(dam.tank);
  const render::EglContext context;
  const render::Moment moment = moment_of(dam.world);
  render::Renderer renderer(scene, moment);
  const io::Image picture = renderer.draw(moment);
  dam.world.step(dam.dt);  // pictures follow a step, of whose neighbours their ellipsoids are made
  if (!o.picture.empty()) io::write_png(o.picture, picture);
  const double covered = covered_share(renderer);
  Orbit orbit(renderer, *scene.camera);
  FrameTimes frames, pictures;
  frames.run(renderer, orbit, moment, 2);
  frames.run(renderer, orbit, moment, o.frames);
  pictures.run(renderer, orbit, std::nullopt, o.frames);
  return {{"particles", dam.world.particle_count()},
          {"width", o.width},
          {"height", o.height},
          {"camera", "orbits"},
          {"renderer", context.renderer()},
          {"frame_ms", frames.whole},
          {"load_host_ms", frames.load},
          {"paint_host_ms", frames.paint},
          {"loaded_frame_ms", pictures.whole},
          {"covered_percent", 100 * covered},
          {"pass_ms", pass_times(renderer, orbit, moment, std::min(o.frames, 20))}};
}

}  // namespace

CLI::App* add_render(CLI::App& app, RenderOptions& o) {
  CLI::App* render = app.add_subcommand("render", "pictures of a dam break in mid-splash, by OpenGL");
  render->add_option("--particles", o.dam.particles, "how many, one case each")->delimiter(',');
  render->add_option("--warm", o.dam.warm_steps, "steps before the picture");
  render->add_option("--width", o.width, "pixels")->check(CLI::PositiveNumber);
  render->add_option("--height", o.height, "pixels")->check(CLI::PositiveNumber);
  render->add_option("--frames", o.frames, "pictures that are timed")->check(CLI::PositiveNumber);
  render->add_option("--picture", o.picture, "a PNG file to keep one in");
  return render;
}

void run_render(const CommonOptions& common, const RenderOptions& options, Results& results) {
  for (int particles : options.dam.particles) results.add(run_case(common, options, particles));
}

}  // namespace meniscus::bench
