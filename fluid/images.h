// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Walls by the method of images. Beside a wall a particle lacks the neighbours behind it. The wall gives it
// the mirror images of those in front, and of itself, with the multipliers of the originals: density, the
// push of a constant pressure and the pressure differences along the wall are then what they are in the
// middle of the fluid. The more usual integral of the kernel over the solid gives the first alone. Without
// the last, the layer at a wall weighs more than the pressure bears, and a vessel at rest stirs itself: down
// along the walls, up in the middle.
//
// The image of j is farther from i than j is, so the neighbour list holds every image that counts. What i and
// j get through a plane wall is opposite along it, and adds up away from it: the wall feels the pressure, and
// no drag. Where walls meet there are images of images: x' = x − Σ 2 d_k n_k, exact for walls at right
// angles.
#pragma once

#include "fluid/kernel.h"
#include "pbd/contacts.h"
#include "pbd/particles.h"

namespace meniscus::fluid {

/// The mirrors near one particle: at most the three nearest.
struct Mirrors {
  static constexpr int most = 3;
  static constexpr int most_images = 1 << most;  ///< the thing itself, number 0, counted in

  int count = 0;
  uint32_t contact[most];
  Vec3 normal[most];
  float offset[most];        ///< m: the plane is normal · x = offset
  float weight[most];        ///< how much of a half-space is behind it
  float share[most_images];  ///< how much each image counts
  float slack;               ///< m: what has sunk in no deeper counts as on the surface

  /// Images are numbered 1 to image_count(): bit k says that mirror k takes part.
  MENISCUS_HD int image_count() const { return (1 << count) - 1; }

  /// Mirrors x; what is behind a mirror has no image, and is sent far away.
  template <class R>
  MENISCUS_HD pbd::Vec3Of<R> reflect(int image, const pbd::Vec3Of<R>& x) const {
    pbd::Vec3Of<R> y = x;
    MENISCUS_UNROLL
    for (int k = 0; k < most; ++k) {
      if (!(image >> k & 1)) continue;
      const R d = R(normal[k].x) * x.x + R(normal[k].y) * x.y + R(normal[k].z) * x.z - R(offset[k]);
      const R twice = select_less(d, R(-slack), R(pbd::Particles::far_away), R(2.0f) * max(d, R(0.0f)));
      y.x += R(-normal[k].x) * twice;
      y.y += R(-normal[k].y) * twice;
      y.z += R(-normal[k].z) * twice;
    }
    return y;
  }
};

/// Mirrors at right angles make an image of an image; parallel ones do not.
MENISCUS_HD inline float share_of_image(const Mirrors& m, int image) {
  float share = 1;
  for (int k = 0; k < Mirrors::most; ++k) {
    if (!(image >> k & 1)) continue;
    share *= m.weight[k];
    for (int l = 0; l < k; ++l) {
      if (image >> l & 1) share *= 1 - fabsf(dot(m.normal[k], m.normal[l]));
    }
  }
  return share;
}

/// The mirrors that the contacts of particle i at x make.
MENISCUS_HD inline Mirrors mirrors_at(const pbd::ContactView& contacts, uint32_t i, Vec3 x, float h) {
  Mirrors m;
  m.slack = 0.25f * h;
  float distance[Mirrors::most];
  for (uint32_t c = contacts.start[i]; c < contacts.start[i + 1]; ++c) {
    const pbd::Contact& contact = contacts.contacts[c];
    const float d = plane_distance(contact, x);
    if (d >= h || contact.fraction == 0) continue;
    int at = m.count;
    if (at == Mirrors::most) {  // the farthest gives way
      at = 0;
      for (int k = 1; k < Mirrors::most; ++k) at = distance[k] > distance[at] ? k : at;
      if (distance[at] <= d) continue;
    } else {
      ++m.count;
    }
    distance[at] = d;
    m.contact[at] = c;
    m.normal[at] = contact.normal;
    m.offset[at] = dot(contact.normal, contact.point);
    m.weight[at] = contact.fraction;
  }
  for (int k = 1; k < m.count; ++k) {  // two solids that make up one wall share it
    for (int l = 0; l < k; ++l) {
      if (dot(m.normal[k], m.normal[l]) > 0.9f) m.weight[k] = pbd::min(m.weight[k], 1 - m.weight[l]);
    }
  }
  MENISCUS_UNROLL
  for (int image = 1; image < Mirrors::most_images; ++image) {
    m.share[image] = image <= m.image_count() ? share_of_image(m, image) : 0;
  }
  return m;
}

}  // namespace meniscus::fluid
