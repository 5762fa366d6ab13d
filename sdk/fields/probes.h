// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Probes.
#pragma once

#include "sdk/fields/names.h"
#include "sdk/fields/values.h"

namespace meniscus {

constexpr auto names_of(ProbeKind) {
  return std::array{Named{"point_pressure", ProbeKind::point_pressure},
                    Named{"wall_pressure", ProbeKind::wall_pressure},
                    Named{"wall_force", ProbeKind::wall_force},
                    Named{"wall_torque", ProbeKind::wall_torque},
                    Named{"point_velocity", ProbeKind::point_velocity},
                    Named{"point_density", ProbeKind::point_density},
                    Named{"flow", ProbeKind::flow},
                    Named{"level", ProbeKind::level},
                    Named{"fluid_momentum", ProbeKind::fluid_momentum},
                    Named{"fluid_angular_momentum", ProbeKind::fluid_angular_momentum},
                    Named{"fluid_centre", ProbeKind::fluid_centre}};
}

constexpr bool is_of_shape(ProbeKind kind) {
  return kind == ProbeKind::wall_pressure || kind == ProbeKind::wall_force || kind == ProbeKind::wall_torque;
}
constexpr bool is_of_fluid(ProbeKind kind) {
  return kind >= ProbeKind::fluid_momentum;
}
constexpr bool is_of_point(ProbeKind kind) {
  return kind == ProbeKind::point_pressure || kind == ProbeKind::point_velocity ||
         kind == ProbeKind::point_density;
}
constexpr bool is_along_normal(ProbeKind kind) {
  return kind == ProbeKind::flow || kind == ProbeKind::level;
}
constexpr bool is_vector(ProbeKind kind) {
  return kind == ProbeKind::wall_force || kind == ProbeKind::wall_torque ||
         kind == ProbeKind::point_velocity || is_of_fluid(kind);
}

/// Of a probe of one kind. `names` has the name of the shape, or its id.
template <ProbeKind kind, class V, class Names>
void probe_fields(V& v, ProbeDef& d, Names& names) {
  v("name", d.name, required(not_empty), "", "what outputs call this probe");
  if constexpr (is_of_point(kind)) v("point", d.point, required(any_value), "m", "where to measure");
  if constexpr (is_of_shape(kind)) v("shape", names.shape, required(not_empty), "", "name of the shape");
  if constexpr (is_along_normal(kind)) {
    v("point", d.point, required(any_value), "m",
      kind == ProbeKind::flow ? "centre of the disc" : "foot of the column, on the floor or in the pool");
    v("normal", d.normal, any_value, "", "direction in which it counts; of a length from 1e-6 to 1e18");
    v("radius", d.radius, required(positive), "m", kind == ProbeKind::flow ? "of the disc" : "of the column");
    check_direction(v, "normal", d.normal);
  }
  if constexpr (is_of_fluid(kind))
    v("fluid", names.fluid, any_value, "", "name of the fluid or granular material; left out, all");
  if constexpr (kind == ProbeKind::wall_torque || kind == ProbeKind::fluid_angular_momentum)
    v("point", d.point, any_value, "m", "about which it is");
  if constexpr (kind == ProbeKind::wall_pressure) {
    v("patch", d.patch, required(any_value), "", "contacts inside this box count");
    v("area", d.area, required(positive), "m²", "area of the surface inside the patch");
  }
  if constexpr (kind == ProbeKind::wall_force || kind == ProbeKind::wall_torque) {
    v("patch", d.patch, any_value, "", "contacts inside this box count; left out, all of the shape's do");
  }
}

/// As C++ has it; in a file the kind is the "type" (see scene_fields.h).
template <OfMembers V>
void fields(V& v, ProbeDef& d) {
  v("kind", d.kind, any_value, "", "what it measures");
  if (d.kind == ProbeKind::point_pressure) probe_fields<ProbeKind::point_pressure>(v, d, d);
  if (d.kind == ProbeKind::wall_pressure) probe_fields<ProbeKind::wall_pressure>(v, d, d);
  if (d.kind == ProbeKind::wall_force) probe_fields<ProbeKind::wall_force>(v, d, d);
  if (d.kind == ProbeKind::wall_torque) probe_fields<ProbeKind::wall_torque>(v, d, d);
  if (d.kind == ProbeKind::point_velocity) probe_fields<ProbeKind::point_velocity>(v, d, d);
  if (d.kind == ProbeKind::point_density) probe_fields<ProbeKind::point_density>(v, d, d);
  if (d.kind == ProbeKind::flow) probe_fields<ProbeKind::flow>(v, d, d);
  if (d.kind == ProbeKind::level) probe_fields<ProbeKind::level>(v, d, d);
  if (d.kind == ProbeKind::fluid_momentum) probe_fields<ProbeKind::fluid_momentum>(v, d, d);
  if (d.kind == ProbeKind::fluid_angular_momentum) probe_fields<ProbeKind::fluid_angular_momentum>(v, d, d);
  if (d.kind == ProbeKind::fluid_centre) probe_fields<ProbeKind::fluid_centre>(v, d, d);
}

}  // namespace meniscus
