// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Ropes, what holds them and cloth, and the wind.
#pragma once

#include <meniscus/cloth.h>

#include <limits>

#include "sdk/fields/values.h"

namespace meniscus {

// ---- ropes ----

template <class V>
void fields(V& v, RopeDef& d) {
  bool unyielding = false;
  v("name", d.name, required(not_empty), "", "what attachments and outputs call this rope");
  v("points", d.points, required(with_items(2)), "m", "its vertices at rest, or with segments its corners");
  v("segments", d.segments, between(0, 1'000'000), "",
    "when above 0, the way along the points is divided into so many");
  v("pose", d.pose, any_value, "", "placement of the points");
  v("velocity", d.velocity, any_value, "m/s", "at the start");
  v("radius", d.radius, between(1e-6, 1e3), "m", "of its cross-section");
  v("density", d.density, between(1e-3, 1e6), "kg/m³", "of its material");
  v("bends_and_twists", d.bends_and_twists, any_value, "",
    "whether it is a rod, which resists bending and twist; a rope has a length alone");
  v("youngs_modulus", d.youngs_modulus, or_infinity(at_least(1e-6)), "Pa",
    "against stretch, and bending of a rod");
  v("shear_modulus", d.shear_modulus, at_least(1e-6), "Pa", "against twist of a rod");
  v("unyielding", unyielding, key_only(any_value), "",
    "whether youngs_modulus is infinite, whatever it says");
  v("damping", d.damping, not_negative, "s",
    "Rayleigh's: viscous forces are so many times the elastic ones' rate");
  v("closed", d.closed, any_value, "", "whether the last vertex is joined to the first");
  v("straight_at_rest", d.straight_at_rest, any_value, "", "of a rod: however the points lie");
  flat(v, "filter", d.filter);
  v("color", d.color, between(0, 1), "", "linear red, green and blue");
  if (unyielding) d.youngs_modulus = std::numeric_limits<float>::infinity();
  v.check(!d.closed || d.points.size() >= 3, "a closed rope needs at least 3 points", "points", d.points);
}

// ---- attachments ----

/// `names` has the names of what it refers to, or the ids.
template <class V, class Names>
void attachment_fields(V& v, AttachmentDef& d, Names& names) {
  constexpr FieldRule numbers = between(0, std::numeric_limits<uint32_t>::max());
  v("name", d.name, required(not_empty), "", "what messages and outputs call this attachment");
  v("cloth", names.cloth, not_empty, "",
    "name of the piece of cloth that is held; either this or rope is needed");
  v("rope", names.rope, not_empty, "", "name of the rope that is held");
  v("vertices", d.vertices, numbers, "", "which of its vertices, by number");
  v("region", d.region, any_value, "", "and those in this box of the world, as they lie at the start");
  v("body", names.body, not_empty, "", "name of the body that holds them; left out, the world does");
  v("other_cloth", names.other_cloth, not_empty, "",
    "name of a piece of cloth that they are sewn to instead");
  v("other_rope", names.other_rope, not_empty, "", "name of a rope that they are sewn to instead");
  v("reach", d.reach, positive, "m",
    "of a seam: each vertex is sewn to the nearest one of the other within this, the rest stay free");
  v("compliance", d.compliance, not_negative, "m/N", "of a seam");
  v("clamped", d.clamped, any_value, "",
    "whether a rod's segments between held vertices keep their direction");
  v.check(is_given(names.cloth) != is_given(names.rope), "exactly one of cloth and rope is needed");
  v.check(is_given(names.body) + is_given(names.other_cloth) + is_given(names.other_rope) <= 1,
          "at most one of body, other_cloth and other_rope is allowed");
  v.check(!d.vertices.empty() || d.region, "vertices or a region are needed");
}

template <class V>
void fields(V& v, AttachmentDef& d) {
  attachment_fields(v, d, d);
}

// ---- wind ----

template <class V>
void fields(V& v, WindDef& d) {
  v("velocity", d.velocity, any_value, "m/s", "mean velocity of the air");
  v("air_density", d.air_density, not_negative, "kg/m³", "0 is no air at all, and no drag");
  v("gust_speed", d.gust_speed, between(0, 1e6), "m/s", "standard deviation of the gusts");
  v("gust_size", d.gust_size, positive, "m", "of the gusts");
  v("seed", d.seed, between(0, std::numeric_limits<uint32_t>::max()), "", "equal seeds give equal gusts");
}

}  // namespace meniscus
