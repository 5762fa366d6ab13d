// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Measures worlds for the views, and scales the values to colours.
#include "sdk/render/frame/views.h"

#include <meniscus/error.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "pbd/math/vec.h"
#include "sdk/scene/closest_name.h"

namespace meniscus::render {
namespace {

constexpr std::array names{"speed",    "density", "phase",  "pressure",
                           "contacts", "normals", "strain", "distances"};
constexpr std::size_t particle_views = 4;  // the first of these
constexpr float density_range = 0.05f;

/// A number of one or two digits, not below `value`.
float round_up(float value) {
  const float power = std::pow(10.0f, std::floor(std::log10(value)));
  for (const float digit : {1.0f, 1.5f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 8.0f}) {
    if (digit * power >= value) return digit * power;
  }
  return 10 * power;
}

/// The value below which all but a hundredth of the values lie. Values that are not finite are left out.
float usual_most(std::span<const float> all) {
  std::vector<float> values;
  std::copy_if(all.begin(), all.end(), std::back_inserter(values), [](float v) { return std::isfinite(v); });
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// From 0 to a round number above all values so far.
Scale growing_scale(float& largest, std::span<const float> values, float least, const char* unit) {
  largest = std::max({largest, usual_most(values), least});
  return {0, round_up(largest), ColorMap::sequence, unit};
}

std::vector<float> copy_of(std::span<const float> values) {
  return {values.begin(), values.end()};
}

/// Of the upright planes across a box, the one that faces the viewer more directly. `way` is its place from
/// one side to the other.
DistanceSlice plane_through(const Aabb& box, Vec3 sight, float way) {
  const Vec3 size = 1.1f * (box.upper - box.lower);
  const bool along_x = std::abs(sight.x) > std::abs(sight.z);
  const Vec3 across = (way - 0.5f) * (box.upper - box.lower);
  const Vec3 middle =
      0.5f * (box.lower + box.upper) + (along_x ? Vec3{across.x, 0, 0} : Vec3{0, 0, across.z});
  DistanceSlice slice;
  slice.across = along_x ? Vec3{0, 0, size.z} : Vec3{size.x, 0, 0};
  slice.up = {0, size.y, 0};
  slice.corner = middle - 0.5f * (slice.across + slice.up);
  const float aspect = std::clamp(length(slice.across) / std::max(length(slice.up), 1e-6f), 0.1f, 10.0f);
  slice.rows = static_cast<int>(160 / std::sqrt(aspect));
  slice.columns = static_cast<int>(160 * std::sqrt(aspect));
  return slice;
}

void measure_slice(const World& world, DistanceSlice& slice, float reach) {
  std::vector<Vec3> points;
  for (int j = 0; j < slice.rows; ++j) {
    for (int i = 0; i < slice.columns; ++i) {
      const float x = (static_cast<float>(i) + 0.5f) / static_cast<float>(slice.columns);
      const float y = (static_cast<float>(j) + 0.5f) / static_cast<float>(slice.rows);
      points.push_back(slice.corner + x * slice.across + y * slice.up);
    }
  }
  slice.distances = world.solid_distances(points, reach);
}

}  // namespace

std::span<const char* const> view_names() {
  return names;
}

ViewChoice view_choice(std::span<const std::string> wanted) {
  ViewChoice choice;
  for (const std::string& name : wanted) {
    const auto at = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    if (at == names.size()) {
      throw Error(ErrorCode::invalid_argument,
                  "no view is called '" + name + "'; " + name_hint(name, {names.begin(), names.end()}));
    }
    if (at < particle_views && choice.particles != ParticleView::surface)
      throw Error(ErrorCode::invalid_argument,
                  "the view '" + name + "' cannot be had with another one that colours particles");
    if (at < particle_views) choice.particles = static_cast<ParticleView>(at + 1);
    choice.contacts |= name == "contacts";
    choice.normals |= name == "normals";
    choice.strain |= name == "strain";
    choice.distances |= name == "distances";
  }
  return choice;
}

ViewData ViewMeter::measure(const World& world, const ViewChoice& choice, std::span<const float> strains,
                            const Aabb& box, Vec3 sight) {
  ViewData data;
  data.choice = choice;
  switch (choice.particles) {
    case ParticleView::surface:
      break;
    case ParticleView::speed:
      for (const Vec3 v : world.velocities()) data.values.push_back(length(v));
      data.particles = growing_scale(largest_speed_, data.values, 0.1f, "m/s");
      break;
    case ParticleView::density_error:
      data.values = copy_of(world.density_errors());
      data.particles = {-density_range, density_range, ColorMap::balance, "of rest density"};
      break;
    case ParticleView::phase:
      for (const uint32_t fluid : world.fluids()) data.values.push_back(static_cast<float>(fluid));
      break;
    case ParticleView::pressure:
      data.values = copy_of(world.pressures());
      data.particles = growing_scale(largest_pressure_, data.values, 1, "Pa");
      break;
  }
  if (choice.strain) data.strain = growing_scale(largest_strain_, strains, 0.01f, "");
  if (choice.contacts) data.contacts = world.particle_contacts();
  if (choice.distances) {
    const float reach = round_up(0.2f * length(box.upper - box.lower));
    data.slice = plane_through(box, sight, choice.plane);
    measure_slice(world, data.slice, reach);
    data.distances = {-reach, reach, ColorMap::balance, "m"};
  }
  return data;
}

}  // namespace meniscus::render
