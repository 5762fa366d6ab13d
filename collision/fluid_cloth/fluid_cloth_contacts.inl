// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Functions of FluidClothContacts; its kernels are in find.h, parting.h, passing.h, wetting.h and
// ccd_failsafe.h.
#pragma once

#include <meniscus/error.h>

#include <algorithm>
#include <string>
#include <vector>

#include "collision/fluid_cloth/ccd_failsafe.h"
#include "collision/fluid_cloth/cloth_shapes.h"
#include "collision/fluid_cloth/find.h"
#include "collision/fluid_cloth/fluid_cloth_contacts.h"
#include "collision/fluid_cloth/marks.h"
#include "collision/fluid_cloth/parting.h"
#include "collision/fluid_cloth/passing.h"
#include "collision/fluid_cloth/tuning.h"
#include "collision/fluid_cloth/wetting.h"
#include "pbd/device/launch_size.h"
#include "pbd/repeated.h"
#include "pbd/surface_tree/surface_tree.inl"

namespace meniscus::collision {

namespace fluid_cloth_kernels {

/// Stores the largest count of any substep of a step.
struct NoteNear {
  View<const uint32_t> counter;
  View<uint32_t> found;

  MENISCUS_HD void operator()(uint32_t) const {
    if (found[near_cloth] < counter[0]) found[near_cloth] = counter[0];
  }
};

}  // namespace fluid_cloth_kernels

template <class D>
void FluidClothContacts<D>::count(const pbd::Substep<D>& substep, const pbd::ContactCounter& counter) {
  using namespace fluid_cloth_kernels;
  if (!any()) return;
  const pbd::ParticleView& p = substep.particles;
  tree_.refit(pbd::PathBoxes(p, 0));
  counter_.fill(0);
  entry_count_.fill(0);
  if (permeable_) {
    device_.parallel_for("fluid cloth/passed", p.sorted,
                         EndPassing{surface(substep), particles_.phase.current.view(), largest_radius_});
  }
  device_.parallel_for("fluid cloth/near", p.sorted,
                       ListNear{surface(substep), near(), particles_.phase.current.view(), support_radius_});
  device_.parallel_for("fluid cloth/found", 1, NoteNear{counter_.view(), found_.view()});
  pbd::parallel_for_teams<pbd::GroupTeam>(device_, "fluid cloth/shapes",
                                          static_cast<uint32_t>(shapes_.size()),
                                          FitShapes{surface(substep), shapes_.view()});
  pbd::parallel_for_teams<SearchTeam>(
      device_, "fluid cloth/touches", near_count(),
      FindTouches{surface(substep), near(), counter, entry_count_.view(), shapes_.view(), found_.view(),
                  support_radius_, fluid_cloth_tuning::largest_gap * largest_radius_});
  device_.exclusive_scan("fluid cloth/offsets", entry_count_.view(), entry_start_.view());
  pbd::parallel_for_teams<TouchTeam>(
      device_, "fluid cloth/entries", most_touches * near_count(),
      EnterTouches{near(), entry_start_.view(), entry_count_.view(), entries_.view()});
}

template <class D>
void FluidClothContacts<D>::fill(const pbd::Substep<D>& substep, const pbd::ContactWriter& writer) {
  using namespace fluid_cloth_kernels;
  if (!any()) return;
  pbd::parallel_for_teams<TouchTeam>(
      device_, "fluid cloth/contacts", near_count(),
      WriteContacts{surface(substep), near(), substep.particles.velocity, writer, substep.dt});
}

template <class D>
void FluidClothContacts<D>::part_neighbours(const pbd::Substep<D>& substep) {
  using namespace fluid_cloth_kernels;
  if (!any()) return;
  pbd::parallel_for_teams<SearchTeam>(
      device_, "fluid cloth/part", near_count(),
      PartNeighbours{surface(substep), near(), substep.neighbours, support_radius_});
}

template <class D>
void FluidClothContacts<D>::clamp_at_impact(const pbd::Substep<D>& substep) {
  using namespace fluid_cloth_kernels;
  const pbd::ParticleView& p = substep.particles;
  tree_.refit(pbd::PathBoxes(p, 2 * fluid_cloth_tuning::clamp_gap_of_radius * largest_radius_));
  device_.parallel_for("fluid cloth/clamp at impact", p.sorted,
                       ClampAtImpact{surface(substep), p.position, found_.view()});
}

template <class D>
std::vector<WettingTouch> FluidClothContacts<D>::read_wetting(pbd::View<const pbd::Contact> contacts) {
  using namespace fluid_cloth_kernels;
  const uint32_t most = most_near();
  if (!absorbent_ || most == 0) return {};
  if (most > wetting_.size()) wetting_.resize_or_stay(most + most / 4);
  wetting_count_.fill(0);
  device_.parallel_for("fluid cloth/wetting", near_count(),
                       ListWetting{near(), contacts, pieces_.view(), particles_.position.current.view(),
                                   particles_.slot.current.view(), wetting_.view(), wetting_count_.view()});
  uint32_t count = 0;
  wetting_count_.read(std::span(&count, 1));
  std::vector<WettingTouch> found = wetting_.read(count);
  std::sort(found.begin(), found.end(),
            [](const WettingTouch& a, const WettingTouch& b) { return a.slot < b.slot; });
  return found;
}

template <class D>
fluid_cloth_kernels::Surface FluidClothContacts<D>::surface(const pbd::Substep<D>& substep) {
  const pbd::ParticleView& p = substep.particles;
  return {tree_.view(),  p.previous, p.position, p.sorted,          pieces_.view(),
          marks_.view(), filters_,   p.phase,    p.sorted / worlds_};
}

template <class D>
fluid_cloth_kernels::NearList FluidClothContacts<D>::near() {
  return {near_.view(), touches_.view(), counter_.view()};
}

template <class D>
uint32_t FluidClothContacts<D>::near_count() {
  return pbd::launch_size<D>(counter_.view()[0], near_.size(), near_.size());
}

template <class D>
void FluidClothContacts<D>::start_step() {
  std::fill(found_.host().begin(), found_.host().end(), 0u);
}

template <class D>
void FluidClothContacts<D>::make_room() {
  using namespace fluid_cloth_kernels;
  // The entries of vertices are counted with 32 bits.
  constexpr uint32_t most = ~0u / (FluidClothContact::most_vertices * most_touches);
  const uint32_t wanted = most_near();
  if (wanted > most) {
    throw Error(ErrorCode::capacity, "at most " + std::to_string(most) + " particles may be near cloth; " +
                                         std::to_string(wanted) +
                                         " are. A wider particle_spacing needs fewer");
  }
  reserve_near(std::min(wanted + wanted / 4, most));
}

template <class D>
void FluidClothContacts<D>::reserve_near(uint32_t capacity) {
  using namespace fluid_cloth_kernels;
  near_.resize_discard(0);
  touches_.resize_discard(most_touches * size_t{capacity});
  entries_.resize_discard(FluidClothContact::most_vertices * most_touches * size_t{capacity});
  near_.resize_discard(capacity);  // last: its length is the capacity
}

template <class D>
void FluidClothContacts<D>::set_surface(std::span<const pbd::SurfaceTriangle> triangles,
                                        std::span<const Vec3> positions,
                                        std::span<const FluidClothPiece> pieces, uint32_t worlds) {
  device_.wait();
  const auto vertices = static_cast<uint32_t>(positions.size()), all = static_cast<uint32_t>(pieces.size());
  tree_.set_surface(triangles, positions, {worlds, vertices, all});
  worlds_ = worlds;
  vertices_ = triangles.empty() ? 0 : worlds * vertices;
  pbd::write_repeated(pieces_, pieces, worlds);
  largest_radius_ = 0;
  permeable_ = absorbent_ = false;
  for (const FluidClothPiece& piece : pieces) {
    largest_radius_ = std::max(largest_radius_, piece.radius);
    permeable_ |= piece.flow > 0;
    absorbent_ |= piece.absorbs != 0;
  }
  const std::vector<uint32_t> marks = triangle_marks(tree_.triangles());
  pbd::write_repeated(marks_, std::span<const uint32_t>(marks), worlds);
  shapes_.resize_discard(marks_.size() / pbd::BoxGroup::size);
  counter_.resize_discard(1);
  wetting_count_.resize_discard(1);
  found_.resize_discard(fluid_cloth_kernels::found_count);
  start_step();
  entry_count_.resize_discard(vertices_);
  entry_start_.resize_discard(vertices_ + 1);
  if (near_.size() == 0 && !triangles.empty()) reserve_near(4096);
}

}  // namespace meniscus::collision
