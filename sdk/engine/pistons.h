// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The pistons that imposed emitters push. Layers of particles move through a duct behind the mouth at a given
// velocity, like the inflow zone of other particle methods (Lastiwka, Basa & Quinlan 2009). They have their
// place in the density constraint, so that the fluid in front has full support. Nothing moves them.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "fluid/density/density_set.h"
#include "pbd/device/buffer.h"
#include "pbd/ranks/ranks.h"
#include "pbd/substep.h"
#include "sdk/engine/piston_kernels.h"

namespace meniscus {

template <class D>
class Pistons final : public pbd::ConstraintSet<D> {
 public:
  Pistons(D& device, fluid::DensitySet<D>& density) : device_(device), density_(density) {}

  /// What the next step pushes, by ascending slot. It replaces all that was there.
  void set(pbd::Particles& particles, std::span<const Piston> pistons,
           std::span<const PistonParticle> pushed) {
    if (pistons.empty() && host_pistons_.empty()) return;
    fit(pistons_, pistons.size());
    fit(plain_.found, pistons.size());
    fit(plain_.total, pistons.size());
    fit(exact_.found, pistons.size());
    fit(exact_.total, pistons.size());
    fit(pushed_, pushed.size());
    fit(impulse_, pushed.size());
    if (!pistons.empty()) reserve_scratch(capacity_);
    host_pistons_.assign(pistons.begin(), pistons.end());
    host_pushed_.assign(pushed.begin(), pushed.end());
    pistons_.write(pistons);
    pushed_.write(pushed);
    device_.parallel_for(
        "pistons/mark", particles.sorted(),
        piston_kernels::Mark{table(), particles.slot.current.view(), particles.phase.current.view()});
  }

  /// Opens the walls at the mouths in the substep's contacts.
  void open_walls(const pbd::Substep<D>& s) {
    if (host_pistons_.empty()) return;
    device_.parallel_for("pistons/walls", s.particles.sorted,
                         piston_kernels::OpenWalls{table().pistons, s.particles.phase, s.particles.position,
                                                   s.contacts, density_.kernel().h});
  }

  void reserve(uint32_t capacity, uint32_t) override {
    capacity_ = capacity;
    if (error_.size()) reserve_scratch(capacity);
  }
  void start_step() override {
    plain_.total.fill(0);
    exact_.total.fill(0);
  }
  void accelerate(pbd::Substep<D>& s) override {
    moves_ = true;
    open_walls(s);
  }
  void begin(pbd::Substep<D>& s) override {
    if (!moves_) open_walls(s);
    dt_ = moves_ ? s.dt : 0;
    moves_ = false;
    impulse_.fill(0);
    place(s, true);
  }
  /// Undoes what the sets did in the iteration before: so the constraints see an infinite mass.
  void project(pbd::Substep<D>& s, int iteration) override {
    if (iteration > 0) return place(s, false);
    if (!host_pushed_.empty()) density_.extrapolate_to_pistons();
  }
  void settle(pbd::Substep<D>& s) override {
    place(s, false);
    if (host_pistons_.empty()) return;
    device_.fixes_sums() ? measure(s, exact_) : measure(s, plain_);
  }
  void end(pbd::Substep<D>& s) override { place(s, true); }

  /// Of the last step, by piston. Call it when the device has finished the step; in a shared world, on all
  /// ranks.
  std::vector<PistonReading> read(pbd::Ranks* ranks) {
    if (host_pistons_.empty()) return {};
    return device_.fixes_sums() ? read_exactly(ranks) : readings_of(plain_.total.read(host_pistons_.size()));
  }

 private:
  /// Grows by more than needed.
  template <class T>
  static void fit(pbd::Buffer<T>& buffer, size_t count) {
    if (count > buffer.size()) buffer.resize_or_stay(std::max<size_t>(64, count + count / 2));
  }
  void reserve_scratch(uint32_t capacity) {
    error_.resize_or_stay(capacity);
    full_.resize_or_stay(capacity);
  }
  piston_kernels::Table table() const {
    return {pushed_.view().first(static_cast<uint32_t>(host_pushed_.size())),
            pistons_.view().first(static_cast<uint32_t>(host_pistons_.size()))};
  }
  void place(pbd::Substep<D>& s, bool starts) {
    if (host_pushed_.empty()) return;
    const pbd::ParticleView& p = s.particles;
    device_.parallel_for(
        "pistons/place", p.sorted,
        piston_kernels::Place{table(), p.phase, p.slot, p.previous, p.position, p.accumulated_delta,
                              p.velocity, impulse_.view(), dt_, starts});
  }
  template <class Sums>
  struct OfStep {
    explicit OfStep(D& device) : found(device, "loads on pistons"), total(device, "loads on pistons") {}
    pbd::Buffer<Sums> found, total;
  };
  template <class Sums>
  void measure(pbd::Substep<D>& s, OfStep<Sums>& sums) {
    using namespace piston_kernels;
    const pbd::ParticleView& p = s.particles;
    const auto each = [&](const char* name, const auto& map_of) {
      const auto count = static_cast<uint32_t>(host_pistons_.size());
      for (uint32_t k = 0; k < count; ++k)
        device_.reduce(name, p.sorted, Sums{}, map_of(k), Add<Sums>{}, sums.found.view().from(k));
      device_.parallel_for(name, count, Accumulate<Sums>{sums.found.view(), sums.total.view()});
    };
    if (dt_ > 0)
      each("pistons/loads", [&](uint32_t k) {
        return ImpulseSums<Sums>{{table(),
                                  k,
                                  {host_pistons_[k], s.contacts, density_.kernel().h},
                                  p.phase,
                                  p.slot,
                                  impulse_.view(),
                                  dt_}};
      });
    if (!s.is_last) return;
    const pbd::View<const uint32_t> places = measure_errors(s);
    each("pistons/ahead", [&](uint32_t k) {
      return Ahead<Sums>{host_pistons_[k], p.position, places, p.phase, error_.view(), density_.kernel().h};
    });
  }
  /// By slot, or in a shared world by place. Returns the elements of the particles.
  pbd::View<const uint32_t> measure_errors(pbd::Substep<D>& s) {
    pbd::Substep<D> read = s;
    if (s.ghosts.exchange) {
      pbd::refresh_ghost_positions(device_, s.ghosts, s.particles.position);
      if (places_.size() < capacity_) {
        std::vector<uint32_t> places(capacity_);
        std::iota(places.begin(), places.end(), 0u);
        places_.resize_discard(capacity_);
        places_.write(places);
      }
      read.particles.slot = places_.view();
    }
    density_.measure(read, error_.view(), full_.view());
    return read.particles.slot;
  }
  std::vector<PistonReading> read_exactly(pbd::Ranks* ranks) {
    std::vector<piston_kernels::ExactSums> exact = exact_.total.read(host_pistons_.size());
    if (ranks) add_up(*ranks, exact);
    std::vector<piston_kernels::PlainSums> sums;
    for (const auto& e : exact) sums.push_back({e.impulse.value(), e.error.value(), e.ahead});
    return readings_of(sums);
  }
  static void add_up(pbd::Ranks& ranks, std::vector<piston_kernels::ExactSums>& sums) {
    std::vector<uint64_t> parts;
    for (const auto& s : sums) {
      for (const pbd::ExactSum& sum : {s.impulse, s.error}) {
        const auto own = sum.split();
        parts.insert(parts.end(), own.begin(), own.end());
      }
      parts.push_back(s.ahead);
    }
    ranks.add_up(parts);
    const uint64_t* next = parts.data();
    for (auto& s : sums) {
      s = {pbd::ExactSum::joined(next), pbd::ExactSum::joined(next + pbd::ExactSum::parts),
           next[2 * pbd::ExactSum::parts]};
      next += 2 * pbd::ExactSum::parts + 1;
    }
  }
  static std::vector<PistonReading> readings_of(const std::vector<piston_kernels::PlainSums>& sums) {
    std::vector<PistonReading> readings;
    for (const auto& s : sums)
      readings.push_back({s.impulse, s.ahead > 0 ? s.error / static_cast<double>(s.ahead) : 0});
    return readings;
  }

  D& device_;
  fluid::DensitySet<D>& density_;
  std::vector<Piston> host_pistons_;
  std::vector<PistonParticle> host_pushed_;
  uint32_t capacity_ = 0;
  bool moves_ = false;  // time passes in this substep
  float dt_ = 0;
  pbd::Buffer<Piston> pistons_{device_, "pistons"};
  pbd::Buffer<PistonParticle> pushed_{device_, "piston particles"};
  pbd::Buffer<float> impulse_{device_, "piston impulses"};
  OfStep<piston_kernels::PlainSums> plain_{device_};
  OfStep<piston_kernels::ExactSums> exact_{device_};
  pbd::Buffer<uint32_t> places_{device_, "places"};  // of a shared world: 0, 1, 2, …
  pbd::Buffer<float> error_{device_, "density errors"};
  pbd::Buffer<float> full_{device_, "full support"};
};

}  // namespace meniscus
