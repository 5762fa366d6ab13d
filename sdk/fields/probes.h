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
                    Named{"wall_force", ProbeKind::wall_force}};
}

/// Of a probe of one kind. `names` has the name of the shape, or its id.
template <ProbeKind kind, class V, class Names>
void probe_fields(V& v, ProbeDef& d, Names& names) {
  v("name", d.name, required(not_empty), "", "what outputs call this probe");
  if constexpr (kind == ProbeKind::point_pressure) {
    v("point", d.point, required(any_value), "m", "where to measure");
  } else {
    v("shape", names.shape, required(not_empty), "", "name of the shape");
  }
  if constexpr (kind == ProbeKind::wall_pressure) {
    v("patch", d.patch, required(any_value), "", "contacts inside this box count");
    v("area", d.area, required(positive), "m²", "area of the surface inside the patch");
  }
  if constexpr (kind == ProbeKind::wall_force) {
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
}

}  // namespace meniscus
