// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A solve of the pressure grid, from the particles' excess volume to their motion.
#pragma once

#include <cmath>

#include "fluid/pressure_grid/multigrid.inl"
#include "fluid/pressure_grid/pressure_grid.h"
#include "fluid/pressure_grid/tuning.h"

namespace meniscus::fluid {

template <class D>
void PressureGrid<D>::reserve(uint32_t size) {
  found_.resize_discard(size);
  found_.fill(0);  // a substep without room for all contacts leaves some unwritten, and is done again
  scale_.resize_discard(size);
  multiplier_.resize_discard(size);
}

template <class D>
void PressureGrid<D>::displace(pbd::Substep<D>& substep, float compressibility,
                               pbd::View<const density_kernels::Multiplier> last,
                               pbd::View<const float> allowed) {
  if (!fit(substep)) return;
  if (shared_.are_shared()) pbd::refresh_ghost_positions(device_, substep.ghosts, substep.particles.position);
  find_excess(substep, last, allowed);
  classify(substep);
  gather(substep, compressibility);
  components_.level(space_.nodes, flags_.view(), multigrid_.finest(), filled_.view(),
                    kernel_.particle_volume);
  multigrid_.solve(grid_tuning::iterations);
  move(substep);
}

/// The table grows with the extent of the fluid, like that of the cells: by doubling, so rarely. Returns
/// whether there is fluid, on any rank.
template <class D>
bool PressureGrid<D>::fit(const pbd::Substep<D>& substep) {
  constexpr uint32_t bits_of_slices = 2;
  const pbd::GridView& cells = substep.grid;
  NodeTable nodes{{cells.bits_x - bits_of_slices, cells.bits_y, cells.bits_z}, cells.whole_strip_bits};
  nodes.bits[cells.layers_along_y ? 1 : 2] = cells.whole_layer_bits;
  if (!shared_.start(substep.ghosts.exchange, cells, nodes)) return false;
  space_ = {cells, nodes, shared_.occupied()};
  multigrid_.fit(nodes);
  reserve_nodes(nodes.count());
  if (shared_.are_shared()) clear_nodes();
  return true;
}

template <class D>
void PressureGrid<D>::reserve_nodes(uint32_t count) {
  if (flags_.size() >= count) return;
  flags_.resize_discard(0);
  inside_.resize_discard(count);
  filled_.resize_discard(count);
  give_.resize_discard(count);
  faces_.resize_discard(count);
  load_.resize_discard(count);
  motion_.resize_discard(count);
  components_.reserve(count);
  lost_.resize_discard(1);
  flags_.resize_discard(count);  // last: its length is the one that is tested
}

/// Ranks find nothing of nodes in layers without particles.
template <class D>
void PressureGrid<D>::clear_nodes() {
  device_.parallel_for("grid/clear", space_.nodes.count(),
                       grid_kernels::ClearNodes{flags_.view(), filled_.view(), multigrid_.finest().right,
                                                give_.view(), faces_.view(), load_.view()});
}

template <class D>
void PressureGrid<D>::find_excess(pbd::Substep<D>& substep, pbd::View<const density_kernels::Multiplier> last,
                                  pbd::View<const float> allowed) {
  using namespace grid_kernels;
  const ExcessOf excess_of{last, std::fmax(0.0f, 1 - grid_tuning::recovery * substep.dt), allowed};
  const pbd::ParticleView& p = substep.particles;
  const ContactView contacts = substep.contacts.of_first(p.sorted);
  with_shape(kernel_, [&]<class K>(const K& kernel) {
    device_.parallel_for_both("grid/excess", p.sorted,
                              Excess<K>{kernel, space_, substep.neighbours, contacts.start, p.position,
                                        p.phase, excess_of, found_.view()},
                              contacts.contacts.count,
                              ExcessAtWalls<K>{kernel, space_, substep.neighbours, contacts, p.position,
                                               p.phase, excess_of, found_.view()});
  });
}

/// Finds the classes of nodes, and the weights of particles on them.
template <class D>
void PressureGrid<D>::classify(pbd::Substep<D>& substep) {
  using namespace grid_kernels;
  const pbd::ParticleView& p = substep.particles;
  const ContactView contacts = substep.contacts.of_first(p.sorted);
  if (shared_.are_shared()) pbd::refresh_ghosts(device_, substep.ghosts, found_.view());
  const NodeSources sources{space_, found_.view(), p.position, contacts, kernel_.particle_volume};
  const auto below = shared_.template from_below<Walls>(
      "grid/walls above", [&](const NodeLayers& layers, View<Walls> walls) {
        return WallsAbove{layers, GatherNodes<false>{sources, flags_.view(), filled_.view()}, walls};
      });
  contacts.any_moving
      ? shared_.for_each("grid/nodes", GatherNodes<true>{sources, flags_.view(), filled_.view(), below})
      : shared_.for_each("grid/nodes", GatherNodes<false>{sources, flags_.view(), filled_.view(), below});
  shared_.share({words_of(flags_.view()), words_of(filled_.view())});
  device_.parallel_for("grid/inside", space_.nodes.count(),
                       MarkInside{space_.nodes, flags_.view(), inside_.view()});
  device_.parallel_for(
      "grid/normalize", p.sorted,
      Normalize{space_, map(), inside_.view(), p.position, substep.neighbours, scale_.view(), found_.view()});
  if (!shared_.are_shared()) return;
  pbd::refresh_ghosts(device_, substep.ghosts, found_.view());
  pbd::refresh_ghosts(device_, substep.ghosts, scale_.view());
}

/// Forms the equation.
template <class D>
void PressureGrid<D>::gather(pbd::Substep<D>& substep, float compressibility) {
  using namespace grid_kernels;
  const pbd::ParticleView& p = substep.particles;
  const ContactView contacts = substep.contacts.of_first(p.sorted);
  const multigrid_kernels::Level finest = multigrid_.finest();
  shared_.for_each("grid/sums",
                   GatherExcess{space_, flags_.view(), found_.view(), kernel_.particle_volume,
                                -grid_tuning::most_lacking * space_.width() * width2(), finest.right});
  shared_.for_each(
      "grid/faces",
      GatherFaces{space_, map(), found_.view(), scale_.view(), kernel_.particle_volume, faces_.view()}, 3);
  shared_.share({words_of(finest.right), words_of(faces_.view())});
  WeighContacts weigh{space_,        {space_.nodes, flags_.view(), faces_.view(), width2()},
                      found_.view(), p.position,
                      contacts,      load_.view(),
                      give_.view()};
  weigh.below = shared_.template from_below<ContactSums>(
      "grid/contacts above", [&](const NodeLayers& layers, View<ContactSums> sums) {
        return WeighContactsAbove{layers, weigh, sums};
      });
  shared_.for_each("grid/contacts", weigh);
  shared_.share({words_of(load_.view()), words_of(give_.view())});
  const float width = space_.width(), compliance = compressibility / (substep.dt * substep.dt);
  device_.parallel_for("grid/equation", space_.nodes.count(),
                       MakeEquation{space_.nodes, flags_.view(), faces_.view(), filled_.view(), width2(),
                                    compliance * width * width2(), give_.view(), finest.coefficients});
}

template <class D>
void PressureGrid<D>::move(pbd::Substep<D>& substep) {
  using namespace grid_kernels;
  const pbd::ParticleView& p = substep.particles;
  const ContactView contacts = substep.contacts.of_first(p.sorted);
  const View<const float> pressure = multigrid_.solution();
  const FaceMoves moves{
      space_.nodes, faces_.view(),         pressure,
      width2(),     grid_tuning::fraction, grid_tuning::farthest * std::cbrt(kernel_.particle_volume)};
  const PressureOf from_least = components_.pressure(space_.nodes, pressure);
  const uint32_t nodes = space_.nodes.count();
  device_.reduce("grid/lost", nodes, Lost{}, FindLost{moves, flags_.view(), from_least}, AddLost{},
                 lost_.view());
  device_.parallel_for("grid/move faces", nodes, MoveFaces{moves, lost_.view(), motion_.view()});
  device_.parallel_for("grid/push solids", contacts.contacts.count,
                       PushSolids{space_, found_.view(), p.position, contacts, load_.view(), from_least,
                                  grid_tuning::fraction});
  device_.parallel_for(
      "grid/move particles", p.sorted,
      MoveParticles{space_, found_.view(), substep.neighbours, scale_.view(), motion_.view(), flags_.view(),
                    from_least, grid_tuning::fraction * kernel_.particle_volume, p.position,
                    p.accumulated_delta, multiplier_.view()});
}

}  // namespace meniscus::fluid
