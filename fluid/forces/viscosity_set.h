// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The constraint set that applies viscosity once velocities are known.
#pragma once

#include <span>
#include <vector>

#include "fluid/forces/viscosity_cloth_kernels.h"
#include "fluid/forces/viscosity_wall_kernels.h"
#include "fluid/kernel/material.h"
#include "pbd/device/shared_buffer.h"
#include "pbd/substep.h"
#include "pbd/vertex_means.h"

namespace meniscus::fluid {

/// Implicit viscosity with forces along the line between two particles (Weiler, Koschier, Brand & Bender
/// 2018; the Laplacian is Monaghan's):
///
///   (M + h_t A) v = M v*,   (A v)_i = Σ_j 10 μ_ij s³ φ_ij n (n · (v_i − v_j)),   n = (x_i − x_j)/r
///   φ(r) = K (1 − r²/h²)²,  K so that Σ φ x² y²/r² = 1/5 over the rest lattice
///
/// The sum is the lattice's viscosity in a shear along its axes. A relaxed fluid, where pairs give way one by
/// one, has the same to a few percent. In a continuum it is that of Σ φ r² = 3.
///
/// Linear and angular momentum are kept, and a rigid rotation is not braked. μ_ij is the harmonic mean; a
/// grain takes the viscosity of the fluid. A wall with a slip length adds terms to A: it completes its
/// particles in a linear shear, whose velocity is that of the wall one slip length behind it
/// (viscosity_wall_kernels.h). Bodies receive the opposite impulse through the contacts, so this set comes
/// before them. Cloth is such a wall on both of its sides. Its vertices are part of the solve, with their own
/// masses (viscosity_cloth_kernels.h). So light cloth transmits the stress from one side to the other.
///
/// Conjugate gradients start from v*, and are preconditioned with the masses alone. Then each iterate keeps
/// the momenta, and dissipates. The iterations end when the residual is small, on the device; their number is
/// bounded by the spectrum of the matrix.
template <class D>
class ViscositySet final : public pbd::ConstraintSet<D> {
 public:
  ViscositySet(D& device, const Kernel& kernel, double spacing);

  void set_materials(std::span<const Material> materials);
  /// Slip lengths by number of fixed shape, and by number of body; m.
  void set_walls(std::span<const float> shapes, std::span<const float> bodies);
  /// Slip lengths by piece of cloth, m.
  void set_cloth(std::span<const float> pieces);
  /// Who knows the vertices behind contacts on cloth. It must outlive this set. Without it cloth is no wall.
  void set_vertex_means(pbd::VertexMeans<D>& means) { means_ = &means; }

  void reserve(uint32_t capacity, uint32_t kept) override;
  void project(pbd::Substep<D>&, int) override {}
  void end(pbd::Substep<D>& substep) override;

 private:
  template <bool uniform>
  void solve(pbd::Substep<D>& substep);
  template <bool uniform>
  void iterate(pbd::Substep<D>& substep, const viscosity_kernels::Forces<uniform>& forces, double stiffness);
  template <bool uniform>
  void finish(pbd::Substep<D>& substep, const viscosity_kernels::Forces<uniform>& forces);
  template <bool uniform>
  viscosity_kernels::Forces<uniform> forces_of(const pbd::Substep<D>& substep);
  viscosity_kernels::Walls walls_of(const pbd::Substep<D>& substep);
  double wall_scale(float dt) const;
  void choose_vertices(const pbd::Substep<D>& substep);
  template <bool uniform>
  void weigh_walls(const pbd::Substep<D>& substep, const viscosity_kernels::Forces<uniform>& forces);
  void weigh_cloth(const pbd::Substep<D>& substep);
  void solve_vertices(const pbd::Substep<D>& substep, pbd::View<const pbd::Vec4> vector,
                      pbd::View<const pbd::Vec4> change, pbd::View<const pbd::Vec4> before);
  viscosity_kernels::Vertices vertices_of(const pbd::Substep<D>& substep);
  void write_slip();
  uint32_t most_iterations(double stiffness) const;
  void make_room() override;

  D& device_;
  Kernel kernel_;
  double spacing_;
  double weight_sum_;   // Σ φ over the rest lattice, 1/m²
  double peak_weight_;  // K, 1/m²
  bool acts_ = false, uniform_ = true;
  float common_viscosity_ = 0;      // Pa·s
  double kinematic_viscosity_ = 0;  // m²/s, the largest that acts on a particle
  uint32_t capacity_ = 0;
  pbd::VertexMeans<D>* means_ = nullptr;
  std::vector<float> shape_slip_, body_slip_, cloth_slip_;  // m
  uint32_t vertices_ = 0;                                   // of cloth, that take part in the present solve
  float sum_unit_ = 0;                                      // kg·m/s, in which forces on vertices are summed
  uint32_t number_ = 0;                                     // of the solve: see Progress

  pbd::Buffer<float> table_{device_, "fluid viscosities"}, viscosity_{device_, "particle viscosities"};
  pbd::Buffer<float> slip_{device_, "slip lengths"};
  pbd::Buffer<float> wall_weights_{device_, "viscosity at walls"};  // by contact
  // By contact on cloth: the velocity of the cloth, and forces with weights. By vertex: see Vertices.
  pbd::Buffer<pbd::Vec4> cloth_{device_, "viscosity at cloth"}, cloth_force_{device_, "viscosity at cloth"},
      vertex_sums_{device_, "viscosity at cloth"}, vertex_diagonal_{device_, "viscosity at cloth"},
      vertex_mixed_{device_, "viscosity at cloth"}, vertex_velocity_{device_, "viscosity at cloth"};
  pbd::Buffer<pbd::Vec4> residual_{device_, "viscosity solve"}, product_{device_, "viscosity solve"},
      direction_{device_, "viscosity solve"}, along_direction_{device_, "viscosity solve"},
      change_{device_, "viscosity solve"};
  pbd::Buffer<viscosity_kernels::Dots> dots_{device_, "viscosity solve"};
  pbd::Buffer<viscosity_kernels::Progress> progress_{device_, "viscosity solve"};
  pbd::SharedBuffer<uint32_t> ended_{device_, "viscosity's end"};
};

}  // namespace meniscus::fluid
