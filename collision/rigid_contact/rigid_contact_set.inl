// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Functions of RigidContactSet: a step. What it keeps is in rigid_contact_memory.inl.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>

#include "collision/rigid_contact/ground_kernels.h"
#include "collision/rigid_contact/rigid_contact_memory.inl"
#include "collision/rigid_contact/rigid_contact_set.h"

namespace meniscus::collision {

template <class D>
void RigidContactSet<D>::find(std::span<const ContactBody> bodies, float dt) {
  load(bodies);
  place_parts(dt);
  find_pairs();
  find_contacts();
  colour();
  sort_by_colour();
}

template <class D>
void RigidContactSet<D>::advance(std::span<const ContactBody> bodies, const ContactStep& step,
                                 std::span<ContactMotion> out) {
  load(bodies);
  device_.parallel_for(
      "solids/start", bodies_count_,
      rigid_contact_kernels::StartBodies{start_.view(), bodies_.view(), turn_.view(), step.dt});
  step_ = step.dt;
  small_step_ = step.dt / static_cast<float>(step.small_steps);
  prepare(small_step_);
  solve(step);
  device_.parallel_for("solids/store", bodies_count_,
                       rigid_contact_kernels::StoreMotions{start_.view(), bodies_.view().first(bodies_count_),
                                                           turn_.view(), used_.view(), motion_.view()});
  device_.wait();
  std::ranges::copy(motion_.host(), out.begin());
}

template <class D>
void RigidContactSet<D>::load(std::span<const ContactBody> bodies) {
  bodies_count_ = static_cast<uint32_t>(bodies.size());
  device_.wait();
  start_.resize_discard(bodies_count_);
  motion_.resize_discard(bodies_count_);
  std::ranges::copy(bodies, start_.host().begin());
  bodies_.resize_discard(bodies_count_);
  turn_.resize_discard(bodies_count_);
}

template <class D>
void RigidContactSet<D>::place_parts(float dt) {
  using namespace rigid_contact_kernels;
  const uint32_t count = part_count();
  device_.parallel_for("solids/place", count,
                       PlaceParts{parts_.view(), start_.view(), is_large_.view(), placed_.view(),
                                  bucket_.view(), number_.view(), grid_, dt});
  device_.sort_pairs("solids/cells", bucket_.view(), sorted_bucket_.view(), number_.view(), sorted_.view(),
                     grid_.bits + 1);
  device_.parallel_for("solids/buckets", count + 1,
                       FindBuckets{sorted_bucket_.view(), bucket_starts_.view()});
}

template <class D>
rigid_contact_kernels::PairSearch RigidContactSet<D>::search() const {
  return {parts_.view(),  placed_.view(), is_large_.view(), large_.view(), bucket_starts_.view(),
          sorted_.view(), grid_};
}

template <class D>
void RigidContactSet<D>::find_pairs() {
  using namespace rigid_contact_kernels;
  const uint32_t count = part_count();
  device_.parallel_for("solids/count pairs", count, CountPairs{search(), partners_.view()});
  device_.exclusive_scan("solids/pair starts", partners_.view(), pair_starts_.view());
  pair_starts_.read(std::span(&pair_count_, 1), count);
  make_room(pairs_, pair_count_);
  make_room(found_, pair_count_);
  make_room(touches_, pair_count_);
  make_room(place_, pair_count_ + 1);
  device_.parallel_for("solids/list pairs", count, ListPairs{search(), pair_starts_.view(), pairs_.view()});
}

template <class D>
void RigidContactSet<D>::find_contacts() {
  using namespace rigid_contact_kernels;
  contact_count_ = 0;
  if (pair_count_ == 0) {
    contact_start_.fill(0);
    return;
  }
  const PairContacts contacts{search(),      pairs_.view(),  memory_.contacts.view(), memory_.starts.view(),
                              found_.view(), touches_.view()};
  device_.parallel_for("solids/touch", pair_count_, TouchPairs{contacts});
  if (hulls_.any())
    device_.parallel_for("solids/touch hulls", pair_count_, TouchHullPairs{contacts, hulls_.table()});
  if (grounds_.any())
    device_.parallel_for("solids/touch grounds", pair_count_,
                         TouchGroundPairs{contacts, hulls_.table(), grounds_.table()});
  device_.exclusive_scan("solids/contact places", touches_.view().first(pair_count_),
                         place_.view().first(pair_count_ + 1));
  place_.read(std::span(&contact_count_, 1), pair_count_);
  make_room(contacts_, contact_count_);
  device_.parallel_for("solids/list contacts", pair_count_,
                       ListContacts{touches_.view(), place_.view(), contacts_.view()});
  device_.parallel_for("solids/contact starts", part_count() + 1,
                       FindContactStarts{pair_starts_.view(), place_.view(), contact_start_.view()});
}

template <class D>
void RigidContactSet<D>::colour() {
  using namespace rigid_contact_kernels;
  const uint32_t count = contact_count_;
  for (auto* buffer : {&colour_, &sorted_colour_, &contact_number_, &order_}) make_room(*buffer, count);
  make_room(two_bodies_, count);
  make_room(contact_bodies_, count);
  used_.resize_discard(bodies_count_);
  claims_.resize_discard(3 * size_t{bodies_count_});
  used_.fill(0);
  if (count == 0) return;
  claims_.fill(0xff);
  const auto claims = [this](uint32_t round) {
    return claims_.view().from(round * bodies_count_).first(bodies_count_);
  };
  ColourRound round{two_bodies_.view().first(count), claims(0), claims(1), claims(2), used_.view(),
                    colour_.view().first(count)};
  device_.parallel_for("solids/uncoloured", count,
                       StartColouring{contacts_.view(), found_.view(), parts_.view(), placed_.view(),
                                      two_bodies_.view().first(count), contact_bodies_.view().first(count),
                                      round.colour, contact_number_.view().first(count), round.claims});
  // One block of a GPU goes over few contacts and bodies faster than launches begin.
  const uint32_t launched =
      round.items() > 4 * FinishColouring::group_threads ? rigid_contact_tuning::launched_rounds : 0;
  for (uint32_t k = 0; k < launched; ++k, round = round.following())
    device_.parallel_for("solids/colour", round.items(), round);
  device_.parallel_for_groups("solids/finish colours", 1,
                              FinishColouring{round, rigid_contact_tuning::colour_rounds - launched});
}

template <class D>
void RigidContactSet<D>::sort_by_colour() {
  using namespace rigid_contact_kernels;
  const uint32_t count = contact_count_;
  colour_starts_.assign(colour_count + 1, 0);
  if (count == 0) return;
  device_.sort_pairs("solids/by colour", colour_.view().first(count), sorted_colour_.view().first(count),
                     contact_number_.view().first(count), order_.view().first(count),
                     static_cast<uint32_t>(std::bit_width(colour_count)));
  device_.parallel_for("solids/colours", count + 1,
                       FindBuckets{sorted_colour_.view().first(count), starts_.view()});
  make_room(solver_, count);
  starts_.read(std::span(colour_starts_));
}

template <class D>
void RigidContactSet<D>::prepare(float h) {
  const uint32_t count = contact_count_;
  device_.parallel_for(
      "solids/prepare", count,
      rigid_contact_kernels::Prepare{order_.view().first(count), contacts_.view(), found_.view(),
                                     parts_.view(), start_.view(), bodies_.view(), solver_.view(), h});
}

template <class D>
template <class Solve>
void RigidContactSet<D>::solve_once(const char* name, const Solve& solve) {
  using namespace rigid_contact_kernels;
  visit_colours(name, OfColour<Solve>{solver_.view(), bodies_.view(), 0, solve});
}

/// Runs `visit`, whose first contact is to be set, for all colours. Colours of few contacts that follow one
/// another are one launch.
template <class D>
template <class Visit>
void RigidContactSet<D>::visit_colours(const char* name, Visit visit) {
  using namespace rigid_contact_kernels;
  using Few = ColoursInOneGroup<Visit>;
  const uint32_t few =
      device_.kind() == pbd::DeviceKind::cpu ? InGroups<Visit>::group_threads : Few::group_threads;
  const auto size = [this](uint32_t colour) { return colour_starts_[colour + 1] - colour_starts_[colour]; };
  const auto has_few = [&](uint32_t colour) { return colour == serial_colour || size(colour) <= few; };
  for (uint32_t colour = 0, end; colour < colour_count; colour = end) {
    visit.first = colour_starts_[colour];
    for (end = colour; end < colour_count && has_few(end);) ++end;
    if (end > colour) {
      if (colour_starts_[end] > colour_starts_[colour])
        device_.parallel_for_groups(name, 1, Few{visit, starts_.view(), colour, end});
      continue;
    }
    end = colour + 1;
    device_.parallel_for_groups(name, InGroups<Visit>::groups(size(colour)),
                                InGroups<Visit>{visit, size(colour)});
  }
}

template <class D>
void RigidContactSet<D>::solve(const ContactStep& step) {
  using namespace rigid_contact_kernels;
  const float h = step.dt / static_cast<float>(step.small_steps);
  const SmallStep small{h, softness(1).removal / h};
  solve_once("solids/warm start", WarmStart{});
  for (int i = 0; i < step.small_steps; ++i) {
    device_.parallel_for("solids/accelerate", bodies_count_, Accelerate{start_.view(), bodies_.view(), h});
    // Forces may differ much from those of the last step, and a light body would be thrown before it moves.
    if (i == 0) solve_once("solids/agree", SolveContact{small, false, false});
    solve_once("solids/solve", SolveContact{small, true, false});
    device_.parallel_for("solids/move", bodies_count_, Move{bodies_.view(), turn_.view(), h});
    solve_once("solids/relax", SolveContact{small, false, true});
  }
  if (any_bounces_) solve_once("solids/bounce", Bounce{step.least_bounce});
}

template <class D>
void RigidContactSet<D>::start_bearing(float dt) {
  make_room(bearing_, contact_count_);
  device_.parallel_for("solids/start bearing", contact_count_,
                       rigid_contact_kernels::StartBearing{solver_.view(), bodies_.view(), bearing_.view(),
                                                           dt, step_, small_step_});
}

template <class D>
void RigidContactSet<D>::bear(pbd::View<HeldBody> bodies) {
  if (contact_count_ > 0)
    visit_colours("solids/bear", rigid_contact_kernels::Bear{bearing_.view(), bodies, 0});
}

template <class D>
void RigidContactSet<D>::store_bearing(float dt) {
  device_.parallel_for("solids/store bearing", contact_count_,
                       rigid_contact_kernels::StoreBearing{bearing_.view(), order_.view(), contacts_.view(),
                                                           found_.view(), dt});
}

template <class D>
void RigidContactSet<D>::accept() {
  memory_.make_room(contact_count_);
  memory_.count = contact_count_;
  device_.parallel_for(
      "solids/keep", contact_count_,
      rigid_contact_kernels::KeepMemory{solver_.view(), start_.view(), memory_.contacts.view(),
                                        memory_.touching.view(), small_step_});
  memory_.starts.swap(contact_start_);
}

}  // namespace meniscus::collision
