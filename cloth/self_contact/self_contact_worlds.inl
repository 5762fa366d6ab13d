// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// SelfContacts in a batch: what worlds are reset to, and what is saved.
#pragma once

#include "cloth/self_contact/lessons.h"
#include "cloth/self_contact/self_contacts.h"
#include "pbd/worlds.h"

namespace meniscus::cloth {

/// The items of so many worlds.
template <class D>
void SelfContacts<D>::visit(pbd::StateVisitor& v, uint32_t first_world, uint32_t worlds) {
  const auto array = [&]<class T>(const char* name, pbd::Buffer<T>& all, uint32_t each) {
    const pbd::View<T> own = all.view().from(all.size() > 0 ? first_world * each : 0);
    v.array(name, own, all.size() > 0 ? worlds * each : 0);
  };
  v.value("rounds", rounds_);
  array("lasts_one_substep", lasts_one_substep_, 1);
  array("one_frame", one_frame_, 1);
  v.values("found", found_.host());
  array("strayed", strayed_, of_world_.vertices);
}

/// Called while there is one world.
template <class D>
void SelfContacts<D>::keep_world(uint32_t) {
  learn();
  const auto keep = [&]<class T>(pbd::Buffer<T>& kept, const pbd::Buffer<T>& from) {
    kept.resize_discard(from.size());
    if (from.size() > 0) device_.copy(kept.view().data, from.view().data, from.size() * sizeof(T));
  };
  keep(kept_strayed_, strayed_);
  keep(kept_lasts_one_substep_, lasts_one_substep_);
  keep(kept_one_frame_, one_frame_);
}

template <class D>
void SelfContacts<D>::reset_worlds(const pbd::ChosenWorlds& worlds) {
  if (idle()) return;
  const auto write = [&]<class T>(const char* name, const pbd::Buffer<T>& kept, pbd::Buffer<T>& to) {
    const auto count = static_cast<uint32_t>(to.size());
    pbd::write_worlds(device_, name, {worlds.chosen, count / worlds_, count}, pbd::View<const T>(kept.view()),
                      to.view(), pbd::WorldsFrom::one);
  };
  learn();
  write("self contacts/reset strayed", kept_strayed_, strayed_);
  write("self contacts/reset flags", kept_lasts_one_substep_, lasts_one_substep_);
  write("self contacts/reset flags", kept_one_frame_, one_frame_);
}

template <class D>
void SelfContacts<D>::undo_worlds(const pbd::ChosenWorlds& worlds) {
  using namespace self_contact_kernels;
  if (idle()) return;
  pbd::write_worlds(device_, "self contacts/undo strayed", {worlds.chosen, of_world_.vertices, vertices_},
                    pbd::View<const float>(saved_strayed_.view()), strayed_.view(), pbd::WorldsFrom::all);
  device_.parallel_for("self contacts/forget", static_cast<uint32_t>(found_by_world_.size()),
                       ForgetFound{worlds.chosen, found_by_world_.view()});
}

}  // namespace meniscus::cloth
