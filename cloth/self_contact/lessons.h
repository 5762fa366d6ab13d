// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What a step teaches the next one, in each world.
#pragma once

#include "cloth/self_contact/views.h"

namespace meniscus::cloth::self_contact_kernels {

/// Takes over what the last step has shown. A world without a search has not taken part in it.
struct Learn {
  View<const uint32_t> found;  // by world: see TransferPush
  View<uint8_t> lasts_one_substep, one_frame;

  MENISCUS_HD void operator()(uint32_t world) const {
    const View<const uint32_t> own = counters_of(found, world);
    if (own[listings] == 0) return;
    if (own[frames_meet] == 0 && own[cells_meet] == 0) one_frame[world] = 0;
    lasts_one_substep[world] = 2 * own[one_substep_listings] > own[listings];
  }
};

/// Where pieces in different frames have touched, the step is repeated in one frame.
struct UniteFrames {
  View<const uint32_t> found;
  View<uint8_t> one_frame;

  MENISCUS_HD void operator()(uint32_t world) const {
    if (counters_of(found, world)[frames_meet] > 0) one_frame[world] = 1;
  }
};

/// Worlds that were reset, or that did not take part in the last step, learn nothing from it.
struct ForgetFound {
  View<const uint32_t> chosen;  // by world; empty: all
  View<uint32_t> found;

  MENISCUS_HD void operator()(uint32_t k) const {
    if (chosen.count == 0 || chosen[k / counter_count]) found[k] = 0;
  }
};

}  // namespace meniscus::cloth::self_contact_kernels
