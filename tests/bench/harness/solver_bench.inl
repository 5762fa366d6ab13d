// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The harness of the solver and its neighbour search, for one device.
#pragma once

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

#include "collision/contact/shape_contacts.h"
#include "fluid/forces/smoothing_pass.h"
#include "fluid/forces/viscosity_set.h"
#include "fluid/pressure_grid/multigrid.inl"
#include "pbd/solver.h"
#include "pbd/solver_kernels.h"
#include "tests/bench/harness/solver_bench.h"

namespace meniscus::tests {

namespace bench_kernels {

/// Writes each list by slot, as slots.
template <class D>
struct ExportLists {
  pbd::NeighbourView list;
  pbd::View<const uint32_t> slot;
  uint32_t owned, width;
  pbd::View<uint32_t> entries, counts;

  MENISCUS_HD void operator()(uint32_t i) const {
    uint32_t* at = &entries[slot[i] * width];
    uint32_t count = 0;
    pbd::for_each_neighbour<D>(list, i, [&](auto j) {
      if constexpr (D::lane_count == 1) {
        at[count++] = name_of(j);
      } else {
        for (uint32_t k = 0; k < D::lane_count; ++k) at[count++] = name_of(j[static_cast<int>(k)]);
      }
    });
    counts[slot[i]] = count;
  }

  MENISCUS_HD uint32_t name_of(uint32_t j) const {
    return j < owned ? slot[j] : j == list.sentinel ? NeighbourLists::padding : NeighbourLists::broken;
  }
};

}  // namespace bench_kernels

template <class D, auto... device_arguments>
class SolverBenchOn final : public SolverBench {
  using Multiplier = fluid::density_kernels::Multiplier;

 public:
  NeighbourLists neighbours(std::span<const Vec3> points, float support_radius) override {
    std::vector<pbd::Vec4> particles;
    for (Vec3 p : points) particles.push_back(pbd::with_w(p, 1));
    Stage stage(support_radius);
    stage.add(particles, std::vector<Vec3>(points.size()), std::vector<uint32_t>(points.size()));
    NeighbourLists lists{{}, D::lane_count == 1 ? 4u : D::lane_count};
    stage.solver.measure([&](pbd::Substep<D>& s, const pbd::Found&) { lists.of = export_lists(s); });
    return lists;
  }

  DensitySolution solve_density(const DensityCase& setup) override {
    DensitySolution solution;
    with_density(setup, [&](pbd::Substep<D>& s, fluid::DensitySet<D>& density) {
      solution.errors = measured_errors(s, density);
      density.begin(s);
      for (int iteration = 0; iteration < setup.iterations; ++iteration) density.project(s, iteration);
      solution.positions = positions(s);
      solution.multipliers =
          by_slot<float>(s, density.multipliers().data, [](Multiplier m) { return m.value; });
    });
    return solution;
  }

  DensitySolution solve_baseline(const DensityCase& setup) override {
    DensitySolution solution;
    with_density(setup, [&](pbd::Substep<D>& s, fluid::DensitySet<D>& density) {
      density.start_step();
      density.least_substeps(s.dt, 1, s.particles);
      density.accelerate(s);
      density.begin(s);
      for (int iteration = 0; iteration < setup.iterations; ++iteration) density.project(s, iteration);
      const pbd::ParticleView& p = s.particles;
      s.device.parallel_for("velocity", p.owned,
                            pbd::solver_kernels::UpdateVelocity{p.position, p.accumulated_delta, p.velocity,
                                                                1 / s.dt, p.sorted});
      density.end(s);
      solution.positions = positions(s);
      solution.velocities = by_slot<Vec3>(s, p.velocity.data, [](pbd::Vec4 v) { return v.xyz(); });
      solution.multipliers =
          by_slot<float>(s, density.multipliers().data, [](Multiplier m) { return m.value; });
    });
    return solution;
  }

  std::vector<Vec3> push(const DensityCase& setup, float multiplier, float last_dt) override {
    DensityCase warm = setup;
    warm.parameters.warm_start = 1;
    std::vector<Vec3> pushed;
    with_density(warm, [&](pbd::Substep<D>& s, fluid::DensitySet<D>& density) {
      const float dt = std::exchange(s.dt, last_dt);
      density.begin(s);  // the first substep has nothing to start from; the second starts from these
      s.dt = dt;
      const std::vector<float> errors = measured_errors(s, density);
      std::vector<uint32_t> slot(setup.particles.size());
      s.device.copy_out(slot.data(), s.particles.slot.data, slot.size() * sizeof(uint32_t));
      // What they start from relieves all there is: the iteration adds nothing.
      const float kept = std::min(1.0f, dt * dt / (last_dt * last_dt));
      std::vector<Multiplier> start;
      for (uint32_t k : slot) start.push_back({multiplier, errors[k] / kept});
      s.device.copy_in(const_cast<Multiplier*>(density.multipliers().data), start.data(),
                       start.size() * sizeof(Multiplier));
      density.begin(s);
      s.iterations = 1;
      density.project(s, 0);
      pushed = positions(s);
    });
    return pushed;
  }

  std::vector<Vec3> smooth(const SmoothingCase& setup) override {
    Stage stage(setup.support_radius);
    const Planes planes(stage, setup.support_radius, 0.25f * setup.support_radius, setup.planes);
    fluid::ViscositySet<D> viscosity(stage.device, setup.kernel, setup.spacing);
    fluid::SmoothingPass<D> smoothing(stage.device, setup.kernel);
    viscosity.set_materials(setup.materials);
    std::vector<float> slip_lengths;
    for (const collision::Shape& plane : setup.planes) slip_lengths.push_back(plane.surface.slip_length);
    viscosity.set_walls(slip_lengths, {});
    smoothing.set_materials(setup.materials);
    stage.solver.add(viscosity);
    stage.solver.add(smoothing);
    stage.add(setup.particles, setup.velocities, setup.groups);
    std::vector<Vec3> velocities;
    stage.solver.measure([&](pbd::Substep<D>& s, const pbd::Found&) {
      s.dt = setup.dt;
      for (int pass = 0; pass < setup.passes; ++pass) {
        viscosity.end(s);
        smoothing.apply(s, stage.particles);
      }
      velocities = by_slot<Vec3>(s, s.particles.velocity.data, [](pbd::Vec4 v) { return v.xyz(); });
    });
    return velocities;
  }

  std::vector<float> solve(const GridEquation& equation, int iterations) override {
    D device{device_arguments...};
    fluid::Multigrid<D> multigrid(device);
    multigrid.fit(equation.table);
    const uint32_t nodes = equation.table.count();
    device.copy_in(multigrid.finest().coefficients.data, equation.coefficients.data(),
                   nodes * sizeof(pbd::Vec4));
    device.copy_in(multigrid.finest().right.data, equation.right.data(), nodes * sizeof(float));
    multigrid.solve(iterations);
    std::vector<float> found(nodes);
    device.copy_out(found.data(), multigrid.solution().data, nodes * sizeof(float));
    return found;
  }

 private:
  struct Stage {
    D device{device_arguments...};
    pbd::Particles particles{device};
    pbd::Solver<D> solver;

    explicit Stage(float support_radius) : solver(device, particles, parameters(support_radius)) {}

    static pbd::SolverParameters parameters(float support_radius) {
      pbd::SolverParameters p;
      p.gravity = {0, 0, 0};
      p.support_radius = support_radius;
      p.contact_radius = 0.25f * support_radius;
      return p;
    }

    void add(std::span<const pbd::Vec4> position, std::span<const Vec3> velocity,
             std::span<const uint32_t> group) {
      const auto count = static_cast<uint32_t>(position.size());
      solver.reserve(std::max(count, 1u));
      std::vector<pbd::Vec4> v;
      std::vector<pbd::Phase> phase;
      for (uint32_t i = 0; i < count; ++i) {
        v.push_back(pbd::with_w(velocity[i], 0));
        phase.push_back(pbd::phase_fluid | group[i]);
      }
      std::vector<uint32_t> slot(count);
      std::iota(slot.begin(), slot.end(), 0u);
      particles.append(position, v, phase, slot);
      solver.particles_changed(0, count);
    }
  };

  /// Planes with which the particles of a stage have contacts.
  struct Planes {
    pbd::Buffer<collision::Shape> shapes;
    collision::ShapeContacts<D> contacts;

    Planes(Stage& stage, float support_radius, float contact_radius, std::span<const collision::Shape> planes)
        : shapes(stage.device, "shapes"),
          contacts(stage.device, stage.particles, support_radius, contact_radius) {
      shapes.resize_discard(static_cast<uint32_t>(planes.size()));
      shapes.write(planes);
      contacts.set_shapes({shapes.view(), static_cast<uint32_t>(planes.size()), {}, {}, {}}, true);
      stage.solver.add(contacts);
    }
  };

  /// Calls use(substep, density) where the case's neighbours and contacts are known.
  template <class Use>
  static void with_density(const DensityCase& setup, const Use& use) {
    Stage stage(setup.support_radius);
    // With a contact radius of 0 a particle may be anywhere, and has all of its mirror ghosts.
    const Planes planes(stage, setup.support_radius, 0, setup.planes);
    fluid::DensitySet<D> density(stage.device, setup.kernel, setup.parameters);
    stage.solver.add(density);
    stage.add(setup.particles,
              setup.velocities.empty() ? std::vector<Vec3>(setup.particles.size()) : setup.velocities,
              std::vector<uint32_t>(setup.particles.size()));
    stage.solver.measure([&](pbd::Substep<D>& s, const pbd::Found&) {
      s.dt = setup.dt;
      s.iterations = setup.iterations;
      use(s, density);
    });
  }

  static std::vector<Vec3> positions(pbd::Substep<D>& s) {
    return by_slot<Vec3>(s, s.particles.position.data, [](pbd::Vec4 p) { return p.xyz(); });
  }

  template <class T>
  static std::vector<T> fetched(pbd::Substep<D>& s, const T* data) {
    std::vector<T> values(s.particles.owned);
    if (!values.empty()) s.device.copy_out(values.data(), data, values.size() * sizeof(T));
    return values;
  }

  template <class To, class From, class Convert>
  static std::vector<To> by_slot(pbd::Substep<D>& s, const From* data, const Convert& convert) {
    const std::vector<From> values = fetched(s, data);
    const std::vector<uint32_t> slots = fetched(s, s.particles.slot.data);
    std::vector<To> result(values.size());
    for (size_t i = 0; i < values.size(); ++i) result[slots[i]] = convert(values[i]);
    return result;
  }

  static std::vector<float> measured_errors(pbd::Substep<D>& s, const fluid::DensitySet<D>& density) {
    pbd::Buffer<float> error(s.device, "errors"), full(s.device, "full");
    error.resize_discard(s.particles.owned);
    full.resize_discard(s.particles.owned);
    density.measure(s, error.view(), full.view());
    return error.read(s.particles.owned);
  }

  static std::vector<std::vector<uint32_t>> export_lists(pbd::Substep<D>& s) {
    const uint32_t owned = s.particles.owned, width = s.neighbours.row_capacity + 8;
    pbd::Buffer<uint32_t> entries(s.device, "entries"), counts(s.device, "counts");
    entries.resize_discard(owned * width);
    counts.resize_discard(owned);
    s.device.parallel_for("export", owned,
                          bench_kernels::ExportLists<D>{s.neighbours, s.particles.slot, owned, width,
                                                        entries.view(), counts.view()});
    const std::vector<uint32_t> all = entries.read(owned * width), count = counts.read(owned);
    std::vector<std::vector<uint32_t>> lists(owned);
    for (uint32_t i = 0; i < owned; ++i) {
      const auto row = all.begin() + static_cast<std::ptrdiff_t>(size_t{i} * width);
      lists[i].assign(row, row + count[i]);
    }
    return lists;
  }
};

}  // namespace meniscus::tests
