// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of pbd::VertexMeans: means of vertices at contacts of fluid, and the transpose.
#pragma once

#include "collision/fluid_cloth/load.h"

namespace meniscus::collision::fluid_cloth_kernels {

/// The mean of its vertices at each contact. A team works on it.
struct MeansAtContacts {
  NearList near;
  View<const Vec4> values;  // by vertex
  View<Vec4> means;         // by contact

  MENISCUS_HD void operator()(uint32_t n) const {
    if (n >= most_touches * near.count()) return;
    const FluidClothContact& t = near.touches[n];
    if (!is_used(t) || t.contact >= means.count) return;
    const Vec3 mean = t.mean([&](uint32_t v) { return values[v].xyz(); });
    if (TouchTeam::leads()) means[t.contact] = pbd::with_w(mean, 0);
  }
};

/// What acts on each vertex, of what acts on the contacts. A team works on it.
struct SumsAtVertices {
  LoadedVertices vertices;  // their unit is that of the sums
  View<const Vec4> values;  // by contact
  View<Vec4> sums;          // by vertex

  MENISCUS_HD void operator()(uint32_t v) const {
    int64_t x = 0, y = 0, z = 0, w = 0;
    const float unit = vertices.unit;
    vertices.for_each(v, [&](const FluidClothContact& t, float weight) {
      if (t.contact >= values.count) return;
      const Vec4 value = values[t.contact];
      const Vec3 part = (weight / unit) * value.xyz();
      x += pbd::whole_units(part.x);
      y += pbd::whole_units(part.y);
      z += pbd::whole_units(part.z);
      w += pbd::whole_units(weight / unit * value.w);
    });
    const Vec3 sum{static_cast<float>(VertexTeam::sum(x)), static_cast<float>(VertexTeam::sum(y)),
                   static_cast<float>(VertexTeam::sum(z))};
    const auto last = static_cast<float>(VertexTeam::sum(w));
    if (VertexTeam::leads()) sums[v] = pbd::with_w(unit * sum, unit * last);
  }
};

}  // namespace meniscus::collision::fluid_cloth_kernels
