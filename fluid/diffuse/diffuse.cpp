// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Turns the user's definition of spray, foam and bubbles into the parameters of the kernels.
#include "fluid/diffuse/diffuse.h"

#include <cmath>

namespace meniscus::fluid {

DiffuseParameters diffuse_parameters(const DiffuseDef& def, float spacing, float support, Vec3 gravity) {
  DiffuseParameters p;
  p.def = def;
  p.support = support;
  p.radius = 0.5f * spacing;
  p.gravity = gravity;
  const int reach = static_cast<int>(support / spacing) + 1;
  for (int z = -reach; z <= reach; ++z) {
    for (int y = -reach; y <= reach; ++y) {
      for (int x = -reach; x <= reach; ++x) {
        const float r = spacing * std::sqrt(static_cast<float>(x * x + y * y + z * z));
        if (r > 0) p.full_weight += std::fmax(0.0f, 1 - r / support);
      }
    }
  }
  return p;
}

}  // namespace meniscus::fluid
