// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The part of scene_fields.h about what must hold while a scene runs.
#pragma once

#include <iterator>
#include <utility>

#include <meniscus/scene.h>
#include "sdk/fields/values.h"

namespace meniscus {

struct CheckText {
  const char *type, *unit, *text;
};

/// In the order of CheckKind.
inline constexpr CheckText check_texts[] = {
    {"outside", "", "how many particles are beyond a container's wall, or inside a solid"},
    {"crossings", "", "how often particles have passed through cloth so far"},
    {"density_error", "", "mean excess of density over all particles; 0.01 is 1 %"},
    {"energy", "", "energy of particles, cloth and ropes above the floor, over that at the start"},
    {"share_inside", "", "share of the particles that are in a box, 0 to 1"},
    {"body_position", "m", "a coordinate of a body's frame, m"},
    {"body_speed", "m/s", "speed of a body's centre of mass, m/s"},
    {"body_tilt", "degrees", "angle from a body's y axis to the vertical, degrees"},
    {"cloth_position", "m", "a coordinate of a piece's centre of mass, m"},
    {"mean_stretch", "", "mean strain of a piece's edges; 0.01 is 1 %"},
    {"max_stretch", "", "largest length of an edge over that at rest"},
    {"cloth_volume", "", "volume of a closed piece, over that at the start"},
    {"tears", "", "vertices of a piece that have torn in two so far"},
    {"probe", "", "what a probe measures, in its unit"},
};
static_assert(std::size(check_texts) == static_cast<std::size_t>(CheckKind::probe) + 1);

/// A check as its kind alone describes it.
template <CheckKind kind>
struct CheckOf {
  SceneCheck check;

  operator SceneCheck() const {
    SceneCheck result = check;
    result.kind = kind;
    return result;
  }
};

constexpr bool is_of_body(CheckKind kind) {
  return kind == CheckKind::body_position || kind == CheckKind::body_speed || kind == CheckKind::body_tilt;
}

constexpr bool is_of_cloth(CheckKind kind) {
  return kind == CheckKind::cloth_position || kind == CheckKind::mean_stretch ||
         kind == CheckKind::max_stretch || kind == CheckKind::cloth_volume || kind == CheckKind::tears;
}

/// What should not happen at all; its limit need not be given.
constexpr bool is_fault(CheckKind kind) {
  return kind == CheckKind::outside || kind == CheckKind::crossings;
}

template <class V, CheckKind kind>
void fields(V& v, CheckOf<kind>& c) {
  SceneCheck& d = c.check;
  v("name", d.name, required(not_empty), "", "what outputs call this check");
  if constexpr (is_of_body(kind)) v("body", d.body, required(not_empty), "", "name of the body");
  if constexpr (is_of_cloth(kind)) v("cloth", d.cloth, required(not_empty), "", "name of the piece of cloth");
  if constexpr (kind == CheckKind::crossings)
    v("cloth", d.cloth, not_empty, "", "name of the piece of cloth; left out, all cloth counts");
  if constexpr (kind == CheckKind::probe) v("probe", d.probe, required(not_empty), "", "name of the probe");
  if constexpr (kind == CheckKind::body_position || kind == CheckKind::cloth_position)
    v("axis", d.axis, any_value, "", "which coordinate");
  if constexpr (kind == CheckKind::share_inside)
    v("region", d.region, required(any_value), "", "the box, in the world");
  v("low", d.low, any_value, "", "least allowed; left out, any");
  v("high", d.high, any_value, "",
    is_fault(kind) ? "greatest allowed; left out, 0" : "greatest allowed; left out, any");
  v("from", d.from, not_negative, "s", "frames that end earlier do not count");
  v("until", d.until, not_negative, "s", "frames that end later do not count; left out, all do");
  if constexpr (is_fault(kind)) {
    if (!d.high) d.high = 0.0f;
  }
  v.check(d.low || d.high, "low or high is needed");
  v.check(!d.low || !d.high || *d.low <= *d.high, "low must not be above high");
  v.check(!d.until || d.from <= *d.until, "from must not be above until");
}

template <class V, std::size_t... kinds>
void check_choices(V& v, SceneCheck& c, std::index_sequence<kinds...>) {
  (v.choice(check_texts[kinds].type, CheckOf<static_cast<CheckKind>(kinds)>{}, c, check_texts[kinds].text),
   ...);
}

template <class V>
void choices(V& v, SceneCheck& c) {
  check_choices(v, c, std::make_index_sequence<std::size(check_texts)>{});
}

}  // namespace meniscus
