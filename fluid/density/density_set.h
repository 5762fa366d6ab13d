// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The density constraint of Position Based Fluids: its parameters and its constraint set.
#pragma once

#include <memory>
#include <span>

#include "fluid/kernel/density_kernels.h"
#include "pbd/chebyshev.h"
#include "pbd/substep.h"

namespace meniscus::fluid {

template <class D>
class DensityStop;
template <class D>
class PressureGrid;
template <class D>
class Crowd;
template <class D>
class Baseline;

/// What solves for the fluid's pressure: the density constraint, or a method of others (fluid/baselines/).
enum class DensityMethod { constraint, pcisph, wcsph, dfsph };

struct ArtificialPressure {
  float pressure = 0;     ///< Pa, at the distance below
  int exponent = 4;       ///< n
  float distance = 0.2f;  ///< Δq over h
};

struct DensityParameters {
  DensityMethod method = DensityMethod::constraint;
  bool chebyshev = true;
  bool pressure_grid = false;        ///< moves particles before the iterations (pressure_grid.h)
  float relaxation = 0.3f;           ///< ω of damped Jacobi
  float warm_start = 0.4f;           ///< fraction of the last substep's multipliers
  float spectral_bound = 4.5f;       ///< of D⁻¹A, for Chebyshev
  float tolerance = 0;               ///< mean of max(C, 0) at which the iterations end; 0: all iterations run
  float compressibility = 0;         ///< 1/Pa
  float correction_limit = 0.0125f;  ///< m, in one iteration
  float courant_number = 0.4f;       ///< of baselines: spacings in a substep; 0: no bound
  float parting_speed = 1.25f;       ///< m/s, of particles that were placed too dense (crowd.h)
  float spacing = 0.05f;             ///< m
  Vec3 gravity{0, -9.81f, 0};        ///< m/s², from which baselines estimate speeds
  ArtificialPressure artificial_pressure;
};

/// The density constraint of Position Based Fluids, for every fluid particle: C_i = Σ_j V W(x_i − x_j) − 1 ≤
/// 0. The sum is over neighbours and their mirror ghosts in the walls (fluid/kernel/mirror_ghosts.h).
///
///   D_i  = w_i |Σ e_ij|² + Σ w_j |e_ij|²,  e_ij = V |∇W| (x_i − x_j)/r
///   λ'_i = max(0, λ_i + step · (C_i − α̃ λ_i)/(D_i + α̃)),  Δλ = λ' − λ
///   Δx_i = w_i Σ_j (Δλ_i + Δλ_j) e_ij
///
/// α̃ = α/h_t² is XPBD's compliance (Macklin, Müller & Chentanez 2016) with α = compressibility/V. It replaces
/// the paper's ε. The multiplier of the whole substep is clamped, not its increments, so that an iteration
/// can undo the excess of an earlier one.
///
/// `step` is ω for Jacobi, or the weights of the Chebyshev semi-iteration (on the spectrum of D⁻¹A), which
/// reuse the last increment.
///
/// Grains count in the sums like fluid, by their volume (Macklin et al. 2014, section 7.1), and keep λ = 0.
/// The pressure of the fluid around them moves them, and they float or sink by their mass.
///
/// The paper adds its repulsion (eq. 13) in every iteration, so that it grows with their number. Here it acts
/// in the first iteration alone, as a pressure. So the motion does not depend on the step or the number of
/// iterations.
///
/// With another method this set hosts it: it keeps the multipliers, and only relaxes overlaps itself.
template <class D>
class DensitySet final : public pbd::ConstraintSet<D> {
 public:
  DensitySet(D& device, const Kernel& kernel, const DensityParameters& parameters);
  ~DensitySet() override;

  /// Applies from the next substep on.
  void set_parameters(const DensityParameters& parameters);

  /// Sets which kinds of particles may exist.
  void set_kinds(bool any_fluid, bool any_grains) {
    any_fluid_ = any_fluid;
    any_grains_ = any_grains;
  }

  /// Call it when particles were placed by hand: they may be too dense.
  void note_placed(uint32_t first, uint32_t count);

  void reserve(uint32_t capacity, uint32_t kept) override;
  void clear(uint32_t first, uint32_t count) override;
  bool needs_own_cells() const override { return pressure_grid_ != nullptr; }
  void reorder(pbd::View<const uint32_t> order, uint32_t count) override;
  void save() override;
  void restore() override;
  void add_carried(std::vector<pbd::WordArray>& arrays) override {
    arrays.push_back({reinterpret_cast<uint32_t*>(multiplier_.current.view().data),
                      sizeof(density_kernels::Multiplier) / sizeof(uint32_t)});
  }

  void keep_world(uint32_t each) override;
  void reset_worlds(const pbd::ChosenWorlds& worlds) override;
  void undo_worlds(const pbd::ChosenWorlds& worlds) override;

  void visit_state(pbd::StateVisitor& v);

  /// Whether particles that were placed too dense have not parted yet.
  bool any_crowd() const;
  /// s, of the last substep: its multipliers are those of `multipliers()`.
  float last_substep() const { return last_dt_; }
  void visit_multipliers(pbd::StateVisitor& v, uint32_t count);
  /// 0: there was none.
  void set_last_substep(float seconds) { last_dt_ = seconds; }
  /// Takes over the multipliers of the particles from `first` on.
  void set_multipliers(uint32_t first, std::span<const density_kernels::Multiplier> multipliers);

  void start_step() override;
  int least_substeps(float dt, int chosen, const pbd::ParticleView& start) override;
  void accelerate(pbd::Substep<D>&) override { relaxes_ = false; }
  void begin(pbd::Substep<D>& substep) override;
  void project(pbd::Substep<D>& substep, int iteration) override;
  void end(pbd::Substep<D>& substep) override;

  /// Λ of the last substep, kg·m²: pressure is Λ / (V h_t²), with V = Kernel::particle_volume.
  pbd::View<const density_kernels::Multiplier> multipliers() const { return multiplier_.current.view(); }
  /// Gives the ghosts of a shared world those of their owners.
  void refresh_multipliers(const pbd::GhostView& ghosts) {
    if (ghosts.exchange) pbd::refresh_ghosts(device_, ghosts, multiplier_.current.view());
  }
  /// The compression that particles of a crowd may keep in this substep; empty without a crowd.
  pbd::View<const float> allowed() const { return allowed_; }
  /// In this substep, particles of pistons get their multipliers from the fluid around them. Call it after
  /// begin().
  void extrapolate_to_pistons() { extrapolates_ = true; }
  /// Iterations done in a step with `planned` iterations. Call it when the device has finished the step.
  uint32_t iterations_done(uint32_t planned) const;
  /// C of each particle at the substep's present positions.
  void measure(const pbd::Substep<D>& substep, pbd::View<float> error, pbd::View<float> full) const;

  const Kernel& kernel() const { return kernel_; }

 private:
  void forget(uint32_t first, uint32_t count);
  void set_baseline(const DensityParameters& parameters);
  template <class K>
  void iterate(const K& kernel, pbd::Substep<D>& substep, const density_kernels::Advancing& advancing,
               const density_kernels::PairPressure& pair);
  template <density_kernels::WallMotion motion, density_kernels::Grains grains, class K>
  void iterate(const K& kernel, pbd::Substep<D>& substep, const density_kernels::Advancing& advancing,
               const density_kernels::PairPressure& pair);
  template <density_kernels::Repulsion repulsion, density_kernels::WallMotion motion, class K>
  void correct(const K& kernel, pbd::Substep<D>& substep, const density_kernels::PairPressure& pair);

  template <class Run, class LongRun>
  void launch_both(const char* name, uint32_t count, const Run& kernel, uint32_t long_count,
                   const LongRun& long_kernel);

  D& device_;
  Kernel kernel_;
  DensityParameters parameters_;
  float last_dt_ = 0, saved_dt_ = 0;
  bool saving_ = false;
  float warm_start_fraction_ = 0;  // the fraction of the last substep's multipliers
  bool any_fluid_ = true, any_grains_ = false;
  pbd::Chebyshev chebyshev_;
  float relaxation_ = 0;  // ω, for the kernel's spectrum
  bool relaxes_ = true;   // overlaps are relaxed: no time passes
  pbd::View<const float> allowed_{};
  std::unique_ptr<Crowd<D>> crowd_;
  std::unique_ptr<PressureGrid<D>> pressure_grid_;  // exists if the parameters ask for it
  std::unique_ptr<DensityStop<D>> stop_;            // exists if there is a tolerance
  std::unique_ptr<Baseline<D>> baseline_;           // exists if the method is another
  bool by_baseline_ = false;                        // in this substep
  bool extrapolates_ = false;                       // in this substep

  pbd::DoubleBuffer<density_kernels::Multiplier> multiplier_{device_, "density multipliers"};
  pbd::Buffer<float> increment_{device_, "density increments"};
  pbd::Buffer<pbd::Vec4> staged_{device_, "staged corrections"};
  pbd::Buffer<density_kernels::Multiplier> kept_multiplier_{device_, "kept multipliers"};
  pbd::Buffer<density_kernels::Multiplier> saved_multiplier_{device_, "saved multipliers"};
};

}  // namespace meniscus::fluid
