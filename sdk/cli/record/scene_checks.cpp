// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Evaluates the checks of a scene after every frame.
#include "sdk/cli/record/scene_checks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "pbd/math/vec.h"
#include "sdk/cli/record/energy_history.h"
#include "sdk/scene/scene_fields_checks.h"

namespace meniscus::cli {
namespace {

using json = nlohmann::ordered_json;

double along(Axis axis, Vec3 v) {
  return axis == Axis::x ? v.x : axis == Axis::y ? v.y : v.z;
}

double share_inside(const Aabb& box, std::span<const Vec3> points) {
  const auto is_inside = [&](Vec3 p) { return ordered(box.lower, p) && ordered(p, box.upper); };
  const auto inside = std::count_if(points.begin(), points.end(), is_inside);
  return points.empty() ? 0 : static_cast<double>(inside) / static_cast<double>(points.size());
}

/// The index of the first with this name; 0 if there is none, as for an empty name.
template <class Things, class NameOf>
std::size_t place_of(const std::string& name, const Things& things, NameOf name_of) {
  const auto found =
      std::find_if(things.begin(), things.end(), [&](const auto& thing) { return name_of(thing) == name; });
  return found == things.end() ? 0 : static_cast<std::size_t>(found - things.begin());
}

bool is_allowed(const SceneCheck& check, double value) {
  return value >= check.low.value_or(-std::numeric_limits<float>::infinity()) &&
         value <= check.high.value_or(std::numeric_limits<float>::infinity());
}

json limit(const std::optional<float>& value) {
  return value ? json(*value) : json();
}

}  // namespace

void expect_floor(const Scene& scene) {
  for (const SceneCheck& check : scene.checks) {
    if (check.kind == CheckKind::energy && !floor_level(scene))
      throw Error(
          ErrorCode::invalid_argument,
          "the check \"" + check.name +
              "\" is of energy, which needs a level plane or a container as a floor to be measured from");
  }
}

SceneChecks::SceneChecks(const Scene& scene) : scene_(scene), seen_(scene.checks.size()) {
  expect_floor(scene);
  const auto own_name = [](const auto& def) { return def.name; };
  const std::vector<BodyDef> bodies = bodies_of(scene);
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const SceneCheck& check = scene.checks[i];
    seen_[i].body = place_of(check.body, bodies, own_name);
    seen_[i].cloth = place_of(check.cloth, scene.cloths, own_name);
    seen_[i].probe = place_of(check.probe, scene.probes, [](const auto& probe) { return probe.def.name; });
    if (check.kind == CheckKind::crossings) crossings_.emplace();
  }
}

void SceneChecks::start(const FrameSample& sample) {
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    if (scene_.checks[i].kind == CheckKind::cloth_volume)
      seen_[i].start_volume = sample.cloths.at(seen_[i].cloth).volume;
  }
  if (crossings_) crossings_->start(sample);
}

void SceneChecks::add(const FrameSample& sample, std::optional<double> energy) {
  if (crossings_) crossings_->add(sample);
  const double rounding = 1e-3 * double{scene_.frame_time}, time = sample.particles.time;
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const SceneCheck& check = scene_.checks[i];
    Seen& seen = seen_[i];
    if (check.kind == CheckKind::tears) seen.tears += sample.tears.at(seen.cloth);
    if (time < double{check.from} - rounding) continue;
    if (check.until && time > double{*check.until} + rounding) continue;
    // Without energy at the start there is nothing to compare with.
    if (check.kind == CheckKind::energy && !energy) continue;
    const double now = value(check, seen, sample, energy);
    seen.least = seen.reached ? std::min(seen.least, now) : now;
    seen.most = seen.reached ? std::max(seen.most, now) : now;
    seen.reached = true;
    if (!seen.broken_at && !is_allowed(check, now)) seen.broken_at = time;
  }
}

double SceneChecks::value(const SceneCheck& check, const Seen& seen, const FrameSample& sample,
                          std::optional<double> energy) const {
  switch (check.kind) {
    case CheckKind::outside:
      return static_cast<double>(sample.diagnostics.outside);
    case CheckKind::crossings:
      return static_cast<double>(check.cloth.empty() ? crossings_->through_all()
                                                     : crossings_->through(seen.cloth));
    case CheckKind::density_error:
      return sample.diagnostics.density_error_mean;
    case CheckKind::energy:
      return *energy;
    case CheckKind::share_inside:
      return share_inside(check.region, sample.particles.positions);
    case CheckKind::body_position:
      return along(check.axis, sample.bodies.at(seen.body).pose.position);
    case CheckKind::body_speed:
      return length(sample.bodies.at(seen.body).velocity);
    case CheckKind::body_tilt:
      return tilt(sample.bodies.at(seen.body));
    case CheckKind::cloth_position:
      return along(check.axis, sample.cloths.at(seen.cloth).centre);
    case CheckKind::mean_stretch:
      return sample.cloths.at(seen.cloth).mean_stretch;
    case CheckKind::max_stretch:
      return sample.cloths.at(seen.cloth).max_stretch;
    case CheckKind::cloth_volume:
      return sample.cloths.at(seen.cloth).volume / seen.start_volume;
    case CheckKind::tears:
      return static_cast<double>(seen.tears);
    case CheckKind::probe:
      return sample.probes.at(seen.probe);
  }
  return 0;
}

double SceneChecks::tilt(const BodyState& body) const {
  const Vec3 up = normalized_or(-scene_.world.gravity, {0, 1, 0});
  const Vec3 axis = rotate(body.pose.rotation, {0, 1, 0});
  return std::atan2(length(cross(axis, up)), dot(axis, up)) * 180 / std::numbers::pi;
}

json SceneChecks::summary() const {
  json list = json::array();
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const SceneCheck& check = scene_.checks[i];
    const Seen& seen = seen_[i];
    const CheckText& text = check_texts[static_cast<std::size_t>(check.kind)];
    json entry{{"name", check.name},
               {"type", text.type},
               {"unit", text.unit},
               {"low", limit(check.low)},
               {"high", limit(check.high)},
               {"least", seen.reached ? json(seen.least) : json()},
               {"most", seen.reached ? json(seen.most) : json()},
               {"state", !seen.reached    ? "not reached"
                         : seen.broken_at ? "broken"
                                          : "held"}};
    if (seen.broken_at) entry["broken_at_s"] = *seen.broken_at;
    list.push_back(std::move(entry));
  }
  return list;
}

}  // namespace meniscus::cli
