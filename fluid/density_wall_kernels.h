// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of the density constraint, for particles that touch a wall: as in density_kernels.h, with
// images. They run over the contacts, and work at each particle's first one.
#pragma once

#include "fluid/density_kernels.h"
#include "fluid/images.h"

namespace meniscus::fluid::density_kernels {

template <class D>
MENISCUS_HD Constraint density_constraint_at_walls(const Kernel& kernel, View<const Vec4> position,
                                                   const NeighbourView& neighbours,
                                                   const ContactView& contacts, uint32_t i) {
  using Real = typename D::Real;
  const Vec4 self = position[i];
  const Vec3 x = self.xyz();
  const Mirrors mirrors = mirrors_at(contacts, i, x, kernel.h);
  DensitySums<Real> sums;
  pbd::for_each_neighbour<D>(neighbours, i, [&](auto j) {
    const auto other = gather(position, j);
    sums.add(kernel, x - other.xyz(), other.w, Real(1.0f));
    MENISCUS_UNROLL
    for (int image = 1; image < Mirrors::most_images; ++image) {
      if (image > mirrors.image_count()) break;
      sums.add(kernel, x - mirrors.reflect(image, other.xyz()), other.w, Real(mirrors.share[image]));
    }
  });
  DensitySums<float> own_images;
  MENISCUS_UNROLL
  for (int image = 1; image < Mirrors::most_images; ++image) {
    if (image > mirrors.image_count()) break;
    const Vec3Of<float> d = x - mirrors.reflect(image, Vec3Of<float>{x.x, x.y, x.z});
    own_images.add(kernel, d, 0.0f, mirrors.share[image]);
  }
  const Vec3 gradient = sum_vector(sums.gradient) + sum_vector(own_images.gradient);
  return {sum(sums.weight) + own_images.weight + kernel.weight(0.0f) - 1,
          self.w * dot(gradient, gradient) + sum(sums.gradient2), gradient};
}

struct AdvanceAtWalls {
  Kernel kernel;
  NeighbourView neighbours;
  ContactView contacts;
  Advancing advancing;

  template <class D>
  MENISCUS_HD void run(uint32_t n) const {
    const uint32_t i = contacts.particle_starting_at(n);
    if (i == pbd::no_index) return;
    const Constraint c = density_constraint_at_walls<D>(kernel, advancing.position, neighbours, contacts, i);
    if (D::leads()) advancing.advance(i, c);
  }
};

template <bool with_pair_pressure>
struct CorrectAtWalls {
  Kernel kernel;
  PairPressure pair;
  View<const Vec4> staged;
  NeighbourView neighbours;
  ContactView contacts;
  View<Vec4> position;

  template <class D>
  MENISCUS_HD void run(uint32_t n) const {
    using Real = typename D::Real;
    const uint32_t i = contacts.particle_starting_at(n);
    if (i == pbd::no_index) return;
    const Vec4 self = staged[i];
    const Vec3 x = self.xyz();
    const Mirrors mirrors = mirrors_at(contacts, i, x, kernel.h);
    Pushes<Real> pushes;
    pbd::for_each_neighbour<D>(neighbours, i, [&](auto j) {
      const auto other = gather(staged, j);
      pushes.add(kernel, pair, mirrors, x, other.xyz(), Real(self.w) + other.w);
    });
    Pushes<float> own;
    own.add(kernel, pair, mirrors, x, Vec3Of<float>{x.x, x.y, x.z}, 2 * self.w);
    Vec3 total = sum_vector(pushes.direct);
    Vec3 by_mirror[Mirrors::most];
    for (int k = 0; k < Mirrors::most; ++k) {
      by_mirror[k] = sum_vector(pushes.by_mirror[k]) + sum_vector(own.by_mirror[k]);
      total += by_mirror[k];
    }
    if (!D::leads()) return;
    for (int k = 0; k < Mirrors::most; ++k) {
      if (k < mirrors.count) contacts.contacts[mirrors.contact[k]].density_push += by_mirror[k];
    }
    const float w = position[i].w;
    position[i] = pbd::with_w(x + w * total, w);
  }

  /// What comes from particles, and what from images through each mirror, which is its part of the reaction.
  template <class R>
  struct Pushes {
    Vec3Of<R> direct{R(0.0f), R(0.0f), R(0.0f)}, by_mirror[Mirrors::most]{direct, direct, direct};

    MENISCUS_HD void add(const Kernel& kernel, const PairPressure& pair, const Mirrors& mirrors, Vec3 x,
                         const Vec3Of<R>& other, const R& multiplier) {
      direct += pair_push<with_pair_pressure, R>(kernel, pair, x - other, multiplier);
      MENISCUS_UNROLL
      for (int image = 1; image < Mirrors::most_images; ++image) {
        if (image > mirrors.image_count()) break;
        share_out(mirrors, image,
                  R(mirrors.share[image]) * pair_push<with_pair_pressure, R>(
                                                kernel, pair, x - mirrors.reflect(image, other), multiplier));
      }
    }

    /// An image of an image is pushed by each mirror along its normal; the last takes what is left, along the
    /// edge.
    MENISCUS_HD void share_out(const Mirrors& mirrors, int image, Vec3Of<R> push) {
      MENISCUS_UNROLL
      for (int k = 0; k < Mirrors::most; ++k) {
        if (!(image >> k & 1)) continue;
        const bool last = image >> (k + 1) == 0;
        const Vec3Of<R> part = last ? push : along(mirrors.normal[k], push);
        by_mirror[k] += part;
        push = push - part;
      }
    }

    MENISCUS_HD static Vec3Of<R> along(Vec3 n, const Vec3Of<R>& v) {
      const R size = dot(n, v);
      return {R(n.x) * size, R(n.y) * size, R(n.z) * size};
    }
  };
};

struct Measure {
  Kernel kernel;
  View<const Vec4> position;
  NeighbourView neighbours;
  ContactView contacts;
  View<const uint32_t> slot;
  View<float> error;  ///< C
  View<float> full;   ///< 1 where the support is full, else 0

  template <class D>
  MENISCUS_HD void run(uint32_t i) const {
    const Constraint c = density_constraint_at_walls<D>(kernel, position, neighbours, contacts, i);
    if (!D::leads()) return;
    error[slot[i]] = c.value;
    // On a free surface |Σe| is about ½ over the spacing; in the inside it is the noise of disorder.
    const float threshold2 = 0.04f / cbrtf(kernel.volume * kernel.volume);
    full[slot[i]] = dot(c.gradient, c.gradient) < threshold2 && c.value > -0.3f ? 1.0f : 0.0f;
  }
};

}  // namespace meniscus::fluid::density_kernels
