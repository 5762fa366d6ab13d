// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The position-based solver: parameters, results and interface. solver/solver.inl has the algorithm.
#pragma once

#include <meniscus/hooks.h>

#include <functional>
#include <optional>
#include <vector>

#include "pbd/contact_arrays.h"
#include "pbd/external_forces.h"
#include "pbd/kept_vertices.h"
#include "pbd/math/periodic_axes.h"
#include "pbd/neighbour_search.h"
#include "pbd/rank_exchange.h"
#include "pbd/seam_ghosts.h"
#include "pbd/stage_timer.h"
#include "pbd/substep.h"

namespace meniscus::pbd {

namespace solver_kernels {
struct Prediction;
}

struct SolverParameters {
  Vec3 gravity{0, -9.81f, 0};      ///< m/s²
  float support_radius = 0.1f;     ///< m
  float contact_radius = 0.0125f;  ///< m
  int substeps = 4;
  int iterations = 10;
  float cfl_number = 0;  ///< when > 0, it determines the number of substeps, within the limits
  int min_substeps = 1, max_substeps = 16;
  PeriodicAxes periodic{};  ///< for worlds with fluid particles alone
  bool fixed_sums = false;  ///< see WorldDef::sums
};

/// A reduction over the particles, for the host.
struct ParticleSummary {
  Vec3 lower, upper;        ///< m, of the finite ones
  float max_speed2;         ///< m²/s²
  uint32_t non_finite;      ///< number of particles
  uint32_t first_bad_slot;  ///< no_index when there is none
};

/// The results of the substeps' searches. The host reads them at the end of the step.
struct Found {
  SumNote contacts;       ///< of the last substep, and the maximum over all
  uint32_t longest_list;  ///< of the neighbour lists
  SumNote ghosts;         ///< of periodic axes, like `contacts`
};

struct StepReadout {
  ParticleSummary summary;
  Found found;
};

struct StepResult {
  int substeps = 0;
  uint32_t contacts = 0;
  uint32_t max_neighbours = 0;
  ParticleSummary summary{};
};

/// The position-based solver on device D. It defines how a step runs; the sets define the constraints.
template <class D>
class Solver {
 public:
  Solver(D& device, Particles& particles, const SolverParameters& parameters);

  /// Applies from the next step on; the radii, the periodic axes and fixed_sums do not change.
  void set_parameters(const SolverParameters& parameters) { parameters_ = parameters; }
  /// Added parts must outlive the solver. They run in the order in which they were added.
  void add(ContactSource<D>& source) { contacts_.add(source); }
  void add(ConstraintSet<D>& set) { sets_.push_back(&set); }
  void add(VelocityPass<D>& pass) { passes_.push_back(&pass); }
  void add(Observer<D>& observer) { observers_.push_back(&observer); }
  void add(ExternalForces<D>& forces) { forces_.push_back(&forces); }
  /// Calls call(hook, the present arrays, substep, iteration) at each hook of the set, a bit each.
  using HookCall = std::function<void(Hook, const ParticleView&, const Substep<D>&, int)>;
  void set_hooks(uint32_t hooks, HookCall call) {
    hooks_ = hooks;
    hook_call_ = std::move(call);
  }

  /// Makes room for this many fluid particles and vertices, here and in all parts.
  void reserve(uint32_t fluid, uint32_t vertices = 0);
  /// The particles [first, first + count) are new, or all were changed from outside.
  void particles_changed(uint32_t first, uint32_t count);
  // A batch of worlds (worlds.h). It starts as one world, which is reset into all.
  /// Keeps the present state, to which worlds are reset. Its vertices belong to so many pieces of cloth.
  void keep_world(uint32_t pieces);
  /// Makes room for `worlds` of the kept one, without periodic axes. Then set the vertices of all worlds, and
  /// reset them. From then on a step with particles that are not finite is not undone: undo_worlds() does
  /// that, for their worlds alone.
  void make_worlds(uint32_t worlds);
  uint32_t worlds() const { return worlds_; }
  uint32_t vertices_of_world() const { return particles_.vertices() / worlds_; }
  /// m/s², by world; empty: all have that of the parameters.
  void set_gravities(View<const Vec4> gravities) { gravities_ = gravities; }
  /// The kept state, with its multipliers.
  void reset_worlds(View<const uint32_t> chosen);
  /// The state before the last step.
  void undo_worlds(View<const uint32_t> chosen);

  /// The arrays of all sets follow a removal of particles: see ParticleState.
  void reorder(View<const uint32_t> order, uint32_t count) {
    for (ConstraintSet<D>* set : sets_) set->reorder(order, count);
  }

  /// Advances by dt. When the result's summary counts non-finite particles, the state is the one before the
  /// call.
  StepResult step(float dt) {
    begin_step(dt, parameters_.iterations);
    return end_step();
  }
  /// The two halves of step(), with a number of iterations of its own. Between them the device works, and
  /// nothing else may be called.
  void begin_step(float dt, int iterations);
  StepResult end_step();
  /// Solves for positions and discards the velocities: resolves overlaps.
  void relax(float dt, int times);
  /// The same for the particles from slot `first` on. All others stay, and all velocities.
  void relax_from(uint32_t first, float dt, int times);

  /// Calls measure(substep, found) with neighbours and contacts of the present positions. The state does not
  /// change.
  void measure(const std::function<void(Substep<D>&, const Found&)>& measure);

  /// Calls read(substep) with the neighbours and contacts of the last substep, and does not wait. They lack
  /// only pairs that came into reach within that substep. Returns false, without a call, if they do not
  /// belong to the present particles.
  bool read_last_substep(const std::function<void(Substep<D>&)>& read);

  /// From now on the world is shared with other ranks, which have made the same calls so far. Keeps the
  /// particles in this rank's region. Throws Error(capacity) if there are too few layers for the ranks. There
  /// must be no vertices.
  void share(Ranks& ranks, const CutPolicy& policy);
  /// The same while no particles are here: those at these positions are to come. Append those that
  /// may_need() says, and then call keep_own().
  void cut(Ranks& ranks, const CutPolicy& policy, std::span<const Vec4> positions);
  bool may_need(Vec3 p) const { return search_.grid().holds(search_.grid().coordinates(p)); }
  /// This rank has all particles that it needs, and keeps its own.
  void keep_own();
  bool is_shared() const { return exchange_.has_value(); }
  /// Whether a new particle at p belongs to this rank.
  bool owns(Vec3 p) const { return search_.grid().owns(search_.grid().coordinates(p)); }
  /// Makes room for so many more on this rank.
  void reserve_own(uint32_t more);
  /// Notes how many particles all ranks have, after some were added or removed.
  void set_all_particles(uint32_t count) { all_particles_ = count; }

  /// The state of the particles. Makes the room that they had. The sets have visits of their own.
  void visit_state(StateVisitor& v);

  const ParticleSummary& summary();
  /// The contacts of the last substep, or measurement.
  ContactView contacts() { return contacts_.view(); }
  StageTimer& timer() { return timer_; }

 private:
  void substep(float dt, bool is_first, bool is_last);
  solver_kernels::Prediction predict(float dt, Vec3 gravity);
  void sort(const solver_kernels::Prediction& prediction);
  CellOrder order_among_ranks(const solver_kernels::Prediction& prediction);
  void join(Ranks& ranks, const CutPolicy& policy);
  void merge_over_ranks();
  void add_results_of_ranks(StepResult& result);
  void keep_own_room();
  template <class Work>
  decltype(auto) with_room_on_all_ranks(const Work& work);
  void find(Substep<D>& s, bool prepares);
  Substep<D> find_at_rest(float dt);
  template <class Finish>
  void relax_and(float dt, int times, const Finish& finish);
  Substep<D> relax_once(float dt);
  void run(float dt);
  StepResult finish();
  template <class Change>
  void change_worlds(View<const uint32_t> chosen, const Change& change);
  View<const Vec4> velocity_changes(const ParticleView& start, float dt);
  void call_hook(Hook hook, const Substep<D>& s, int iteration = 0) {
    if (hooks_ & (1u << static_cast<uint32_t>(hook))) hook_call_(hook, particles_.view(), s, iteration);
  }
  bool had_room();
  void make_room();
  void make_room_for_ghosts();
  struct Room {
    uint32_t fluid = 0, vertices = 0, extra = 0, ghosts = 0;

    bool operator==(const Room&) const = default;
  };
  void reserve_all(const Room& room);
  void reserve_or_stay(const Room& room);
  void reserve_extra();
  bool has_ghost_room() const { return readout_.found.ghosts.most <= room_.ghosts; }
  void summarize();
  void update_velocities(const Substep<D>& s);
  int choose_substeps(float dt);
  bool needs_own_cells() const;
  Aabb table_extent();
  static MotionView motion_of(const Substep<D>& s);
  bool is_fast(float dt) const;
  Substep<D> make_substep(float dt);
  void save_state();
  void restore_state();
  void start_sets();
  void undo_step();
  template <class Undo>
  void undo_or_lose(const Undo& undo);

  D& device_;
  Particles& particles_;
  SolverParameters parameters_;
  NeighbourSearch<D> search_;
  ContactArrays<D> contacts_;
  SeamGhosts<D> ghosts_;
  std::optional<RankExchange<D>> exchange_;  // of a shared world
  bool has_all_particles_ = false;           // that this rank needs: nothing is sent
  uint32_t all_particles_ = 0;               // of all ranks
  uint32_t rank_ghosts_ = 0;
  KeptWorld<D> kept_world_;
  KeptVertices<D> kept_vertices_;
  std::vector<ConstraintSet<D>*> sets_;
  size_t started_ = 0;  // sets whose start_step() was called in this step
  std::vector<VelocityPass<D>*> passes_;
  std::vector<Observer<D>*> observers_;
  std::vector<ExternalForces<D>*> forces_;
  uint32_t hooks_ = 0;
  HookCall hook_call_;
  StageTimer timer_;

  Buffer<StepReadout> readout_buffer_{device_, "step read-out"};
  StepReadout readout_{};
  Room room_;
  uint32_t worlds_ = 1;
  View<const Vec4> gravities_{};
  bool has_found_ = false;  // neighbours and contacts are of the end of the last step, and of all particles
  bool fresh_ = true;       // particles were added or changed from outside since the last step
  float step_dt_ = 0;       // s, of the step that was begun
  int step_substeps_ = 0;   // of that step
  int step_iterations_ = 0;
  float step_speed_ = 0;   // m/s, the upper limit of a particle's speed in the present step
  float step_motion_ = 0;  // m, in the present step at that speed
  enum class SummaryState { unknown, on_device, known } summary_state_ = SummaryState::unknown;
};

}  // namespace meniscus::pbd
