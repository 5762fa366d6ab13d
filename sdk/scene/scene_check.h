// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What must hold while a scene runs.
#pragma once

#include <meniscus/types.h>

#include <optional>
#include <string>

#include "sdk/fields/names.h"

namespace meniscus {

/// What a check looks at after every frame.
enum class CheckKind {
  outside,         ///< particles beyond a container's wall, or inside a solid
  crossings,       ///< passages of particles through cloth so far
  density_error,   ///< mean of max(C, 0) over all particles, C = ρ/ρ₀ − 1
  energy,          ///< of particles, cloth and ropes, above the floor, over that at the start
  share_inside,    ///< share of the particles that are in a box
  body_position,   ///< m, along an axis
  body_speed,      ///< m/s, of the centre of mass
  body_tilt,       ///< degrees, from the body's y axis to the vertical
  cloth_position,  ///< m, of the centre of mass, along an axis
  mean_stretch,    ///< mean over edges of |l/L − 1|
  max_stretch,     ///< largest l/L
  cloth_volume,    ///< of a closed piece, over that at the start
  tears,           ///< vertices that have torn in two so far
  probe,           ///< a probe's value, in its unit
};

struct SceneCheck {
  CheckKind kind = CheckKind::outside;
  std::string name;   ///< what outputs call it
  std::string body;   ///< BodyDef::name, for what bodies do
  std::string cloth;  ///< ClothDef::name, for what cloth does; of crossings, empty is all cloth
  std::string probe;  ///< ProbeDef::name, of a probe
  Axis axis = Axis::y;
  Aabb region{};                       ///< of share_inside
  std::optional<float> low{}, high{};  ///< what the value must stay between; at least one of them
  float from = 0;                      ///< s: frames that end earlier do not count
  std::optional<float> until{};        ///< s: likewise later; none: to the end, however long the run is
};

}  // namespace meniscus
