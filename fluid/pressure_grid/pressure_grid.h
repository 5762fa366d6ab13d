// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The coarse grid that solves for the pressure of the whole fluid before the density iterations.
#pragma once

#include "fluid/pressure_grid/excess_kernels.h"
#include "fluid/pressure_grid/load_kernels.h"
#include "fluid/pressure_grid/multigrid.h"
#include "fluid/pressure_grid/sealed_components.h"
#include "fluid/pressure_grid/shared_nodes.h"
#include "pbd/substep.h"

namespace meniscus::fluid {

/// Iterations of the density constraint transport pressure by one support radius each. Before them, a coarse
/// grid solves for the pressure of the whole fluid, and moves the particles by its gradient.
///
/// Nodes are the corners of the cells by which particles are sorted, a support radius H apart. φ are the
/// trilinear weights of particles on nodes. ψ are those on the faces between two nodes, which are offset by
/// half a cell along an axis.
///
///   excess volume    b_c = Σ_i V φ_c(x_i) C_i, where C_i ≥ −.1: less is a surface's
///   faces            M_f = Σ_i m_i ψ_f(x_i); a_f is the fraction of the face that solids leave open
///   equation         Σ_f a_f² H⁴/M_f (P_c − P_nb) = b_c, P = 0 in the air, faces towards solids closed,
///                    and towards the dry side of cloth
///   motion           u_f = −a_f H² (P_nb − P_c)/M_f, Δx_i = ω Σ_f ψ_f(x_i) u_f
///
/// So a face transfers the impulse a_f H² ΔP to its particles, whatever their mass. Fluids of different
/// density need no special case, and without solids the sum over all faces is 0. Where faces are not equally
/// open, solids take up the difference through their contacts (load_kernels.h). A wall that moves in
/// increases C, and needs no flux of its own. A movable body reduces P.
///
/// This follows the pressure projection of grid methods (Batty, Bertails & Bridson 2007 for the open
/// fractions of faces), with the density error instead of the divergence.
///
/// Where ranks share the world, each finds what the nodes of its slab have. All ranks have all nodes, and
/// solve the same equation.
template <class D>
class PressureGrid {
 public:
  PressureGrid(D& device, const Kernel& kernel) : device_(device), kernel_(kernel), multigrid_(device) {}

  /// Makes room for this many particles, including their padding.
  void reserve(uint32_t size);
  /// Moves the particles, and adds the loads of solids to the contacts. `compressibility` is in 1/Pa; `last`
  /// holds C at the end of the last substep, `allowed` what is subtracted from C if there is a crowd.
  void displace(pbd::Substep<D>& substep, float compressibility,
                pbd::View<const density_kernels::Multiplier> last, pbd::View<const float> allowed = {});
  /// By particle: the pressure of the last displacement, kg·m², in the units of the density constraint's Λ.
  pbd::View<const float> multipliers() const { return multiplier_.view(); }

 private:
  bool fit(const pbd::Substep<D>& substep);
  void reserve_nodes(uint32_t count);
  void clear_nodes();
  void find_excess(pbd::Substep<D>& substep, pbd::View<const density_kernels::Multiplier> last,
                   pbd::View<const float> allowed);
  void classify(pbd::Substep<D>& substep);
  void gather(pbd::Substep<D>& substep, float compressibility);
  void move(pbd::Substep<D>& substep);
  grid_kernels::NodeMap map() const { return {space_.nodes, flags_.view()}; }
  float width2() const { return space_.width() * space_.width(); }

  D& device_;
  Kernel kernel_;
  Multigrid<D> multigrid_;
  SealedComponents<D> components_{device_};
  SharedNodes<D> shared_{device_};
  grid_kernels::Space space_;

  pbd::Buffer<grid_kernels::Found> found_{device_, "density excess"};
  pbd::Buffer<pbd::Vec4> scale_{device_, "weights on the grid"};
  pbd::Buffer<float> multiplier_{device_, "grid multipliers"};
  pbd::Buffer<uint32_t> flags_{device_, "grid nodes"};
  pbd::Buffer<uint32_t> inside_{device_, "grid nodes"};
  pbd::Buffer<float> filled_{device_, "grid filled fractions"};
  pbd::Buffer<float> give_{device_, "give of bodies"};
  pbd::Buffer<grid_kernels::NodeFaces> faces_{device_, "grid faces"};
  pbd::Buffer<grid_kernels::NodeLoad> load_{device_, "grid loads"};
  pbd::Buffer<pbd::Vec4> motion_{device_, "grid motion"};
  pbd::Buffer<grid_kernels::Lost> lost_{device_, "grid momentum"};
};

}  // namespace meniscus::fluid
