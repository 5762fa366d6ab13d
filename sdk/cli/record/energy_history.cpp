// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds the floor level of a scene, and relates energies to it.
#include "sdk/cli/record/energy_history.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "pbd/math/vec.h"

namespace meniscus::cli {
namespace {

/// The outward normal of a container's face, in its frame.
Vec3 outward(Face face) {
  switch (face) {
    case Face::x_low:
      return {-1, 0, 0};
    case Face::x_high:
      return {1, 0, 0};
    case Face::y_low:
      return {0, -1, 0};
    case Face::y_high:
      return {0, 1, 0};
    case Face::z_low:
      return {0, 0, -1};
    case Face::z_high:
      return {0, 0, 1};
  }
  return {0, 0, 0};
}

/// Nothing if the container is open at the bottom.
std::optional<double> floor_of(const ContainerGeometry& container, const Pose& pose, Vec3 up) {
  const Vec3 local_up = rotate(conjugate(pose.rotation), up);
  for (const Opening& opening : container.openings) {
    if (dot(outward(opening.face), local_up) < -0.1f) return std::nullopt;
  }
  return dot(pose.position, up) - dot(container.half_extents, abs(local_up));
}

std::optional<double> floor_of(const PlaneGeometry& plane, const Pose& pose, Vec3 up) {
  const float size = length(plane.normal);
  const Vec3 local = plane.normal / std::max(size, 1e-20f);
  if (dot(rotate(pose.rotation, local), up) < 0.999f) return std::nullopt;
  return dot(to_world(pose, plane.offset / std::max(size, 1e-20f) * local), up);
}

template <class Other>
std::optional<double> floor_of(const Other&, const Pose&, Vec3) {
  return std::nullopt;
}

}  // namespace

std::optional<double> floor_level(const Scene& scene) {
  if (length(scene.world.gravity) == 0) return std::nullopt;
  const Vec3 up = -scene.world.gravity / length(scene.world.gravity);
  std::optional<double> lowest;
  for (const ShapeDef& shape : scene.shapes) {
    const auto level = std::visit([&](const auto& g) { return floor_of(g, shape.pose, up); }, shape.geometry);
    if (level && (!lowest || *level < *lowest)) lowest = level;
  }
  return lowest;
}

EnergyHistory::EnergyHistory(const Scene& scene)
    : gravity_(length(scene.world.gravity)),
      up_(normalized_or(-scene.world.gravity, {0, 1, 0})),
      floor_(floor_level(scene)),
      lowest_(std::numeric_limits<double>::infinity()) {}

void EnergyHistory::add(const FrameSample& sample) {
  const Diagnostics& d = sample.diagnostics;
  moments_.push_back({d.kinetic_energy + d.potential_energy, sample.mass});
  if (floor_) return;
  look_for_lowest(sample.particles.positions);
  look_for_lowest(sample.cloth.vertices);
  look_for_lowest(sample.ropes.vertices);
}

void EnergyHistory::look_for_lowest(std::span<const Vec3> points) {
  for (const Vec3& p : points) lowest_ = std::min<double>(lowest_, dot(p, up_));
}

double EnergyHistory::above(double level, const Moment& moment) const {
  return moment.from_origin - moment.mass * gravity_ * level;
}

std::optional<double> EnergyHistory::ratio() const {
  if (!floor_ || moments_.empty()) return std::nullopt;
  const double start = above(*floor_, moments_.front());
  return start > 0 ? std::optional(above(*floor_, moments_.back()) / start) : std::nullopt;
}

nlohmann::ordered_json EnergyHistory::summary() const {
  if (moments_.empty()) return nullptr;
  const double level = floor_ ? *floor_ : lowest_ < std::numeric_limits<double>::infinity() ? lowest_ : 0;
  const double start = above(level, moments_.front()), end = above(level, moments_.back());
  double most = start;
  for (const Moment& moment : moments_) most = std::max(most, above(level, moment));
  const auto ratio = [&](double energy) {
    return start > 0 ? nlohmann::ordered_json(energy / start) : nlohmann::ordered_json();
  };
  return {{"start_j", start},
          {"end_j", end},
          {"max_j", most},
          {"end_ratio", ratio(end)},
          {"max_ratio", ratio(most)},
          {"zero_level_m", level},
          {"zero_level_is", floor_ ? "floor" : "lowest particle of the run"}};
}

}  // namespace meniscus::cli
