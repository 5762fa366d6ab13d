// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Emitters and sinks.
#pragma once

#include <meniscus/flow.h>

#include "sdk/fields/fluid.h"
#include "sdk/fields/shapes.h"

namespace meniscus {

template <class V>
void fields(V& v, DiscOpening& d) {
  v("radius", d.radius, positive, "m", "radius");
}

template <class V>
void fields(V& v, RectangleOpening& d) {
  v("width", d.width, positive, "m", "along x");
  v("depth", d.depth, positive, "m", "along z");
}

template <class V>
void fields(V& v, MeshOpening& d) {
  mesh_fields(v, d);
}

template <class V>
void choices(V& v, EmitterOpening& o) {
  v.choice("disc", DiscOpening{}, o, "a disc about the origin; particles leave along y");
  v.choice("rectangle", RectangleOpening{}, o, "a rectangle about the origin; particles leave along y");
  v.choice("mesh", MeshOpening{}, o, "the surface of a mesh; particles leave along its normals");
}

constexpr auto names_of(EmitterMode) {
  return std::array{Named{"free", EmitterMode::free}, Named{"imposed", EmitterMode::imposed}};
}

/// `names` has the names of what it refers to, or the ids.
template <class V, class Names>
void emitter_fields(V& v, EmitterDef& d, Names& names) {
  v("name", d.name, required(not_empty), "", "what outputs call this emitter");
  v("fluid", names.fluid, required(not_empty), "", "name of the fluid");
  v("opening", d.opening, required(any_value), "", "where particles leave from");
  v("pose", d.pose, any_value, "", "placement of the opening in the world, or in the frame of the body");
  v("body", names.body, any_value, "", "name of a body that carries the opening");
  v("speed", d.speed, positive, "m/s", "at which particles leave");
  v("rate", d.rate, not_negative, "m³/s", "how much leaves, up to speed · area; 0 is that");
  v("mode", d.mode, any_value, "",
    "free: what has room leaves; imposed: a piston pushes away what is in front");
  v("start", d.start, not_negative, "s", "when it begins");
  v("stop", d.stop, or_infinity(not_negative), "s", "when it ends; left out, never");
  v("most_particles", d.most_particles, any_value, "", "it makes no more than these; left out, any number");
  v.check(d.stop >= d.start, "stop must not be below start", "stop", d.stop);
}

template <class V>
void fields(V& v, EmitterDef& d) {
  emitter_fields(v, d, d);
}

template <class V>
void fields(V& v, HalfSpaceRegion& d) {
  v("normal", d.normal, any_value, "", "points out of the region; of a length from 1e-6 to 1e18");
  v("offset", d.offset, any_value, "m", "what is inside is nearer to the origin than this along the normal");
  check_direction(v, "normal", d.normal);
}

template <class V>
void choices(V& v, SinkRegion& r) {
  v.choice("box", BoxRegion{}, r, "a box");
  v.choice("ball", BallRegion{}, r, "a ball about the origin");
  v.choice("half_space", HalfSpaceRegion{}, r, "everything below a plane");
}

template <class V, class Names>
void sink_fields(V& v, SinkDef& d, Names& names) {
  v("name", d.name, required(not_empty), "", "what outputs call this sink");
  v("region", d.region, required(any_value), "", "particles inside are removed at the end of a frame");
  v("outside", d.outside, any_value, "", "removes the particles outside of the region instead");
  v("pose", d.pose, any_value, "", "placement of the region in the world, or in the frame of the body");
  v("body", names.body, any_value, "", "name of a body that carries the region");
}

template <class V>
void fields(V& v, SinkDef& d) {
  sink_fields(v, d, d);
}

}  // namespace meniscus
