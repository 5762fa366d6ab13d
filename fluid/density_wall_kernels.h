// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of the density constraint, for particles that touch a wall: as in density_kernels.h, with
// images. They run over contacts.particles.
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
  DensitySums<float> own_images;
  for (int image = 0; image <= mirrors.image_count(); ++image) {
    const float share = mirrors.image_weight(image);
    if (share == 0) continue;
    pbd::for_each_neighbour<D>(neighbours, i, [&](auto j) {
      const auto other = gather(position, j);
      sums.add(kernel, x - mirrors.reflect(image, other.xyz()), other.w, Real(share));
    });
    if (image == 0) continue;
    const Vec3Of<float> d = x - mirrors.reflect(image, Vec3Of<float>{x.x, x.y, x.z});
    own_images.add(kernel, d, 0.0f, share);
  }
  const Vec3 gradient = sum_vector(sums.gradient) + sum_vector(own_images.gradient);
  return {sum(sums.weight) + own_images.weight + kernel.weight(0.0f) - 1,
          self.w * dot(gradient, gradient) + sum(sums.gradient2), gradient};
}

template <class D>
struct AdvanceAtWalls {
  Kernel kernel;
  NeighbourView neighbours;
  ContactView contacts;
  Advancing advancing;

  MENISCUS_HD void operator()(uint32_t k) const {
    const uint32_t i = contacts.particles[k];
    advancing.advance(i, density_constraint_at_walls<D>(kernel, advancing.position, neighbours, contacts, i));
  }
};

template <class D, bool with_pair_pressure>
struct CorrectAtWalls {
  Kernel kernel;
  PairPressure pair;
  View<const Vec4> staged;
  NeighbourView neighbours;
  ContactView contacts;
  View<Vec4> position;

  MENISCUS_HD void operator()(uint32_t k) const {
    const uint32_t i = contacts.particles[k];
    const Vec4 self = staged[i];
    const Vec3 x = self.xyz();
    const Mirrors mirrors = mirrors_at(contacts, i, x, kernel.h);
    Vec3 total = push_of_image(mirrors, 0, 1.0f, i, self);
    for (int image = 1; image <= mirrors.image_count(); ++image) {
      const float share = mirrors.image_weight(image);
      if (share == 0) continue;
      const Vec3Of<float> d = x - mirrors.reflect(image, Vec3Of<float>{x.x, x.y, x.z});
      const Vec3 own = share * sum_vector(pair_push<with_pair_pressure, float>(kernel, pair, d, 2 * self.w));
      const Vec3 push = own + push_of_image(mirrors, image, share, i, self);
      note_reaction(mirrors, image, push);
      total += push;
    }
    const float w = position[i].w;
    position[i] = pbd::with_w(x + w * total, w);
  }

  MENISCUS_HD Vec3 push_of_image(const Mirrors& mirrors, int image, float share, uint32_t i,
                                 const Vec4& self) const {
    using Real = typename D::Real;
    Vec3Of<Real> push{Real(0.0f), Real(0.0f), Real(0.0f)};
    pbd::for_each_neighbour<D>(neighbours, i, [&](auto j) {
      const auto other = gather(staged, j);
      const Vec3Of<Real> d = self.xyz() - mirrors.reflect(image, other.xyz());
      push += pair_push<with_pair_pressure, Real>(kernel, pair, d, Real(self.w) + other.w);
    });
    return share * sum_vector(push);
  }

  /// Each mirror of an image takes the push along its normal; the first takes the rest, which a pair's other
  /// half takes back.
  MENISCUS_HD void note_reaction(const Mirrors& mirrors, int image, Vec3 push) const {
    Vec3 rest = push;
    int first = -1;
    for (int k = 0; k < Mirrors::most; ++k) {
      if (!(image >> k & 1)) continue;
      const Vec3 part = dot(rest, mirrors.normal[k]) * mirrors.normal[k];
      contacts.contacts[mirrors.contact[k]].density_push += part;
      rest -= part;
      if (first < 0) first = k;
    }
    contacts.contacts[mirrors.contact[first]].density_push += rest;
  }
};

template <class D>
struct Measure {
  Kernel kernel;
  View<const Vec4> position;
  NeighbourView neighbours;
  ContactView contacts;
  View<const uint32_t> slot;
  View<float> error;  ///< C
  View<float> full;   ///< 1 where the support is full, else 0

  MENISCUS_HD void operator()(uint32_t i) const {
    const Constraint c = density_constraint_at_walls<D>(kernel, position, neighbours, contacts, i);
    error[slot[i]] = c.value;
    // On a free surface |Σe| is about ½ over the spacing; in the inside it is the noise of disorder.
    const float threshold2 = 0.04f / cbrtf(kernel.volume * kernel.volume);
    full[slot[i]] = dot(c.gradient, c.gradient) < threshold2 && c.value > -0.3f ? 1.0f : 0.0f;
  }
};

}  // namespace meniscus::fluid::density_kernels
