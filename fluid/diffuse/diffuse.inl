// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A step of the diffuse particles, as launches of the kernels in diffuse_kernels.h.
#pragma once

#include "fluid/diffuse/diffuse_kernels.h"
#include "fluid/diffuse/over_ranks.inl"

namespace meniscus::fluid {

template <class D>
Diffuse<D>::Diffuse(D& device, const DiffuseParameters& parameters)
    : device_(device), parameters_(parameters) {
  const uint32_t capacity = parameters.def.capacity;
  for (pbd::Buffer<DiffuseParticle>* b : {&present_, &moved_, &next_}) b->resize_discard(capacity);
  alive_.resize_discard(capacity);
  place_.resize_discard(capacity + 1);
  totals_.resize_discard(2);
}

template <class D>
void Diffuse<D>::reserve(uint32_t particles) {
  if (particles <= born_.size()) return;
  const size_t size = particles + particles / 4;
  normal_.resize_or_stay(size);
  normal_.fill(0);  // the element of the sentinel stays 0
  birth_place_.resize_or_stay(size + 1);
  born_.resize_or_stay(size);
}

template <class D>
void Diffuse<D>::observe(const pbd::Substep<D>& substep) {
  elapsed_ += substep.dt;
  if (!substep.is_last) return;
  move(substep);
  make(substep);
  any_pending_ = true;
}

/// Compacts the remaining particles into `next_`. Their number is the last element of `place_`.
template <class D>
void Diffuse<D>::move(const pbd::Substep<D>& s) {
  using namespace diffuse_kernels;
  candidates_ = count_ + exchange_particles(s);
  const pbd::View<const DiffuseParticle> before = present_.view();
  const pbd::View<DiffuseParticle> advanced = moved_.view().first(candidates_);
  device_.parallel_for("diffuse/move", candidates_,
                       Move{parameters_, s.particles.position, s.particles.velocity, s.particles.phase,
                            s.grid, s.particles.sorted + s.particles.ghosts, elapsed_, before, advanced});
  const pbd::View<uint32_t> alive = alive_.view().first(candidates_);
  device_.parallel_for("diffuse/alive", candidates_, MarkAlive{advanced, alive});
  if (is_shared()) device_.parallel_for("diffuse/left", count_, MarkHandedOver{before, s.grid, alive});
  device_.exclusive_scan("diffuse/places", alive, place_.view());
  device_.parallel_for("diffuse/keep", candidates_,
                       KeepAlive<DiffuseParticle>{advanced, place_.view(), next_.view()});
  if (is_shared())
    device_.parallel_for("diffuse/keep", candidates_,
                         KeepAlive<DiffuseKey>{keys_.view(), place_.view(), next_keys_.view()});
}

template <class D>
void Diffuse<D>::make(const pbd::Substep<D>& s) {
  using namespace diffuse_kernels;
  const pbd::ParticleView& p = s.particles;
  const uint32_t fluid = p.sorted;
  const BirthPlaces places{is_shared() ? pbd::View<const uint32_t>{} : p.slot};
  reserve(s.neighbours.sentinel + 1);
  device_.parallel_for("diffuse/surface", fluid,
                       FindSurface<D>{parameters_, p.position, p.velocity, s.neighbours, normal_.view()});
  if (is_shared()) pbd::refresh_ghosts(device_, s.ghosts, normal_.view());
  const pbd::View<uint32_t> born = born_.view().first(fluid);
  device_.parallel_for("diffuse/count", fluid,
                       CountBirths<D>{parameters_, p.position, p.velocity, normal_.view(), s.neighbours,
                                      p.phase, p.number, step_, elapsed_, places, born});
  device_.exclusive_scan("diffuse/births", born, birth_place_.view());
  if (is_shared()) agree_on_births(s);
  const pbd::View<const uint32_t> kept = place_.view().from(candidates_).first(1);
  device_.parallel_for("diffuse/make", fluid,
                       MakeNew{parameters_, p.position, p.velocity, p.number, birth_place_.view(), kept,
                               places, step_, elapsed_, next_.view()});
  if (is_shared())
    device_.parallel_for("diffuse/keys", fluid,
                         MakeKeys{p.slot, birth_place_.view(), kept, step_ + 1, next_keys_.view()});
  device_.parallel_for(
      "diffuse/totals", 1,
      NoteTotals{kept, birth_place_.view().from(fluid), parameters_.def.capacity, totals_.view()});
  if (walls_) walls_({next_.view(), totals_.view().first(1)});
}

template <class D>
void Diffuse<D>::accept() {
  if (!any_pending_) return;
  any_pending_ = false;
  uint32_t totals[2];
  totals_.read(std::span(totals));
  count_ = totals[0];
  refused_ = is_shared() ? next_refused_ : totals[1];
  all_count_ = next_all_count_;
  present_.swap(next_);
  keys_.swap(next_keys_);
  ++step_;
}

}  // namespace meniscus::fluid
