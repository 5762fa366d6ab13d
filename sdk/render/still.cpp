// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Moves the camera over the lens, and things while the shutter is open.
#include "sdk/render/still.h"

#include <cmath>
#include <vector>

#include "pbd/math/vec.h"
#include "sdk/render/moment_parts.h"

namespace meniscus::render {
namespace {

void check(const StillSettings& s) {
  const auto fail = [](const std::string& name, const std::string& range) {
    throw Error(ErrorCode::invalid_argument, name + " must be " + range);
  };
  if (s.samples < 1 || s.samples > 4096) fail("samples", "1 to 4096");
  if (!std::isfinite(s.aperture) || s.aperture < 0) fail("aperture", "at least 0 m");
  if (!std::isfinite(s.shutter) || s.shutter < 0) fail("shutter", "at least 0 s");
}

/// All that moves, as copies.
struct Moved {
  std::vector<Ellipsoid> ellipsoids;
  std::vector<Vec3> positions;
  std::vector<DiffuseParticle> diffuse;
  std::vector<BodyState> bodies;

  Moment at(const Moment& moment, float time) {
    Moment now = moment;
    ellipsoids.assign(moment.ellipsoids.begin(), moment.ellipsoids.end());
    positions.assign(moment.positions.begin(), moment.positions.end());
    diffuse.assign(moment.diffuse.begin(), moment.diffuse.end());
    bodies.assign(moment.bodies.begin(), moment.bodies.end());
    for (std::size_t i = 0; i < moment.velocities.size(); ++i) {
      const Vec3 way = time * moment.velocities[i];
      if (i < ellipsoids.size()) ellipsoids[i].centre = ellipsoids[i].centre + way;
      if (i < positions.size()) positions[i] = positions[i] + way;
    }
    for (DiffuseParticle& piece : diffuse) piece.position = piece.position + time * piece.velocity;
    for (BodyState& body : bodies) move(body, time);
    move(now.cloth.vertices, moment.cloth.velocities, time);
    move(now.ropes.vertices, moment.ropes.velocities, time);
    now.ellipsoids = ellipsoids;
    now.positions = positions;
    now.diffuse = diffuse;
    now.bodies = bodies;
    return now;
  }

 private:
  static void move(std::vector<Vec3>& points, const std::vector<Vec3>& velocities, float time) {
    for (std::size_t i = 0; i < std::min(points.size(), velocities.size()); ++i)
      points[i] = points[i] + time * velocities[i];
  }

  static void move(BodyState& body, float time) {
    const float angle = length(body.angular_velocity) * time;
    const Vec3 axis = normalized_or(body.angular_velocity, {0, 1, 0});
    const float s = std::sin(angle / 2);
    const Quat turn{s * axis.x, s * axis.y, s * axis.z, std::cos(angle / 2)};
    const Vec3 arm = body.pose.position - body.centre_of_mass;
    body.centre_of_mass = body.centre_of_mass + time * body.velocity;
    body.pose = {body.centre_of_mass + rotate(turn, arm), turn * body.pose.rotation};
  }
};

/// The binary digits of k in reverse behind the point: even over any number of samples.
float radical_inverse(unsigned k) {
  float value = 0;
  for (float digit = 0.5f; k; k >>= 1, digit /= 2) value += digit * static_cast<float>(k & 1u);
  return value;
}

/// A place on a lens of the diameter 1, on a spiral.
std::array<float, 2> on_lens(int k, int count) {
  constexpr float golden_angle = 2.3999632f;
  const float away = 0.5f * std::sqrt((static_cast<float>(k) + 0.5f) / static_cast<float>(count));
  const float angle = golden_angle * static_cast<float>(k);
  return {away * std::cos(angle), away * std::sin(angle)};
}

}  // namespace

io::Image draw_still(Renderer& renderer, const Moment& moment, const StillSettings& settings) {
  check(settings);
  if (settings.samples == 1) return renderer.draw(moment);
  const SceneCamera camera = renderer.camera();
  const Vec3 ahead = normalized_or(camera.target - camera.position, {0, 0, -1});
  const Vec3 right = normalized_or(cross(ahead, renderer.up()), {1, 0, 0}), up = cross(right, ahead);
  const Moment still = with_spans(moment);
  Moved moved;
  renderer.load(still);
  for (int k = 0; k < settings.samples; ++k) {
    const auto [x, y] = on_lens(k, settings.samples);
    SceneCamera view = camera;
    view.position = view.position + settings.aperture * (x * right + y * up);
    renderer.set_camera(view);
    if (settings.shutter > 0)
      renderer.load(moved.at(still, settings.shutter * (radical_inverse(static_cast<unsigned>(k)) - 0.5f)));
    renderer.add_sample(k, settings.samples);
  }
  renderer.set_camera(camera);
  return renderer.image();
}

}  // namespace meniscus::render
