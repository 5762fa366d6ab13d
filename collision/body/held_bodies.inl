// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Functions of BodySet for bodies that other solids hold or load; their kernels are in held_kernels.h.
#pragma once

#include "collision/body/body_set.h"
#include "collision/body/held_kernels.h"

namespace meniscus::collision {

template <class D>
void BodySet<D>::start_held(pbd::Substep<D>& substep) {
  using namespace body_kernels;
  device_.parallel_for("bodies/cloth", bodies_ * lanes(),
                       CountCloth{grouped_.view(), proxies_.view(), substep.contacts.particle,
                                  on_cloth_.view(), lanes(), substep.particles.sorted});
  device_.parallel_for("bodies/hold", bodies_,
                       StartHeld{proxies_.view(), held_.view(), on_cloth_.view(), lanes()});
  solid_contacts_.start_bearing(substep.dt);
  free_held(substep, false);
}

template <class D>
void BodySet<D>::free_held(pbd::Substep<D>& substep, bool gives_back) {
  device_.parallel_for(
      "bodies/free", substep.contacts.contacts.count,
      body_kernels::FreeHeld{grouped_.view(), proxies_.view(), substep.contacts, gives_back});
}

/// Once contacts among solids have been visited, each body is where both particles and solids let it be.
template <class D>
void BodySet<D>::move_held(pbd::Substep<D>& substep, bool is_last) {
  using namespace body_kernels;
  const pbd::ParticleView& p = substep.particles;
  device_.parallel_for(
      "bodies/riding", bodies_ * lanes(),
      SumRiding{grouped_.view(), proxies_.view(), substep.contacts, p.position, riding_.view(), lanes()});
  device_.parallel_for("bodies/respond", bodies_,
                       RespondHeld{proxies_.view(), partial_.view(), riding_.view(), held_.view(), lanes()});
  solid_contacts_.bear(held_.view());
  device_.parallel_for(
      "bodies/ride", substep.contacts.contacts.count,
      Ride{proxies_.view(), held_.view(), p.position, p.accumulated_delta, substep.contacts});
  device_.parallel_for("bodies/held", bodies_,
                       NoteHeld{proxies_.view(), held_.view(), contact_motion_.next.view()});
  if (!is_last) return;
  free_held(substep, true);
  solid_contacts_.store_bearing(substep.dt);
}

}  // namespace meniscus::collision
