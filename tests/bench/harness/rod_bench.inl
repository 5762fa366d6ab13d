// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The harness of rods and ropes, for one device.
#pragma once

#include "cloth/rods/rod_set.h"
#include "cloth/rods/rope_set.h"
#include "pbd/solver.h"
#include "tests/bench/harness/rod_bench.h"

namespace meniscus::tests {

template <class D>
class RodBenchOn final : public RodBench {
 public:
  template <class... Arguments>
  explicit RodBenchOn(const RodScene& scene, Arguments... arguments)
      : device_(arguments...), solver_(device_, particles_, parameters(scene)), substeps_(scene.substeps) {
    solver_.add(rods_);
    solver_.add(ropes_);
    rods_.set_model(scene.rods);
    ropes_.set_model(scene.ropes);
    const auto count = static_cast<uint32_t>(scene.points.size());
    solver_.reserve(count);
    std::vector<pbd::Vec4> position;
    for (uint32_t i = 0; i < count; ++i)
      position.push_back(pbd::with_w(scene.points[i], scene.masses[i] > 0 ? 1 / scene.masses[i] : 0));
    particles_.set_vertices(position, std::vector<pbd::Vec4>(count), std::vector<pbd::Phase>(count));
    solver_.particles_changed(0, count);
  }

  void step(float dt) override { solver_.step(dt); }
  std::vector<Vec3> positions() override { return vectors(particles_.view().position); }
  std::vector<Vec3> velocities() override { return vectors(particles_.view().velocity); }
  void set_velocities(std::span<const Vec3> velocities) override {
    std::vector<pbd::Vec4> v;
    for (Vec3 velocity : velocities) v.push_back(pbd::with_w(velocity, 0));
    particles_.velocity.current.write(v);
    solver_.particles_changed(0, particles_.count());
  }
  std::vector<cloth::SegmentState> states() override { return rods_.states(0, rods_.segment_count()); }
  void set_state(uint32_t segment, const cloth::SegmentState& state) override {
    rods_.set_states(segment, std::span(&state, 1));
  }
  std::vector<Vec3> torques() override { return rods_.torques(0, rods_.segment_count()); }
  std::vector<float> tensions() override { return ropes_.tensions(0, ropes_.segment_count()); }
  std::vector<Vec3> reactions(float dt) override {
    const float h = dt / static_cast<float>(substeps_);
    std::vector<Vec3> forces = vectors(particles_.view().accumulated_delta);
    for (Vec3& f : forces) f = f / (h * h);
    return forces;
  }
  void set_rods(const cloth::RodModel& model) override { rods_.set_model(model); }
  void save() override { rods_.save(); }
  void restore() override { rods_.restore(); }

 private:
  static pbd::SolverParameters parameters(const RodScene& scene) {
    pbd::SolverParameters p;
    p.gravity = scene.gravity;
    p.substeps = scene.substeps;
    p.iterations = scene.iterations;
    return p;
  }

  std::vector<Vec3> vectors(pbd::View<pbd::Vec4> from) {
    std::vector<pbd::Vec4> values(particles_.count());
    device_.copy_out(values.data(), from.data, values.size() * sizeof(pbd::Vec4));
    std::vector<Vec3> result;
    for (const pbd::Vec4& v : values) result.push_back(v.xyz());
    return result;
  }

  D device_;
  pbd::Particles particles_{device_};
  pbd::Solver<D> solver_;
  cloth::RodSet<D> rods_{device_};
  cloth::RopeSet<D> ropes_{device_};
  int substeps_;
};

}  // namespace meniscus::tests
