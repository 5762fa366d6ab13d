// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Kernels that colour contacts: two contacts of one colour share no body that moves.
#pragma once

#include "collision/rigid_contact/contact_kernels.h"
#include "pbd/device/base/atomics.h"

namespace meniscus::collision::rigid_contact_kernels {

/// Colours 0 to 62 are solved at once each. Contacts with the last one are solved one by one.
inline constexpr uint32_t serial_colour = 63, colour_count = 64, no_colour = ~0u;

/// A number for each contact, none twice.
MENISCUS_HD inline uint32_t rank_of(uint32_t contact) {
  return contact * 2654435769u;
}

/// The moving bodies of a contact; no_index for others.
struct TwoBodies {
  uint32_t a, b;
};

MENISCUS_HD inline void claim(View<uint32_t> claims, TwoBodies bodies, uint32_t contact) {
  if (bodies.a != pbd::no_index) pbd::atomic_min(claims[bodies.a], rank_of(contact));
  if (bodies.b != pbd::no_index) pbd::atomic_min(claims[bodies.b], rank_of(contact));
}

struct StartColouring {
  View<const uint32_t> contacts;
  View<const FoundContact> found;
  View<const ContactPart> parts;
  View<const PlacedPart> placed;
  View<TwoBodies> bodies;
  View<ContactBodies> all_bodies;
  View<uint32_t> colour, number, claims;

  MENISCUS_HD void operator()(uint32_t k) const {
    const FoundContact& c = found[contacts[k]];
    all_bodies[k] = {parts[c.a].body, parts[c.b].body};
    bodies[k] = {placed[c.a].moves ? parts[c.a].body : pbd::no_index,
                 placed[c.b].moves ? parts[c.b].body : pbd::no_index};
    colour[k] = no_colour;
    number[k] = k;
    claim(claims, bodies[k], k);
  }
};

/// One round of colouring. Of the contacts that have claimed a body, the one of the lowest rank has it. A
/// contact that has both of its bodies takes the lowest colour that neither has. All others claim their
/// bodies for the next round.
struct ColourRound {
  View<const TwoBodies> bodies;
  View<uint32_t> claims, next, after;  ///< by body, of three rounds; those of the last one are reset
  View<uint64_t> used;                 ///< by body: a bit for each colour
  View<uint32_t> colour;

  MENISCUS_HD uint32_t items() const { return pbd::max(bodies.count, after.count); }
  MENISCUS_HD ColourRound following() const { return {bodies, next, after, claims, used, colour}; }

  MENISCUS_HD void operator()(uint32_t k) const { leaves(k); }

  /// Whether contact k has no colour after the round.
  MENISCUS_HD bool leaves(uint32_t k) const {
    if (k < after.count) after[k] = ~0u;
    if (k >= bodies.count || colour[k] != no_colour) return false;
    const TwoBodies own = bodies[k];
    if (has(own.a, k) && has(own.b, k)) {
      take(own, k);
      return false;
    }
    claim(next, own, k);
    return true;
  }

  MENISCUS_HD bool has(uint32_t body, uint32_t k) const {
    return body == pbd::no_index || claims[body] == rank_of(k);
  }
  MENISCUS_HD void take(TwoBodies own, uint32_t k) const {
    const bool has_a = own.a != pbd::no_index, has_b = own.b != pbd::no_index;
    const uint64_t taken = (has_a ? used[own.a] : 0) | (has_b ? used[own.b] : 0);
    uint32_t free = 0;
    while (free < serial_colour && taken >> free & 1) ++free;
    colour[k] = free;
    if (free == serial_colour) return;
    if (has_a) used[own.a] |= uint64_t{1} << free;
    if (has_b) used[own.b] |= uint64_t{1} << free;
  }
};

/// The last rounds in one launch, until all contacts have a colour. What has none then is solved serially.
struct FinishColouring {
  static constexpr uint32_t group_threads = 1024;
  struct Scratch {};

  ColourRound first;
  uint32_t rounds;

  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch&, uint32_t) const {
    ColourRound now = first;
    for (uint32_t k = 0; k < rounds; ++k, now = now.following())
      if (!leaves_any(group, now)) return;
    group.for_each(now.bodies.count, [&](uint32_t k) {
      if (now.colour[k] == no_colour) now.colour[k] = serial_colour;
    });
  }

  template <class Group>
  MENISCUS_HD static bool leaves_any(const Group& group, const ColourRound& round) {
    if constexpr (Group::is_one_thread) {
      bool any = false;
      for (uint32_t k = 0; k < round.items(); ++k) any = round.leaves(k) || any;
      return any;
    } else {
      return group.any(round.items(), [&](uint32_t k) { return round.leaves(k); });
    }
  }
};

}  // namespace meniscus::collision::rigid_contact_kernels
