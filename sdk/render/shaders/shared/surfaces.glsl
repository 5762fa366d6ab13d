// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// What of a surface light needs to know, for later.
layout(location = 0) out vec4 albedo_;  // a: gloss
layout(location = 1) out vec4 normal_;  // a: how much it is of fibres

void put(vec3 albedo, float gloss, vec3 normal, float fibres) {
  albedo_ = vec4(albedo, gloss);
  normal_ = vec4(normal, fibres);
}
