// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Pictures that show measured quantities instead of the natural look.
#pragma once

#include <meniscus/world.h>

#include <span>
#include <string>
#include <vector>

#include <meniscus/scene.h>
#include "sdk/render/frame/color_map.h"

namespace meniscus::render {

/// How fluid is drawn: as its surface, or as particles in the colours of a value.
enum class ParticleView { surface, speed, density_error, phase, pressure };

struct ViewChoice {
  ParticleView particles = ParticleView::surface;
  bool contacts =
      false;  ///< contacts of particles with solids and cloth: lines from the contact along the normal
  bool normals = false;  ///< all surfaces in the colours of their normals: red, green and blue for x, y and z
  bool strain = false;   ///< cloth in the colours of its largest principal strain
  bool distances = false;  ///< distances to the nearest solid, in a plane through the scene
  float plane = 0.5f;      ///< place of that plane, from 0 to 1 through the scene

  friend bool operator==(const ViewChoice&, const ViewChoice&) = default;
};

/// All names that view_choice knows, in the order of the list above.
std::span<const char* const> view_names();
/// The choice by names. Throws Error(invalid_argument) for an unknown name, and for two views of the
/// particles at once.
ViewChoice view_choice(std::span<const std::string> names);

/// The mapping of a value to a colour.
struct Scale {
  float low = 0, high = 1;
  ColorMap map = ColorMap::sequence;
  const char* unit = "";

  float place(float value) const { return (value - low) / (high - low); }
};

/// Signed distances on a grid in a plane, from `corner`; rows run along `across`.
struct DistanceSlice {
  Vec3 corner{0, 0, 0}, across{1, 0, 0}, up{0, 1, 0};  ///< m; the two edges
  int columns = 0, rows = 0;
  std::vector<float> distances;  ///< m
};

/// The data that the views of one moment need in addition.
struct ViewData {
  ViewChoice choice;
  Scale particles, strain, distances;
  std::vector<float> values;              ///< one per particle, if the choice asks for them
  std::vector<ParticleContact> contacts;  ///< likewise
  DistanceSlice slice;                    ///< likewise
};

/// Measures worlds for views. Scales grow with the values, and never shrink. So a colour means one value for
/// the whole run except its start.
class ViewMeter {
 public:
  /// `box`: around the scene. The plane of distances cuts it, and faces along `sight` as nearly as it can.
  /// `strains`: of all cloth (World::cloth_strains).
  ViewData measure(const World& world, const ViewChoice& choice, std::span<const float> strains,
                   const Aabb& box, Vec3 sight);

 private:
  float largest_speed_ = 0, largest_pressure_ = 0, largest_strain_ = 0;
};

}  // namespace meniscus::render
