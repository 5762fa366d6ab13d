// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The pistons that imposed emitters push. Layers of particles move through a duct behind the mouth at a given
// velocity, like the inflow zone of other particle methods (Lastiwka, Basa & Quinlan 2009). They have their
// place in the density constraint, so that the fluid in front has full support. Nothing moves them.
#pragma once

#include <algorithm>
#include <vector>

#include "fluid/density/density_set.h"
#include "pbd/device/buffer.h"
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
    fit(ahead_, pistons.size());
    fit(load_, pistons.size());
    fit(loads_, pistons.size());
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
    impulse_.fill(0);
    loads_.fill(0);
  }
  void accelerate(pbd::Substep<D>& s) override {
    moves_ = true;
    open_walls(s);
  }
  void begin(pbd::Substep<D>& s) override {
    if (!moves_) open_walls(s);
    dt_ = moves_ ? s.dt : 0;
    moves_ = false;
    place(s, true);
  }
  /// Undoes what the sets did in the iteration before: so the constraints see an infinite mass.
  void project(pbd::Substep<D>& s, int iteration) override {
    if (iteration > 0) return place(s, false);
    if (!host_pushed_.empty()) density_.extrapolate_to_pistons();
  }
  void settle(pbd::Substep<D>& s) override {
    place(s, false);
    if (dt_ > 0) add_loads(s);
    if (s.is_last) measure_ahead(s);
  }
  void end(pbd::Substep<D>& s) override { place(s, true); }

  /// Of the last step, by piston. Call it when the device has finished the step.
  std::vector<PistonReading> read() {
    std::vector<PistonReading> readings(host_pistons_.size());
    std::vector<float> impulses(host_pushed_.size());
    impulse_.read(std::span(impulses));
    for (size_t k = 0; k < impulses.size(); ++k)
      readings[host_pushed_[k].piston].impulse += double{impulses[k]};
    std::vector<CrowdAhead> ahead(host_pistons_.size());
    std::vector<double> loads(host_pistons_.size());
    ahead_.read(std::span(ahead));
    loads_.read(std::span(loads));
    for (size_t k = 0; k < ahead.size(); ++k) readings[k].impulse += loads[k];
    for (size_t k = 0; k < ahead.size(); ++k)
      readings[k].error_ahead = ahead[k].count > 0 ? ahead[k].error / ahead[k].count : 0;
    return readings;
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
  void add_loads(pbd::Substep<D>& s) {
    const auto count = static_cast<uint32_t>(host_pistons_.size());
    for (uint32_t k = 0; k < count; ++k)
      device_.reduce("pistons/loads", s.particles.sorted, 0.0,
                     piston_kernels::WallLoad{host_pistons_[k], s.contacts, density_.kernel().h},
                     piston_kernels::Add{}, load_.view().from(k));
    device_.parallel_for("pistons/loads", count,
                         piston_kernels::Accumulate{load_.view(), loads_.view(), s.dt});
  }
  void measure_ahead(pbd::Substep<D>& s) {
    if (host_pistons_.empty()) return;
    const pbd::ParticleView& p = s.particles;
    density_.measure(s, error_.view(), full_.view());
    for (uint32_t k = 0; k < host_pistons_.size(); ++k) {
      device_.reduce("pistons/ahead", p.sorted, CrowdAhead{},
                     piston_kernels::Ahead{host_pistons_[k], p.position, p.slot, p.phase, error_.view(),
                                           density_.kernel().h},
                     piston_kernels::AddAhead{}, ahead_.view().from(k));
    }
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
  pbd::Buffer<CrowdAhead> ahead_{device_, "fluid ahead of pistons"};
  pbd::Buffer<double> load_{device_, "loads of a substep beside pistons"};
  pbd::Buffer<double> loads_{device_, "loads beside pistons"};
  pbd::Buffer<float> error_{device_, "density errors"};
  pbd::Buffer<float> full_{device_, "full support"};
};

}  // namespace meniscus
