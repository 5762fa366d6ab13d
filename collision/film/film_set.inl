// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Functions of FilmSet; its kernels are in film_kernels.h and film_solve.h.
#pragma once

#include "collision/film/film_set.h"
#include "collision/film/over_ranks.inl"

namespace meniscus::collision {

template <class D>
void FilmSet<D>::set_parts(std::span<const FilmPart> parts, uint32_t bodies, std::span<const Shape> shapes,
                           uint32_t fixed, uint32_t worlds) {
  all_ = join_film_parts(parts, bodies);
  nearness_.set(shapes, fixed, all_, worlds);
  worlds_ = worlds;
  is_on_device_ = false;
  bodies_.set_loads({});
}

template <class D>
void FilmSet<D>::set_probes(std::span<const film_kernels::LoadProbe> probes) {
  probes_.resize_discard(probes.size());
  probes_.write(probes);
  probe_sums_.resize_discard(probes.size());
  probe_sums_.fill(0);
  probe_reads_.resize(probes.size());
  probe_loads_.resize(probes.size());
}

template <class D>
void FilmSet<D>::set_gravities(std::span<const pbd::Vec4> gravities) {
  std::vector<film_kernels::LevelAxes> axes;
  for (const pbd::Vec4& g : gravities) axes.emplace_back(g.xyz());
  gravities_.resize_discard(gravities.size());
  gravities_.write(gravities);
  world_axes_.resize_discard(axes.size());
  world_axes_.write(axes);
}

template <class D>
film_kernels::WorldGravity FilmSet<D>::gravity(const pbd::Substep<D>& substep) const {
  return {substep.gravity, of_world(), gravities_.view()};
}

template <class D>
std::span<const RigidImpulse> FilmSet<D>::read_probes() {
  probe_sums_.read(std::span(probe_reads_));
  const float scale = step_time_ > 0 ? 1 / step_time_ : 0;
  for (size_t k = 0; k < probe_reads_.size(); ++k) {
    const film_kernels::WholeImpulse& s = probe_reads_[k];
    probe_loads_[k] = {scale * Vec3{s.at(0), s.at(1), s.at(2)}, scale * Vec3{s.at(3), s.at(4), s.at(5)}};
  }
  return probe_loads_;
}

/// Without fluid the surfaces take no memory on the device.
template <class D>
void FilmSet<D>::upload() {
  const auto write = [&]<class T>(pbd::Buffer<T>& buffer, const std::vector<T>& values) {
    buffer.resize_discard(values.size());
    buffer.write(values);
  };
  write(vertices_, all_.vertices);
  write(triangles_, all_.triangles);
  write(first_corner_, all_.first_corner);
  write(corners_, all_.corners);
  write(ranges_, all_.bodies);
  centre_.resize_discard(all_.triangles.size());
  gaps_.resize_discard(all_.triangles.size());
  rims_.resize_discard(all_.vertices.size());
  for (auto* buffer : {&pressure_, &wet_part_, &residual_, &direction_, &applied_, &diagonal_})
    buffer->resize_discard(all_.vertices.size());
  has_film_.resize_discard(all_.bodies.size());
  balance_.resize_discard(all_.bodies.size());
  particle_loads_.resize_discard(all_.bodies.size());
  passed_on_.resize_discard(all_.bodies.size());
  sums_.resize_discard(all_.bodies.size());
  impulses_.resize_discard(all_.bodies.size());
  candidates_.reserve(static_cast<uint32_t>(all_.triangles.size()), contacts_.shapes().of_world());
  is_on_device_ = true;
}

template <class D>
void FilmSet<D>::start_step() {
  if (!is_on_device_ && has_fluid_ && !all_.triangles.empty()) upload();
  step_time_ = 0;
  probe_sums_.fill(0);
}

template <class D>
film_kernels::Surfaces FilmSet<D>::surfaces() const {
  return {vertices_.view(), triangles_.view(), first_corner_.view(),
          corners_.view(),  ranges_.view(),    bodies_.proxies()};
}

template <class D>
film_kernels::Fluid FilmSet<D>::fluid(const pbd::Substep<D>& substep) const {
  const FluidMultipliers m = multipliers_(substep);
  return {substep.grid,
          substep.particles.position,
          substep.particles.phase,
          contacts_.filters(),
          m.first,
          m.stride,
          1 / (m.volume * substep.dt * substep.dt),
          gravity(substep)};
}

template <class D>
void FilmSet<D>::end(pbd::Substep<D>& substep) {
  using namespace film_kernels;
  step_time_ += substep.dt;
  bodies_.set_loads({});
  pbd::GhostExchange* const ranks = substep.ghosts.exchange;
  if (!is_on_device_ || all_.triangles.empty() || (substep.particles.sorted == 0 && !ranks)) return;
  if (!nearness_.any(bodies_.host_motions(), substep.dt, lengths_.widest())) return;
  const auto triangles = static_cast<uint32_t>(all_.triangles.size()),
             vertices = static_cast<uint32_t>(all_.vertices.size()),
             bodies = static_cast<uint32_t>(all_.bodies.size());
  const Surfaces film = surfaces();
  const Fluid around = fluid(substep);
  const ShapeSet& set = contacts_.shapes();
  const WorldAxes axes{LevelAxes(substep.gravity), of_world(), world_axes_.view()};
  device_.parallel_for("films/place", triangles, PlaceCentres{film, centre_.view()});
  candidates_.find(device_, set, centre_.view(), centre_.view(), triangles, lengths_.widest(),
                   {set.worlds, triangles / set.worlds});
  device_.parallel_for("films/gaps", triangles,
                       FindGaps{film, set, candidates_.view(), centre_.view(), lengths_, axes, gaps_.view()});
  has_film_.fill(0);
  particle_loads_.fill(0);
  passed_on_.fill(0);
  sums_.fill(0);
  device_.parallel_for("films/rims", vertices,
                       FindRims{film, set, gaps_.view(), around, lengths_, rims_.view(), has_film_.view()});
  if (ranks) merge_rims(*ranks);
  device_.parallel_for(
      "films/wet", triangles,
      FindWetFaces{film, set, centre_.view(), has_film_.view(), around, lengths_, gaps_.view()});
  if (ranks) merge_wet_faces(*ranks);
  const pbd::ParticleView& p = substep.particles;
  device_.parallel_for("films/particles", substep.contacts.contacts.count,
                       AddParticleLoads{substep.contacts, p.position, p.phase, p.sorted, has_film_.view(),
                                        lengths_, axes, 1 / substep.dt, particle_loads_.view()});
  if (ranks) merge_particle_loads(*ranks);
  const SolveViews views{pressure_.view(),  wet_part_.view(), residual_.view(),
                         direction_.view(), applied_.view(),  diagonal_.view()};
  device_.parallel_for_groups(
      "films/solve", bodies,
      SolveFilms{film, gaps_.view(), rims_.view(), has_film_.view(), particle_loads_.view(), lengths_,
                 gravity(substep), substep.dt, views, balance_.view()});
  for (int storey = 0; storey < film_tuning::storeys; ++storey) {
    device_.parallel_for("films/balance", bodies,
                         BalanceFilms{passed_on_.view(), substep.dt, balance_.view()});
    if (of_world() == 1 || storey + 1 == film_tuning::storeys) break;
    device_.parallel_for("films/pass", triangles,
                         AddPassedOn{film, set, gaps_.view(), pressure_.view(), balance_.view(), axes,
                                     substep.dt, passed_on_.view()});
  }
  device_.parallel_for("films/loads", triangles,
                       AddLoads{film, set, gaps_.view(), pressure_.view(), balance_.view(), probes_.view(),
                                axes, substep.dt, sums_.view(), probe_sums_.view()});
  device_.parallel_for("films/impulses", bodies, ReadLoads{sums_.view(), impulses_.view()});
  bodies_.set_loads(impulses_.view());
}

}  // namespace meniscus::collision
