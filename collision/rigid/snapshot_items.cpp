// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A snapshot of a rigid world as items with names, for files. Pointers become numbers.
#include <meniscus/error.h>

#include "collision/rigid/columns.h"
#include "collision/rigid/rigid_snapshot.h"

namespace meniscus::collision {

namespace {

struct BodyFields {
  template <class V>
  void operator()(const V& v, SavedBody& b) const {
    v("pose", b.pose);
    v("interpolated", b.interpolated);
    v("detected", b.detected);
    v("velocity", b.velocity);
    v("angular_velocity", b.angular_velocity);
    v("interpolated_velocity", b.interpolated_velocity);
    v("interpolated_angular_velocity", b.interpolated_angular_velocity);
    v("idle_time", b.idle_time);
    v("activation", b.activation);
    v("force", b.memory.force);
    v("torque", b.memory.torque);
    v("usual_force", b.memory.usual_force);
    v("usual_torque", b.memory.usual_torque);
    v("kinematic_pose", b.memory.pose);
    v("drive", b.memory.drive);
    v("move_from", b.memory.move.from);
    v("move_to", b.memory.move.to);
    v("move_start", b.memory.move.start);
    v("move_duration", b.memory.move.duration);
  }
};

struct DeviceBodyFields {
  template <class V>
  void operator()(const V& v, SavedBody& b) const {
    v("push_work", b.memory.push_work);
    v("free_work", b.memory.free_work);
    v("island", b.memory.island);
  }
};

struct PointFields {
  template <class V>
  void operator()(const V& v, btManifoldPoint& p) const {
    v("local_a", p.m_localPointA);
    v("local_b", p.m_localPointB);
    v("world_b", p.m_positionWorldOnB);
    v("world_a", p.m_positionWorldOnA);
    v("normal", p.m_normalWorldOnB);
    v("distance", p.m_distance1);
    v("friction", p.m_combinedFriction);
    v("rolling_friction", p.m_combinedRollingFriction);
    v("spinning_friction", p.m_combinedSpinningFriction);
    v("restitution", p.m_combinedRestitution);
    v("part_0", p.m_partId0);
    v("part_1", p.m_partId1);
    v("index_0", p.m_index0);
    v("index_1", p.m_index1);
    v("flags", p.m_contactPointFlags);
    v("impulse", p.m_appliedImpulse);
    v("previous_right_side", p.m_prevRHS);
    v("lateral_impulse_1", p.m_appliedImpulseLateral1);
    v("lateral_impulse_2", p.m_appliedImpulseLateral2);
    v("motion_1", p.m_contactMotion1);
    v("motion_2", p.m_contactMotion2);
    v("softness", p.m_contactCFM);
    v("error_reduction", p.m_contactERP);
    v("friction_softness", p.m_frictionCFM);
    v("life_time", p.m_lifeTime);
    v("lateral_1", p.m_lateralFrictionDir1);
    v("lateral_2", p.m_lateralFrictionDir2);
  }
};

struct PairFields {
  template <class V>
  void operator()(const V& v, SavedPair& p) const {
    v("a", p.a);
    v("b", p.b);
    v("has_algorithm", p.has_algorithm);
  }
};

struct ManifoldFields {
  template <class V>
  void operator()(const V& v, SavedManifold& m) const {
    v("index", m.index);
    v("points", m.points);
  }
};

struct BoundsFields {
  template <class V>
  void operator()(const V& v, RigidBroadphase::Bounds& b) const {
    static constexpr const char* first[] = {"first_x", "first_y", "first_z"};
    static constexpr const char* last[] = {"last_x", "last_y", "last_z"};
    v("lower", b.lower);
    v("upper", b.upper);
    for (int axis = 0; axis < 3; ++axis) {
      v(first[axis], b.first[axis]);
      v(last[axis], b.last[axis]);
    }
  }
};

struct EdgeFields {
  template <class V>
  void operator()(const V& v, RigidBroadphase::PlainEdge& e) const {
    v("position", e.position);
    v("proxy", e.proxy);
  }
};

struct PredictionFields {
  template <class V>
  void operator()(const V& v, SavedPrediction& p) const {
    v("a", p.a);
    v("b", p.b);
    v("points", p.points);
  }
};

struct ContactFields {
  template <class V>
  void operator()(const V& v, SavedContact& c) const {
    v("key_a", c.key_a);
    v("key_b", c.key_b);
    v("feature", c.feature);
    v("pressure", c.pressure);
    v("friction", c.friction);
    v("position", c.position);
    v("normal", c.normal);
    v("distance", c.distance);
    v("impulse", c.impulse);
  }
};

template <class Record, class Fields>
struct Columns {
  std::vector<Record>& records;
  Fields fields;

  void visit_state(pbd::StateVisitor& v) { visit_columns(v, records, fields); }
};

template <class Record, class Fields>
void visit(pbd::StateVisitor& v, const char* name, std::vector<Record>& records, const Fields& fields) {
  Columns<Record, Fields> columns{records, fields};
  v.part(name, columns);
}

[[noreturn]] void refuse(const char* what) {
  throw Error(ErrorCode::io, std::string("the saved ") + what + " of solids do not fit one another");
}

}  // namespace

/// The broad phase's lists as its own code leaves them. What it would not do is refused here, as Bullet
/// follows the indices without a look.
void RigidWorld::expect_valid(const Snapshot& s) const {
  if (s.bodies.size() != body_count()) refuse("states");
  const auto room = static_cast<int64_t>(impl_->broadphase.room());
  for (const SavedPair& p : s.pairs) {
    if (p.a < 1 || p.b < 1 || p.a >= room || p.b >= room || p.a == p.b) refuse("pairs");
    if (!impl_->broadphase.has(p.a) || !impl_->broadphase.has(p.b)) refuse("pairs");
  }
  int64_t points = 0;
  for (const SavedManifold& m : s.manifolds) {
    if (m.index < 0 || m.points < 0 || m.points > MANIFOLD_CACHE_SIZE) refuse("contacts");
    points += m.points;
  }
  if (points != static_cast<int64_t>(s.points.size())) refuse("contacts");
  int64_t predicted = 0;
  for (const SavedPrediction& p : s.predictions) {
    if (!impl_->object(p.a) || !impl_->object(p.b)) refuse("predictions");
    if (p.points < 0 || p.points > MANIFOLD_CACHE_SIZE) refuse("predictions");
    predicted += p.points;
  }
  if (predicted != static_cast<int64_t>(s.predicted_points.size())) refuse("predictions");
  if (!impl_->broadphase.suits(s.broadphase)) refuse("places in the broad phase");
}

void RigidWorld::visit_snapshot(Snapshot& s, pbd::StateVisitor& v) const {
  v.value("time", s.time);
  visit(v, "body", s.bodies, BodyFields{});
  visit(v, "pair", s.pairs, PairFields{});
  visit(v, "manifold", s.manifolds, ManifoldFields{});
  visit(v, "point", s.points, PointFields{});
  visit(v, "prediction", s.predictions, PredictionFields{});
  visit(v, "predicted_point", s.predicted_points, PointFields{});
  visit(v, "bounds", s.broadphase.bounds, BoundsFields{});
  if (impl_->def.on_device) {
    visit(v, "device_body", s.bodies, DeviceBodyFields{});
    visit(v, "device_contact", s.on_device, ContactFields{});
    visit(v, "resting_contact", s.resting, ContactFields{});
  }
  static constexpr const char* axes[] = {"edge_x", "edge_y", "edge_z"};
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<RigidBroadphase::PlainEdge> edges = RigidBroadphase::plain(s.broadphase.edges[axis]);
    visit(v, axes[axis], edges, EdgeFields{});
    if (v.restores()) s.broadphase.edges[axis] = RigidBroadphase::edges_of(edges);
  }
  v.value("first_free", s.broadphase.first_free);
  if (v.restores()) expect_valid(s);
}

}  // namespace meniscus::collision
