// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The launches and arrays that the baselines share.
#pragma once

#include "fluid/baselines/pressure_kernels.h"
#include "fluid/density/iteration_end.h"

namespace meniscus::fluid {

template <class D>
class PressureStage {
  using WallMotion = density_kernels::WallMotion;

 public:
  PressureStage(D& device, const Kernel& kernel)
      : device_(device), kernel_(shaped<SmoothingKernel::poly6_spiky>(kernel)) {}

  void reserve(uint32_t size, uint32_t sentinel) {
    compression_.resize_discard(size);
    step_.resize_discard(size);
    // A substep without room for all contacts leaves some unwritten, and is done again.
    compression_.fill(0);
    step_.fill(0);
    staged_.resize_discard(size);
    constexpr float away = pbd::Particles::far_away;
    const pbd::Vec4 far[] = {{away, away, away, 0}};
    staged_.write(far, sentinel);
  }

  const baseline_kernels::BaselineKernel& kernel() const { return kernel_; }
  pbd::View<float> compression() { return compression_.view(); }
  pbd::View<float> step() { return step_.view(); }
  pbd::View<pbd::Vec4> staged() { return staged_.view(); }

  /// Takes gradients at the present positions from now on.
  void stage(pbd::Substep<D>& s) {
    device_.parallel_for("baseline/stage", s.particles.sorted,
                         baseline_kernels::Stage{s.particles.position, staged_.view()});
  }
  /// Finds ω/D of each particle at the present positions.
  void find_steps(pbd::Substep<D>& s, float relaxation) {
    s.contacts.any_moving ? find_steps<WallMotion::any>(s, relaxation)
                          : find_steps<WallMotion::none>(s, relaxation);
  }
  /// Computes C of each particle at the present positions. `wrap` wraps the kernels.
  template <class Wrap>
  void compress(pbd::Substep<D>& s, const Wrap& wrap) {
    using namespace baseline_kernels;
    const pbd::ParticleView& p = s.particles;
    const pbd::ContactView contacts = s.contacts.of_first(p.sorted);
    device_.parallel_for_both(
        "baseline/compress", p.sorted,
        wrap(Compress{kernel_, p.position, s.neighbours, contacts.start, compression_.view()}),
        contacts.contacts.count,
        wrap(CompressAtWalls{kernel_, p.position, s.neighbours, contacts, compression_.view()}));
  }
  /// Pushes the target by the staged multipliers.
  template <class Target, class Wrap>
  void push(pbd::Substep<D>& s, const Target& target, const Wrap& wrap) {
    s.contacts.any_moving ? push<WallMotion::any>(s, target, wrap) : push<WallMotion::none>(s, target, wrap);
  }
  static baseline_kernels::ToPositions to_positions(const pbd::Substep<D>& s) {
    return {s.particles.position, s.particles.accumulated_delta};
  }
  template <bool recede>
  static baseline_kernels::ToVelocities<recede> to_velocities(const pbd::Substep<D>& s) {
    return {s.particles.accumulated_delta, s.particles.velocity, 1 / s.dt};
  }

 private:
  template <WallMotion motion>
  void find_steps(pbd::Substep<D>& s, float relaxation) {
    using namespace baseline_kernels;
    const pbd::ParticleView& p = s.particles;
    const pbd::ContactView contacts = s.contacts.of_first(p.sorted);
    device_.parallel_for_both(
        "baseline/steps", p.sorted,
        FindSteps{kernel_, p.position, s.neighbours, contacts.start, relaxation, step_.view()},
        contacts.contacts.count,
        FindStepsAtWalls<motion>{kernel_, p.position, s.neighbours, contacts, relaxation, step_.view()});
  }
  template <WallMotion motion, class Target, class Wrap>
  void push(pbd::Substep<D>& s, const Target& target, const Wrap& wrap) {
    using namespace baseline_kernels;
    const pbd::ContactView contacts = s.contacts.of_first(s.particles.sorted);
    pbd::ContactProjection walls = pbd::contact_projection(s);
    walls.contacts = contacts;
    device_.parallel_for_both(
        "baseline/push", s.particles.sorted,
        wrap(Push<Target>{kernel_, staged_.view(), s.neighbours, contacts.start, target}),
        contacts.contacts.count,
        wrap(PushAtWalls<motion, Target>{{kernel_, {}, staged_.view(), s.neighbours, walls, false}, target}));
  }

  D& device_;
  baseline_kernels::BaselineKernel kernel_;
  pbd::Buffer<float> compression_{device_, "compressions"};
  pbd::Buffer<float> step_{device_, "pressure steps"};
  pbd::Buffer<pbd::Vec4> staged_{device_, "staged pressures"};
};

}  // namespace meniscus::fluid
