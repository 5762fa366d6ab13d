// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The fluid in gaps between solids that are too narrow for particles.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "collision/body/body_set.h"
#include "collision/film/film_nearness.h"
#include "collision/film/film_solve.h"
#include "pbd/substep.h"

namespace meniscus::collision {

/// Where the multipliers of the fluid particles are.
struct FluidMultipliers {
  const float* first = nullptr;
  uint32_t stride = 1;  ///< floats from one particle's to the next
  float volume = 1;     ///< m³: the pressure is multiplier / (volume · dt²)
};

/// Loads both faces of a gap that is too narrow for particles with the pressure of the fluid in it. The fluid
/// is a film, with the pressure of Reynolds' equation at steady state:
///
///   ∇·(g³ ∇(p − ρ g·x)) = 0, with p of the fluid or the air beside it at the rim.
///
/// It follows from the gaps and the multipliers of a substep alone. The loads go to BodySet as impulses. So
/// this set must stand before it. Where ranks share the world, each looks at the fluid in its region. What
/// they see is merged, and all solve the same equations.
template <class D>
class FilmSet final : public pbd::ConstraintSet<D> {
 public:
  FilmSet(D& device, const film_kernels::Lengths& lengths, ShapeContacts<D>& contacts, BodySet<D>& bodies)
      : device_(device), lengths_(lengths), contacts_(contacts), bodies_(bodies), candidates_(device) {}

  /// Where the multipliers are is asked for in each substep. Those of ghosts must be fresh then.
  using FindMultipliers = std::function<FluidMultipliers(const pbd::Substep<D>&)>;
  void set_fluid(FindMultipliers multipliers) { multipliers_ = std::move(multipliers); }
  /// The parts of bodies; see join_film_parts. Must be called when shapes or bodies change. Fixed shapes come
  /// first. Of several worlds, bodies and parts come world after world.
  void set_parts(std::span<const FilmPart> parts, uint32_t bodies, std::span<const Shape> shapes,
                 uint32_t fixed, uint32_t worlds = 1);
  /// m/s², by world. Empty: all have that of the substep.
  void set_gravities(std::span<const pbd::Vec4> gravities);
  void set_probes(std::span<const film_kernels::LoadProbe> probes);
  /// By probe: the mean force and torque of films over the last step, N and N·m.
  std::span<const RigidImpulse> read_probes();

  void reserve(uint32_t capacity, uint32_t) override { has_fluid_ = capacity > 0; }
  void start_step() override;
  void project(pbd::Substep<D>&, int) override {}
  void end(pbd::Substep<D>& substep) override;

 private:
  void upload();
  film_kernels::Surfaces surfaces() const;
  film_kernels::WorldGravity gravity(const pbd::Substep<D>& substep) const;
  uint32_t of_world() const { return static_cast<uint32_t>(all_.bodies.size()) / worlds_; }  // bodies
  film_kernels::Fluid fluid(const pbd::Substep<D>& substep) const;
  void merge_rims(pbd::GhostExchange& ranks);
  void merge_wet_faces(pbd::GhostExchange& ranks);
  void merge_particle_loads(pbd::GhostExchange& ranks);

  D& device_;
  film_kernels::Lengths lengths_;
  ShapeContacts<D>& contacts_;
  BodySet<D>& bodies_;
  Candidates candidates_;
  FindMultipliers multipliers_;
  FilmSurfaces all_;
  FilmNearness nearness_;
  bool has_fluid_ = false, is_on_device_ = true;
  float step_time_ = 0;  // s
  uint32_t worlds_ = 1;

  pbd::Buffer<pbd::Vec4> gravities_{device_, "film gravities"};  // by world, where there are several
  pbd::Buffer<film_kernels::LevelAxes> world_axes_{device_, "film axes"};  // likewise
  pbd::Buffer<Vec3> vertices_{device_, "film vertices"};
  pbd::Buffer<FilmTriangle> triangles_{device_, "film triangles"};
  pbd::Buffer<uint32_t> first_corner_{device_, "film corners"};
  pbd::Buffer<FilmCorner> corners_{device_, "film corners"};
  pbd::Buffer<FilmRange> ranges_{device_, "film bodies"};
  pbd::Buffer<pbd::Vec4> centre_{device_, "film centres"};
  pbd::Buffer<film_kernels::Gap> gaps_{device_, "film gaps"};
  pbd::Buffer<film_kernels::RimPoint> rims_{device_, "film rims"};
  pbd::Buffer<uint32_t> has_film_{device_, "film bodies"};
  pbd::Buffer<float> pressure_{device_, "film pressures"};
  pbd::Buffer<float> residual_{device_, "film residuals"};
  pbd::Buffer<float> direction_{device_, "film directions"};
  pbd::Buffer<float> applied_{device_, "film directions"};
  pbd::Buffer<float> diagonal_{device_, "film diagonal"};
  pbd::Buffer<float> wet_part_{device_, "film pressures"};
  pbd::Buffer<film_kernels::Balance> balance_{device_, "film loads"};
  pbd::Buffer<film_kernels::ParticleLoad> particle_loads_{device_, "film loads"};
  pbd::Buffer<film_kernels::UpwardImpulse> passed_on_{device_, "film loads"};
  pbd::Buffer<film_kernels::WholeImpulse> sums_{device_, "film loads"};
  pbd::Buffer<RigidImpulse> impulses_{device_, "film loads"};
  pbd::Buffer<film_kernels::LoadProbe> probes_{device_, "film probes"};
  pbd::Buffer<film_kernels::WholeImpulse> probe_sums_{device_, "film probes"};
  std::vector<film_kernels::WholeImpulse> probe_reads_;
  std::vector<RigidImpulse> probe_loads_;
};

}  // namespace meniscus::collision
