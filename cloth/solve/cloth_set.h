// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The constraint set of cloth.
#pragma once

#include <span>

#include "cloth/build/chains.h"
#include "cloth/build/cloth_model.h"
#include "cloth/build/wind.h"
#include "cloth/solve/bending_solver.h"
#include "cloth/solve/load_kernels.h"
#include "cloth/solve/vertex_state.h"
#include "cloth/solve/volume_kernels.h"
#include "pbd/device/shared_buffer.h"
#include "pbd/substep.h"

namespace meniscus::cloth {

namespace stretch_kernels {
struct SolveEdge;
}

enum class ChainStage : uint32_t;

struct ClothSolverParameters {
  float over_relaxation = 1.2f;  ///< ω of stretch and shear outside chains, 1 to 1.3
  float warm_start = 0.7f;       ///< fraction of the last multipliers of edges outside chains, 0 to 0.95
  int stretch_rounds = 1;        ///< of stretch and shear in the last iteration, ≥ 1
};

/// Cloth: stretch, shear, bending, gas and tethers as XPBD constraints (Macklin, Müller & Chentanez 2016),
/// solved by Gauss–Seidel, and the force of the air on it.
///
///   project   adds the iteration's part of the wind. In the first iteration, solves isometric bending as one
///             block (bending_solver.h), and starts edges outside chains from a fraction of their last pulls,
///             which chains absorb before cloth moves. Sweeps over dihedral bending, then over stretch, pass
///             by pass (clusters.h). Solves for the lengths of whole chains, layer by layer (chains.h). The
///             last iteration repeats stretch and chains in a number of rounds. The next iteration runs
///             backwards. Gas has its turn at the start or at the end, and tethers come last;
///   settle    records the pulls at held vertices. Loaded pieces forget the pulls of their edges.
///
/// Small substeps converge better than many iterations (Macklin et al. 2019). Sweeps in both directions make
/// the whole a symmetric map, whose eigenvalues are real. A sweep in one direction alone rotates some modes
/// and amplifies them. Over-relaxation above 1.33 and a fraction above 0.38 do so as well: with a residual
/// factor p and v = Δx/h, each mode obeys z² = p (2z − 1).
template <class D>
class ClothSet final : public pbd::ConstraintSet<D>, public pbd::Observer<D> {
 public:
  ClothSet(D& device, const ClothSolverParameters& parameters) : device_(device), parameters_(parameters) {}

  /// The model must be set again before the next step.
  void set_parameters(const ClothSolverParameters& parameters) { parameters_ = parameters; }

  /// Sets all cloth of the world, or of each world of a batch. Multipliers start from 0.
  void set_model(const ClothModel& model, uint32_t worlds = 1);
  void set_wind(const Wind& wind) { wind_ = wind; }
  /// s, of the substep that left its multipliers; 0: there was none.
  float last_substep() const { return last_dt_; }
  void set_last_substep(float seconds) { last_dt_ = seconds; }

  bool prepares() const override;
  void prepare(pbd::Substep<D>& substep) override;
  void begin(pbd::Substep<D>& substep) override;
  void project(pbd::Substep<D>& substep, int iteration) override;
  void settle(pbd::Substep<D>& substep) override;
  void end(pbd::Substep<D>& substep) override;
  void observe(const pbd::Substep<D>& substep) override;
  void start_step() override;
  void undo_step() override { time_ = start_time_; }
  void save() override;
  void restore() override;
  void visit_state(pbd::StateVisitor& v);
  void keep_world(uint32_t each) override;
  void reset_worlds(const pbd::ChosenWorlds& worlds) override;
  void undo_worlds(const pbd::ChosenWorlds& worlds) override;
  /// Visits one world of a batch as visit_state() would visit it alone.
  void visit_world(pbd::StateVisitor& v, uint32_t world);

  pbd::SurfaceView surface() const {
    return {triangles_.view(), rest_.view(), corner_start_.view(), corners_.view()};
  }
  /// What pulled and pushed at each held vertex in the last step, N·s.
  std::vector<Vec3> read_reactions() const;
  /// By piece, the least part of its bending stiffness that substeps have resolved.
  const std::vector<float>& bending_fractions() const { return bending_.fractions(); }
  /// Whether any edge was stretched beyond its limit in the last step.
  bool found_tears() const { return !tears_.host().empty() && tears_.host()[0] != 0; }

 private:
  template <class T>
  static void upload(pbd::Buffer<T>& buffer, const std::vector<T>& values) {
    buffer.resize_discard(values.size());
    buffer.write(values);
  }
  ClothModel upload_constraints(const ClothModel& model);
  void upload_edges(const ClothModel& model, Clusters& clusters, const Chains& chains);
  void reserve_bending_multipliers(int iterations);
  void upload_adjacency(const ClothModel& model, const std::vector<EdgeConstraint>& edges);
  VertexState vertices(const pbd::Substep<D>& substep) const {
    return {substep.particles, pieces_.view(), damping_, 1 / substep.dt};
  }
  View<Vec4> chain_multiplier() { return edge_multiplier_.view().from(first_chain_edge_); }
  /// Through passes, colours and layers.
  enum class Direction { forwards, backwards };
  /// What a sweep continues from. The multipliers of a substep start in its first iteration.
  enum class Follows { last_substep, last_iteration, last_round };
  struct SweepOrder {
    Follows follows;
    Direction direction;
    bool ends = false;  ///< the last sweep of the substep

    bool starts() const { return follows == Follows::last_substep; }
    bool is_backwards() const { return direction == Direction::backwards; }
  };
  void bend(pbd::Substep<D>& substep, const SweepOrder& order);
  void stretch(pbd::Substep<D>& substep, int rounds, const SweepOrder& order);
  void sweep(pbd::Substep<D>& substep, size_t first_pass, size_t end_pass, const SweepOrder& order);
  bool starts_from_last() const { return warm_start_fraction_ > 0 && first_chain_edge_ > 0; }
  void start_from_last(pbd::Substep<D>& substep);
  /// Whether any piece may be loaded. Its multipliers must then be forgotten.
  bool may_be_loaded(const pbd::Substep<D>& substep) const {
    return substep.effective_mass.count > 0 || substep.fluid_near.count > 0 || may_be_fresh();
  }
  /// Whether worlds of a batch may be reset to a state without multipliers, while others have some.
  bool may_be_fresh() const { return in_batch_ && kept_clock_.has_last == 0; }
  stretch_kernels::SolveEdge edge_solver(const pbd::Substep<D>& substep, const SweepOrder& order);
  void sweep_colours(pbd::Substep<D>& substep, const SweepOrder& order);
  void note_loads(pbd::Substep<D>& substep);
  void forget_pulls(pbd::Substep<D>& substep);
  void solve_chains(pbd::Substep<D>& substep, ChainStage stage, Direction direction);
  void copy_clocks(const pbd::Buffer<load_kernels::WorldClock>& from,
                   pbd::Buffer<load_kernels::WorldClock>& to) {
    if (in_batch_)
      device_.copy(to.view().data, from.view().data, from.size() * sizeof(load_kernels::WorldClock));
  }
  void write_multipliers(View<const uint32_t> chosen, View<const Vec4> edges, View<const float> chains,
                         pbd::WorldsFrom kind);
  void apply_gas(pbd::Substep<D>& substep, bool starts);

  D& device_;
  ClothSolverParameters parameters_;
  BendingSolver<D> bending_{device_};
  Wind wind_;
  double time_ = 0, start_time_ = 0;  // s
  uint32_t vertex_count_ = 0, worlds_ = 1;
  CommonDamping damping_;
  bool any_air_ = false, any_gas_ = false, any_tears_ = false;
  bool feels_wind_ = false;                // in this substep
  float last_dt_ = 0, saved_last_dt_ = 0;  // s, of the substep that left its multipliers; 0: none has
  float warm_start_fraction_ = 0;          // of the multipliers that the last substep left

  pbd::Buffer<EdgeConstraint> edges_{device_, "cloth edges"};
  pbd::Buffer<StrainConstraint> strains_{device_, "cloth strains"};
  pbd::Buffer<HingeConstraint> hinges_{device_, "cloth hinges"};
  pbd::Buffer<Batch> batches_{device_, "constraint batches"};
  pbd::Buffer<Cluster> clusters_{device_, "constraint clusters"};
  pbd::Buffer<uint32_t> cluster_vertices_{device_, "vertices of clusters"};
  pbd::Buffer<Chain> chains_{device_, "chains"};
  std::vector<uint32_t> layer_starts_{0};  // of chains
  uint32_t first_chain_edge_ = 0;
  std::vector<uint32_t> pass_starts_{0};
  uint32_t bending_passes_ = 0;
  std::vector<uint32_t> colour_starts_;  // of edges outside chains, if these are solved by colour
  pbd::Buffer<Vec4> edge_multiplier_{device_, "edge multipliers"};
  pbd::Buffer<Vec4> saved_edge_multiplier_{device_, "saved edge multipliers"};
  pbd::Buffer<float> saved_chain_multiplier_{device_, "saved chain multipliers"};
  pbd::Buffer<Vec4> strain_multiplier_{device_, "strain multipliers"};
  pbd::Buffer<float> hinge_multiplier_{device_, "hinge multipliers"};
  pbd::Buffer<Vec4> pending_{device_, "pending pushes of cloth"};
  pbd::Buffer<uint32_t> edge_end_start_{device_, "edges by vertex"}, edge_ends_{device_, "edges by vertex"};
  pbd::Buffer<uint32_t> loaded_{device_, "loaded pieces"};
  pbd::Buffer<uint32_t> corner_start_{device_, "triangles by vertex"},
      corners_{device_, "triangles by vertex"};
  pbd::Buffer<Tether> tethers_{device_, "tethers"};
  pbd::Buffer<Vec4> tether_pull_{device_, "tether pulls"};
  pbd::Buffer<uint32_t> held_{device_, "held vertices"}, tether_start_{device_, "tethers by anchor"};
  pbd::Buffer<Vec4> reaction_{device_, "reactions"};
  pbd::Buffer<Piece> pieces_{device_, "pieces of cloth"};
  pbd::Buffer<pbd::SurfaceTriangle> triangles_{device_, "cloth triangles"};
  pbd::Buffer<Vec3> rest_{device_, "cloth at rest"};
  pbd::Buffer<Vec4> wind_force_{device_, "wind"};
  pbd::Buffer<Vec4> volume_gradient_{device_, "volume gradients"};
  pbd::Buffer<volume_kernels::GasState> gas_partial_{device_, "gas sums"}, gas_{device_, "gas"};
  pbd::Buffer<float> gas_step_{device_, "gas steps"};
  pbd::SharedBuffer<uint32_t> tears_{device_, "tears"};

  // Of a batch.
  bool in_batch_ = false;
  load_kernels::WorldClock kept_clock_{};
  pbd::Buffer<load_kernels::WorldClock> clocks_{device_, "cloth clocks"},
      saved_clocks_{device_, "cloth clocks"}, kept_clocks_{device_, "cloth clocks"};
  pbd::Buffer<uint32_t> edge_places_{device_, "edges by world"};  // empty: in the order of worlds
  pbd::Buffer<Vec4> kept_edge_multiplier_{device_, "kept edge multipliers"};
  pbd::Buffer<float> kept_chain_multiplier_{device_, "kept chain multipliers"};
};

}  // namespace meniscus::cloth
