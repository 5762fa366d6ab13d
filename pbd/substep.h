// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The interfaces of the solver's parts: constraint sets, velocity passes, observers and contact sources.
#pragma once

#include <meniscus/types.h>

#include <vector>

#include "pbd/contacts.h"
#include "pbd/ghosts.h"
#include "pbd/grid.h"
#include "pbd/neighbours.h"
#include "pbd/particles.h"
#include "pbd/worlds.h"

namespace meniscus::pbd {

/// The data of a substep that constraint sets and velocity passes use.
template <class D>
struct Substep {
  D& device;
  ParticleView particles;
  NeighbourView neighbours;
  ContactView contacts;
  float dt = 0;  ///< s
  int iterations = 0;
  Vec3 gravity{0, 0, 0};  ///< m/s²
  GridView grid{};        ///< the cells by which fluid particles are sorted, at their predicted positions
  bool is_last = false;   ///< of its step
  /// By vertex of cloth, where cloth may carry bodies, within an iteration. w: the effective mass, kg; x, y
  /// and z: the multipliers with which chains have pressed it, kg·m. See collision::EffectiveMass.
  View<Vec4> effective_mass{};
  /// Where fluid may be on cloth: elements v and v + 1 are equal if no fluid is near vertex v.
  View<const uint32_t> fluid_near{};
  /// Within an iteration: the last set that moved particles has projected their contacts as well.
  bool are_contacts_projected = false;
  /// What sets refresh of the arrays that they write and neighbours read. Positions of ghosts are fresh when
  /// the substep's sets start, and once positions are final; velocities when the sets start.
  GhostView ghosts{};
};

template <class D>
Withstanding withstanding(const Substep<D>& substep) {
  return {substep.particles.position, substep.particles.accumulated_delta, substep.contacts};
}

/// Arrays of fluid particles that a set stores. They follow when particles are sorted, added and removed.
class ParticleState {
 public:
  virtual ~ParticleState() = default;
  /// Makes room for this many particles of all kinds, plus one, as neighbour lists end with an index behind
  /// them; 0 without fluids. The first `kept` elements are kept.
  virtual void reserve(uint32_t /*capacity*/, uint32_t /*kept*/) {}
  virtual void clear(uint32_t /*first*/, uint32_t /*count*/) {}
  /// Element i becomes the former element order[i]. Called after the particles are sorted, before the solve.
  virtual void reorder(View<const uint32_t> /*order*/, uint32_t /*count*/) {}
  virtual void save() {}
  virtual void restore() {}
  /// Adds the arrays that a particle takes along to another rank. They have room for as many as reserve()
  /// said. What arrives is written behind the present elements, before reorder().
  virtual void add_carried(std::vector<WordArray>& /*arrays*/) {}

  // For batches of worlds, see worlds.h.
  /// Keeps the present state of the first `each` particles, to which worlds can be reset.
  virtual void keep_world(uint32_t /*each*/) {}
  virtual void reset_worlds(const ChosenWorlds& /*worlds*/) {}
  /// Back to what was saved.
  virtual void undo_worlds(const ChosenWorlds& /*worlds*/) {}
};

/// One kind of constraint, for all particles that it affects. Sets project in the order in which they were
/// added; contacts come after the fluid, bodies last.
template <class D>
class ConstraintSet : public ParticleState {
 public:
  /// m/s, the greatest speed at which this set can move a surface in dt.
  virtual float speed(float /*dt*/) { return 0; }
  /// The least number of substeps in which a step of length dt from this state can be solved. `chosen`: the
  /// number so far. Called once a step, after speed().
  virtual int least_substeps(float /*dt*/, int chosen, const ParticleView& /*start*/) { return chosen; }
  /// Called before the prediction: predicts objects that move along with the particles.
  virtual void predict(float /*dt*/) {}
  /// The number of particles that a substep adds for this set, after all others. At most one set adds any.
  virtual uint32_t extra_particles() const { return 0; }
  /// Called after the prediction, before contacts are found: adds such particles to substep.particles.owned.
  virtual void arrange(Substep<D>&) {}
  /// Whether prepare() has anything to do.
  virtual bool prepares() const { return false; }
  /// Called like arrange(), for work that needs no more than that, and does not affect which contacts are
  /// found. A GPU finds contacts at the same time. Not called while overlaps are relaxed.
  virtual void prepare(Substep<D>&) {}
  /// Called when neighbours and contacts are known: forces change velocities and predicted positions. Not
  /// called while overlaps are relaxed.
  virtual void accelerate(Substep<D>&) {}
  /// Called before the first iteration.
  virtual void begin(Substep<D>&) {}
  /// One iteration: moves particles.position towards C(p) = 0.
  virtual void project(Substep<D>&, int iteration) = 0;
  /// Called when positions are final, before velocities are known.
  virtual void settle(Substep<D>&) {}
  /// Called when velocities are known.
  virtual void end(Substep<D>&) {}
  /// Called when the particles are done. Objects outside of the device, if any, receive their impulses and
  /// advance by the substep.
  virtual bool exchanges() const { return false; }
  virtual void exchange(Substep<D>&) {}

  // Around the substeps of a step, for objects outside of the device: undo_step() restores their state at
  // start_step(), also if that threw. When end_step() is called, the device still works on the last substep.
  virtual void start_step() {}
  virtual void end_step() {}
  virtual void undo_step() {}

  /// Whether cells that are apart need entries of their own in the table of cells. Otherwise they may share
  /// them where the particles are spread thinly.
  virtual bool needs_own_cells() const { return false; }

  /// When the device has finished the step: whether everything found had room. If not, make_room() is called,
  /// and the step is repeated.
  virtual bool had_room() const { return true; }
  virtual void make_room() {}
};

/// Changes velocities after the constraints.
template <class D>
class VelocityPass {
 public:
  virtual ~VelocityPass() = default;
  /// May flip the particles' velocity buffers; it takes its views from `particles`.
  virtual void apply(Substep<D>& substep, Particles& particles) = 0;
  /// See ParticleState.
  virtual void reserve(uint32_t /*capacity*/) {}
};

/// Reads a finished substep.
template <class D>
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void start_step() {}
  virtual void observe(const Substep<D>& substep) = 0;
};

/// Motions to be checked.
struct MotionView {
  View<const Vec4> from;
  View<Vec4> to;
  View<Vec4> accumulated_delta;  ///< a limited motion adds its correction, where there is a view
  View<const Phase> phase;
  uint32_t count = 0;
  uint32_t sorted = 0;  ///< see ParticleView
};

/// Finds contacts. First it keeps fast particles from passing through solids. Then it counts the contacts of
/// each particle, in sorted order, and writes them.
template <class D>
class ContactSource {
 public:
  virtual ~ContactSource() = default;
  virtual void reserve(uint32_t /*particles*/) {}
  /// Whether any contacts are possible.
  virtual bool any() const = 0;
  /// Whether its solids may move.
  virtual bool any_moving() const { return false; }
  /// Whether solids other than half-spaces may limit a motion.
  virtual bool limits_motion() const { return false; }
  /// Limits each motion that would pass through a fixed solid. Before the contact search, planes of
  /// half-spaces need no limit, as the search finds particles behind them as well. `planes_too` is for after
  /// the solve.
  virtual void limit_motion(const MotionView& /*motion*/, bool /*planes_too*/) {}
  /// Adds the number of contacts of each particle; of all particles, including those with none, if it counts
  /// all.
  virtual void count(const Substep<D>& substep, const ContactCounter& counter) = 0;
  virtual bool counts_all() const { return false; }
  /// Writes as many contacts of each particle as it counted.
  virtual void fill(const Substep<D>& substep, const ContactWriter& writer) = 0;
  /// Removes entries from the neighbour lists if a thin solid lies between the two particles.
  virtual void part_neighbours(const Substep<D>& /*substep*/) {}
};

}  // namespace meniscus::pbd
