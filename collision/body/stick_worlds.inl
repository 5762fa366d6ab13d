// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// StickAnchors in a batch: what worlds are reset to, and one world alone.
#pragma once

#include <vector>

#include "collision/body/stick_anchors.h"
#include "pbd/worlds.h"

namespace meniscus::collision {

namespace stick_kernels {

/// Numbers the body of an anchor in another world of a batch, `by` bodies further.
MENISCUS_HD inline StickAnchor shifted(StickAnchor anchor, uint32_t by) {
  if (anchor.body < pbd::on_cloth) anchor.body += by;
  return anchor;
}

/// The lists that vertices are to have: those of `by` in the chosen worlds, the present ones in others.
struct ChooseLists {
  pbd::ChosenWorlds worlds;
  StickLists present, by;  ///< `by`: of one world, or of all
  uint32_t bodies;         ///< of a world

  struct List {
    const StickLists* of;
    uint32_t first, count;
    uint32_t shift;  ///< of the numbers of bodies
  };
  MENISCUS_HD List of(uint32_t v) const {
    const StickLists& lists = worlds.has(v) ? by : present;
    const bool are_of_one = lists.start.count <= worlds.count;
    const uint32_t at = are_of_one ? v % worlds.each : v;
    const uint32_t first = lists.start[at], end = lists.start[at + 1];
    const uint32_t last = end < lists.anchors.count ? end : lists.anchors.count;
    return {&lists, first, last > first ? last - first : 0, are_of_one ? v / worlds.each * bodies : 0};
  }
};

struct MeasureLists {
  ChooseLists choose;
  View<uint32_t> lengths;

  MENISCUS_HD void operator()(uint32_t v) const { lengths[v] = choose.of(v).count; }
};

struct WriteLists {
  ChooseLists choose;
  View<const uint32_t> start;
  View<StickAnchor> anchors;

  MENISCUS_HD void operator()(uint32_t v) const {
    const ChooseLists::List list = choose.of(v);
    for (uint32_t k = 0; k < list.count && start[v] + k < anchors.count; ++k)
      anchors[start[v] + k] = shifted(list.of->anchors[list.first + k], list.shift);
  }
};

/// Copies the anchors of a world, with the numbers that bodies have in a world alone.
struct TakeOut {
  View<const StickAnchor> from;
  View<StickAnchor> to;
  uint32_t first, bodies;  ///< bodies: of the worlds before

  MENISCUS_HD void operator()(uint32_t k) const { to[k] = shifted(from[first + k], 0u - bodies); }
};

}  // namespace stick_kernels

/// Called while there is one world.
template <class D>
void StickAnchors<D>::keep_world(uint32_t) {
  in_batch_ = true;
  kept_vertices_ = vertices_;
  if (vertices_ == 0) return;
  device_.copy_out(&kept_count_, start_.current().data + vertices_, sizeof kept_count_);
  kept_count_ = std::min(kept_count_, anchors_.current().count);
  kept_anchors_.resize_discard(kept_count_);
  kept_start_.resize_discard(vertices_ + 1);
  device_.copy(kept_anchors_.view().data, anchors_.current().data, kept_count_ * sizeof(StickAnchor));
  device_.copy(kept_start_.view().data, start_.current().data, (vertices_ + 1) * sizeof(uint32_t));
}

/// Replaces the lists of the chosen worlds. There is room for twice the contacts of a step and for the kept
/// lists of all worlds: the present lists and those to go back to are of one step each.
template <class D>
void StickAnchors<D>::replace(const pbd::ChosenWorlds& chosen, const StickLists& by) {
  if (vertices_ == 0) return;
  const uint32_t least = vertices_ / kept_vertices_ * kept_count_;
  if (anchors_.current().count < least) anchors_.reserve(least, 0);
  const stick_kernels::ChooseLists choose{
      {chosen.chosen, kept_vertices_, vertices_}, present(), by, bodies_.worlds().each()};
  device_.parallel_for("anchors/measure", vertices_, stick_kernels::MeasureLists{choose, lengths_.view()});
  device_.exclusive_scan("anchors/starts", lengths_.view(), start_.next());
  device_.parallel_for("anchors/replace", vertices_,
                       stick_kernels::WriteLists{choose, start_.next(), anchors_.next()});
  anchors_.flip();
  start_.flip();
}

template <class D>
void StickAnchors<D>::reset_worlds(const pbd::ChosenWorlds& worlds) {
  replace(worlds, {kept_anchors_.view(), kept_start_.view()});
}

template <class D>
void StickAnchors<D>::undo_worlds(const pbd::ChosenWorlds& worlds) {
  replace(worlds, {anchors_.saved(), start_.saved()});
}

template <class D>
void StickAnchors<D>::visit_world(pbd::StateVisitor& v, uint32_t world) {
  const uint32_t each = kept_vertices_, first = world * each;
  if (each == 0) return;
  std::vector<uint32_t> start(each + 1);
  device_.copy_out(start.data(), start_.current().data + first, start.size() * sizeof(uint32_t));
  const uint32_t begin = start[0];
  for (uint32_t& s : start) s -= begin;
  uint32_t count = start.back();
  pbd::Buffer<uint32_t> starts(device_, "stick anchor offsets");
  starts.resize_discard(start.size());
  starts.write(start);
  v.value("count", count);
  pbd::Buffer<StickAnchor> anchors(device_, "stick anchors");
  anchors.resize_discard(count);
  if (!v.restores())
    device_.parallel_for(
        "anchors/take out", count,
        stick_kernels::TakeOut{anchors_.current(), anchors.view(), begin, world * bodies_.worlds().each()});
  v.array("anchor", anchors.view(), count);
  v.array("start", starts.view(), start.size());
  if (!v.restores()) return;
  std::vector<uint32_t> chosen(vertices_ / each, 0);
  chosen[world] = 1;
  pbd::Buffer<uint32_t> this_one(device_, "chosen worlds");
  this_one.resize_discard(chosen.size());
  this_one.write(chosen);
  anchors_.reserve(anchors_.current().count + count, anchors_.current().count);
  replace({this_one.view(), each, vertices_}, {anchors.view(), starts.view()});
}

}  // namespace meniscus::collision
