// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <meniscus/types.h>

#include "pbd/contacts.h"
#include "pbd/grid.h"
#include "pbd/neighbours.h"
#include "pbd/particles.h"

namespace meniscus::pbd {

/// What a substep lends to the constraint sets and velocity passes.
template <class D>
struct Substep {
  D& device;
  ParticleView particles;
  NeighbourView neighbours;
  ContactView contacts;
  float dt = 0;  ///< s
  int iterations = 0;
  Vec3 gravity{0, 0, 0};  ///< m/s²
  GridView grid{};        ///< the cells that particles of fluids are sorted by, as they were predicted
  bool is_last = false;   ///< of its step
  /// By vertex of cloth, where bodies may be carried, in an iteration; w: the mass that stands behind it, kg;
  /// and what chains have pressed that with, kg·m. See collision::EffectiveMass.
  View<Vec4> effective_mass{};
  /// Where fluid may lie on cloth: at v and v + 1 the same number, if none is near vertex v.
  View<const uint32_t> fluid_near{};
  /// In an iteration: what moved particles last has held them at their contacts as well.
  bool are_contacts_projected = false;
};

/// Arrays that belong to particles of fluids but live in a set: they follow when particles are sorted, added
/// and removed.
class ParticleState {
 public:
  virtual ~ParticleState() = default;
  /// Room for so many particles of all kinds, as lists of neighbours end with an index behind them; 0 where
  /// there are no fluids. What the first `kept` have stays.
  virtual void reserve(uint32_t /*capacity*/, uint32_t /*kept*/) {}
  virtual void clear(uint32_t /*first*/, uint32_t /*count*/) {}
  /// Element i becomes what was at order[i]: after the particles, and before anything is solved.
  virtual void reorder(View<const uint32_t> /*order*/, uint32_t /*count*/) {}
  virtual void save() {}
  virtual void restore() {}
};

/// One kind of constraint, for all particles that it concerns. Sets project in the order of their
/// registration; contacts come after the fluid, bodies last.
template <class D>
class ConstraintSet : public ParticleState {
 public:
  /// m/s, the fastest that this set can move a surface in dt.
  virtual float speed(float /*dt*/) { return 0; }
  /// Nothing is predicted yet: what moves along with the particles is predicted here.
  virtual void predict(float /*dt*/) {}
  /// Room for so many particles that a substep adds for itself, behind all others; one set at most has any.
  virtual uint32_t extra_particles() const { return 0; }
  /// Positions are predicted, and contacts not found yet: adds such particles to substep.particles.owned.
  virtual void arrange(Substep<D>&) {}
  /// Whether prepare() has anything to do.
  virtual bool prepares() const { return false; }
  /// Likewise, for what needs no more than that, and changes nothing that contacts are found by: a GPU finds
  /// them at the same time. Not while overlaps are relaxed.
  virtual void prepare(Substep<D>&) {}
  /// Neighbours and contacts are known: forces change velocities, and what was predicted with them. Not while
  /// overlaps are relaxed.
  virtual void accelerate(Substep<D>&) {}
  /// Nothing is solved yet.
  virtual void begin(Substep<D>&) {}
  /// One iteration: moves particles.position towards C(p) = 0.
  virtual void project(Substep<D>&, int iteration) = 0;
  /// Positions are final, velocities are not known yet.
  virtual void settle(Substep<D>&) {}
  /// Velocities are known.
  virtual void end(Substep<D>&) {}
  /// The particles are done. What lives outside of the device, if anything does, takes its share, and is
  /// advanced by the substep.
  virtual bool exchanges() const { return false; }
  virtual void exchange(Substep<D>&) {}

  // Around the substeps of a step, for what lives outside of the device: undo_step() takes it back to
  // start_step(). When end_step() is called, the device still works on the last substep.
  virtual void start_step() {}
  virtual void end_step() {}
  virtual void undo_step() {}

  /// Asked when the step's work is done on the device: whether all that it found had room. Where it had not,
  /// make_room() is called, and the step is done again.
  virtual bool had_room() { return true; }
  virtual void make_room() {}
};

/// Something that changes velocities after the constraints.
template <class D>
class VelocityPass {
 public:
  virtual ~VelocityPass() = default;
  /// May flip the particles' velocity buffers: takes its views from `particles`.
  virtual void apply(Substep<D>& substep, Particles& particles) = 0;
  /// See ParticleState.
  virtual void reserve(uint32_t /*capacity*/) {}
};

/// Something that looks at a finished substep.
template <class D>
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void start_step() {}
  virtual void observe(const Substep<D>& substep) = 0;
};

/// Motions that are to be checked.
struct MotionView {
  View<const Vec4> from;
  View<Vec4> to;
  View<Vec4> accumulated_delta;  ///< what takes a motion back is added, where there is a view
  View<const Phase> phase;
  uint32_t count = 0;
  uint32_t sorted = 0;  ///< see ParticleView
};

/// Something that finds contacts: first it keeps fast particles from passing through; then it finds, in
/// sorted order, the number of contacts of each particle, then the contacts themselves.
template <class D>
class ContactSource {
 public:
  virtual ~ContactSource() = default;
  virtual void reserve(uint32_t /*particles*/) {}
  /// Whether there is anything to touch.
  virtual bool any() const = 0;
  /// Whether its solids may move.
  virtual bool any_moving() const { return false; }
  /// Whether anything but half-spaces may cut a motion short.
  virtual bool limits_motion() const { return false; }
  /// Cuts short each motion that would pass through something fixed. Nothing passes through the plane of a
  /// half-space on its way to the contact search, which sees it from behind as well; `planes_too` is for
  /// after the solve.
  virtual void limit_motion(const MotionView& /*motion*/, bool /*planes_too*/) {}
  /// Adds the number of contacts of each particle; of all of them, if only nothing, where it counts all.
  virtual void count(const Substep<D>& substep, const ContactCounter& counter) = 0;
  virtual bool counts_all() const { return false; }
  /// Writes as many contacts of each particle as it counted.
  virtual void fill(const Substep<D>& substep, const ContactWriter& writer) = 0;
  /// Takes those out of the lists of neighbours that something thin stands between.
  virtual void part_neighbours(const Substep<D>& /*substep*/) {}
};

}  // namespace meniscus::pbd
