// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Force fields.
#pragma once

#include <meniscus/force_fields.h>

#include "sdk/fields/fluid.h"

namespace meniscus {

constexpr auto names_of(ForceQuantity) {
  return std::array{Named{"acceleration", ForceQuantity::acceleration},
                    Named{"force_density", ForceQuantity::force_density}};
}

template <class V>
void fields(V& v, UniformForce& d) {
  v("value", d.value, any_value, "m/s² or N/m³", "the amount everywhere");
}

template <class V>
void fields(V& v, RadialForce& d) {
  v("strength", d.strength, any_value, "m/s² or N/m³",
    "amount at the radius, away from the origin; below 0 towards it");
  v("radius", d.radius, positive, "m", "where the amount is the strength");
  v("exponent", d.exponent, between(-1, 4), "", "the amount falls with this power of the distance");
  v("softening", d.softening, positive, "m", "keeps the amount finite at the origin");
}

template <class V>
void fields(V& v, VortexForce& d) {
  v("angular_velocity", d.angular_velocity, any_value, "rad/s", "of the flow, about y");
  v("rate", d.rate, not_negative, "1/s", "at which velocities become that of the flow");
}

template <class V>
void fields(V& v, DragForce& d) {
  v("velocity", d.velocity, any_value, "m/s", "towards which it drags");
  v("linear", d.linear, not_negative, "1/s or kg/(m³·s)", "part that grows with the difference");
  v("quadratic", d.quadratic, not_negative, "1/m or kg/m⁴", "part that grows with its square");
}

template <class V>
void fields(V& v, NoiseForce& d) {
  v("strength", d.strength, any_value, "m/s² or N/m³", "RMS of the amount");
  v("size", d.size, positive, "m", "distance between the nodes of the noise");
  v("period", d.period, not_negative, "s", "from one pattern to the next; 0: it does not change");
  v("seed", d.seed, any_value, "", "chooses the pattern");
}

template <class V>
void fields(V& v, GridForce& d) {
  constexpr FieldRule nodes = between(2, 4096);
  constexpr std::size_t most_nodes = std::size_t{1} << 24;
  v("lower", d.lower, any_value, "m", "the first node");
  v("cell_size", d.cell_size, positive, "m", "distance between nodes");
  v("nodes_x", d.nodes_x, required(nodes), "", "nodes along x");
  v("nodes_y", d.nodes_y, required(nodes), "", "nodes along y");
  v("nodes_z", d.nodes_z, required(nodes), "", "nodes along z");
  v("values", d.values, required(with_items(8)), "m/s² or N/m³",
    "nodes_x · nodes_y · nodes_z vectors, x fastest, then y");
  const std::size_t all = std::size_t(d.nodes_x) * std::size_t(d.nodes_y) * std::size_t(d.nodes_z);
  v.check(all <= most_nodes, "a grid has at most 16777216 nodes", "nodes_z", d.nodes_z);
  v.check(d.values.size() == all,
          "values must hold nodes_x · nodes_y · nodes_z = " + std::to_string(all) + " vectors, not " +
              std::to_string(d.values.size()),
          "values", d.values);
}

template <class V>
void choices(V& v, Force& f) {
  v.choice("uniform", UniformForce{}, f, "the same everywhere");
  v.choice("radial", RadialForce{}, f, "away from the origin or towards it, by a power of the distance");
  v.choice("vortex", VortexForce{}, f, "a flow that turns about y as a rigid body does");
  v.choice("drag", DragForce{}, f, "towards a velocity");
  v.choice("noise", NoiseForce{}, f, "turbulence without divergence");
  v.choice("grid", GridForce{}, f, "values on a grid");
}

template <class V>
void fields(V&, EverywhereRegion&) {}

template <class V>
void choices(V& v, ForceRegion& r) {
  v.choice("everywhere", EverywhereRegion{}, r, "all of space");
  v.choice("box", BoxRegion{}, r, "a box");
  v.choice("ball", BallRegion{}, r, "a ball about the origin");
}

template <class V>
void fields(V& v, ForceFieldDef& d) {
  v("name", d.name, required(not_empty), "", "what outputs call this field");
  v("force", d.force, required(any_value), "", "the law, in the frame of the field");
  v("quantity", d.quantity, any_value, "",
    "what amounts are: an acceleration, or a force per volume, which cloth and ropes do not feel");
  v("region", d.region, any_value, "", "where it acts, in the frame of the field");
  v("pose", d.pose, any_value, "", "placement of the field in the world");
  v("fluids", d.fluids, any_value, "", "whether it acts on fluids");
  v("grains", d.grains, any_value, "", "whether it acts on granular materials");
  v("cloth", d.cloth, any_value, "", "whether it acts on cloth and ropes");
  v("bodies", d.bodies, any_value, "", "whether it acts on dynamic bodies");
  v.check(d.quantity == ForceQuantity::acceleration || !std::holds_alternative<VortexForce>(d.force),
          "a vortex is an acceleration alone", "quantity");
}

}  // namespace meniscus
