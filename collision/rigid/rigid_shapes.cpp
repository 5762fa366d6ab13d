// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Shapes for Bullet. It rounds the edges of most shapes by a margin, 4 cm by default. Here the margin is a
// fraction of the shape's own size, and shapes are shrunk by it first, so that their size stays.
#include "collision/rigid/rigid_shapes.h"

#include <LinearMath/btConvexHullComputer.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "collision/mesh/hull.h"
#include "collision/rigid/rays.h"
#include "collision/rigid/tuning.h"
#include "pbd/math/vec.h"

namespace meniscus::collision {

namespace {

[[maybe_unused]] bool is_fixed_kind(RigidPart::Kind kind) {
  return kind == RigidPart::Kind::mesh || kind == RigidPart::Kind::height_field ||
         kind == RigidPart::Kind::plane;
}

/// Adds a new object to the parts that a shape owns.
template <class T, class... Arguments>
T* keep(RigidShape& shape, Arguments&&... arguments) {
  auto made = std::make_unique<T>(std::forward<Arguments>(arguments)...);
  T* const raw = made.get();
  shape.shapes.push_back(std::move(made));
  return raw;
}

/// Directions distributed evenly over the sphere, along a Fibonacci spiral.
std::vector<Vec3> even_directions(int count) {
  std::vector<Vec3> directions;
  for (int i = 0; i < count; ++i) {
    const float z = 1 - (2 * static_cast<float>(i) + 1) / static_cast<float>(count);
    const float turn = 2.39996323f * static_cast<float>(i), r = std::sqrt(1 - z * z);
    directions.push_back({r * std::cos(turn), r * std::sin(turn), z});
  }
  return directions;
}

/// The points that are outermost in some of many directions.
std::vector<Vec3> outermost(const std::vector<Vec3>& points) {
  std::vector<size_t> picked;
  for (const Vec3 d : even_directions(rigid_tuning::most_hull_points)) {
    const auto further = [d](Vec3 a, Vec3 b) { return dot(d, a) < dot(d, b); };
    picked.push_back(static_cast<size_t>(std::ranges::max_element(points, further) - points.begin()));
  }
  std::ranges::sort(picked);
  std::vector<Vec3> kept;
  for (size_t i = 0; i < picked.size(); ++i) {
    if (i == 0 || picked[i] != picked[i - 1]) kept.push_back(points[picked[i]]);
  }
  return kept;
}

/// The hull's points, in the frame that it gets.
std::vector<Vec3> hull_points(const RigidPart& part, const Pose& frame) {
  std::vector<Vec3> points = hull_mesh(part.mesh->vertices).vertices;
  if (points.size() > rigid_tuning::most_hull_points) points = outermost(points);
  const Pose placed = inverse(frame) * part.pose;
  for (Vec3& p : points) p = to_world(placed, p);
  return points;
}

/// The faces of a hull, moved out by the margin that it was shrunk by.
HullPlanes planes_of(const btConvexHullComputer& hull, float margin) {
  HullPlanes made;
  for (int face = 0; face < hull.faces.size(); ++face) {
    const btConvexHullComputer::Edge* edge = &hull.edges[hull.faces[face]];
    const btVector3& a = hull.vertices[edge->getSourceVertex()];
    const btVector3& b = hull.vertices[edge->getTargetVertex()];
    const btVector3& c = hull.vertices[edge->getNextEdgeOfFace()->getTargetVertex()];
    const btVector3 normal = (b - a).cross(c - a).normalized();
    made.planes.push_back({normal, normal.dot(a) + margin});
  }
  return made;
}

btConvexShape* make_hull(RigidShape& shape, const std::vector<Vec3>& points) {
  Aabb box{points[0], points[0]};
  for (const Vec3 p : points) box = {min(box.lower, p), max(box.upper, p)};
  const Vec3 half = 0.5f * (box.upper - box.lower);
  const float wanted = rigid_tuning::margin * pbd::min(half.x, pbd::min(half.y, half.z));
  btConvexHullComputer hull;
  const float margin = hull.compute(&points[0].x, sizeof(Vec3), static_cast<int>(points.size()), wanted,
                                    rigid_tuning::most_shrinkage);
  auto* made = keep<btConvexHullShape>(shape, &hull.vertices[0].x(), hull.vertices.size(),
                                       static_cast<int>(sizeof(btVector3)));
  made->setMargin(margin);
  made->recalcLocalAabb();  // computed before with the default margin
  auto planes = std::make_shared<HullPlanes>(planes_of(hull, margin));
  made->setUserPointer(planes.get());
  shape.data.push_back(std::move(planes));
  return made;
}

btConvexShape* make_box(RigidShape& shape, Vec3 half) {
  auto* box = keep<btBoxShape>(shape, to_bullet(half));
  box->setMargin(rigid_tuning::margin * pbd::min(half.x, pbd::min(half.y, half.z)));
  return box;
}

btConvexShape* make_cylinder(RigidShape& shape, Vec3 size) {
  auto* cylinder = keep<btCylinderShape>(shape, btVector3{size.x, size.y, size.x});
  cylinder->setMargin(rigid_tuning::margin * pbd::min(size.x, size.y));
  return cylinder;
}

btCollisionShape* make_mesh(RigidShape& shape, const std::shared_ptr<const TriangleMesh>& mesh) {
  auto data = std::make_unique<btTriangleIndexVertexArray>();
  btIndexedMesh part;
  part.m_numTriangles = static_cast<int>(mesh->triangles.size());
  part.m_triangleIndexBase = reinterpret_cast<const unsigned char*>(mesh->triangles.data());
  part.m_triangleIndexStride = sizeof(mesh->triangles[0]);
  part.m_numVertices = static_cast<int>(mesh->vertices.size());
  part.m_vertexBase = reinterpret_cast<const unsigned char*>(mesh->vertices.data());
  part.m_vertexStride = sizeof(Vec3);
  part.m_vertexType = PHY_FLOAT;
  data->addIndexedMesh(part);
  auto* made = keep<btBvhTriangleMeshShape>(shape, data.get(), true);
  made->setMargin(0);
  made->setUserPointer(const_cast<TriangleMesh*>(mesh.get()));
  shape.meshes.push_back(std::move(data));
  shape.data.push_back(mesh);
  return made;
}

/// Bullet puts the mean of the lowest and the highest sample at the origin.
float height_field_middle(const HeightFieldGeometry& field) {
  const auto [low, high] = std::ranges::minmax(field.heights);
  return 0.5f * (low + high);
}

btCollisionShape* make_height_field(RigidShape& shape, const HeightFieldGeometry& field) {
  auto heights = std::make_shared<std::vector<float>>(field.heights);
  const auto [low, high] = std::ranges::minmax(*heights);
  auto* made =
      keep<btHeightfieldTerrainShape>(shape, field.columns, field.rows, heights->data(), low, high, 1, false);
  made->setLocalScaling({field.cell_size, 1, field.cell_size});
  made->setMargin(0);
  shape.data.push_back(std::move(heights));
  return made;
}

btCollisionShape* make_part(RigidShape& shape, const RigidPart& part) {
  switch (part.kind) {
    case RigidPart::Kind::box:
      return make_box(shape, part.size);
    case RigidPart::Kind::sphere:
      return keep<btSphereShape>(shape, part.size.x);
    case RigidPart::Kind::capsule:
      return keep<btCapsuleShape>(shape, part.size.x, 2 * part.size.y);
    case RigidPart::Kind::cylinder:
      return make_cylinder(shape, part.size);
    case RigidPart::Kind::hull:
      return make_hull(shape, hull_points(part, part.pose));
    case RigidPart::Kind::mesh:
      return make_mesh(shape, part.mesh);
    case RigidPart::Kind::height_field:
      return make_height_field(shape, part.heights);
    case RigidPart::Kind::plane:
      return keep<btStaticPlaneShape>(shape, to_bullet(part.size), part.offset);
  }
  return nullptr;
}

Pose bullet_pose(const RigidPart& part) {
  if (part.kind != RigidPart::Kind::height_field) return part.pose;
  return part.pose * Pose{{0, height_field_middle(part.heights), 0}, {0, 0, 0, 1}};
}

/// The inertia about the axes of a frame that is rotated against the principal one, if those axes are
/// principal too. So are the axes of any frame of a ball.
std::optional<btVector3> inertia_about(const MassProperties& mass, Quat axes) {
  const btMatrix3x3 turn{to_bullet(conjugate(axes) * mass.axes)};
  const btMatrix3x3 inertia = turn.scaled(to_bullet(mass.inertia)) * turn.transpose();
  const float tolerance = 1e-4f * max_component(mass.inertia);
  for (int i = 0; i < 3; ++i) {
    if (std::fabs(inertia[i][(i + 1) % 3]) > tolerance) return std::nullopt;
  }
  return btVector3{inertia[0][0], inertia[1][1], inertia[2][2]};
}

/// Whether a single part needs no compound, because its frame fits the mass. If so, sets the shape's frame
/// and inertia.
bool fits_alone(RigidShape& shape, const RigidPart& part, const MassProperties& mass) {
  if (length(part.pose.position - mass.centre) > 1e-5f * max_component(part.size)) return false;
  const auto inertia = inertia_about(mass, part.pose.rotation);
  if (!inertia) return false;
  shape.frame = part.pose;
  shape.inertia = *inertia;
  return true;
}

void add_compound(RigidShape& shape, std::span<const RigidPart> parts) {
  // Without a tree: its test differs from the one by which Bullet removes parts. Contacts between the two
  // bounds would depend on history.
  auto* compound = keep<btCompoundShape>(shape, false, static_cast<int>(parts.size()));
  for (const RigidPart& part : parts) {
    btCollisionShape* child = make_part(shape, part);
    compound->addChildShape(to_bullet(inverse(shape.frame) * bullet_pose(part)), child);
  }
  shape.root = compound;
}

void add_root(RigidShape& shape, std::span<const RigidPart> parts, const MassProperties* mass) {
  const RigidPart& first = parts[0];
  if (mass) {
    shape.frame = {mass->centre, mass->axes};
    shape.inertia = to_bullet(mass->inertia);
  }
  if (parts.size() == 1 && !mass) {
    shape.frame = bullet_pose(first);
    shape.root = make_part(shape, first);
  } else if (parts.size() == 1 && first.kind == RigidPart::Kind::hull) {
    shape.root = make_hull(shape, hull_points(first, shape.frame));
  } else if (parts.size() == 1 && fits_alone(shape, first, *mass)) {
    shape.root = make_part(shape, first);
  } else {
    add_compound(shape, parts);
  }
}

}  // namespace

RigidShape make_rigid_shape(std::span<const RigidPart> parts, const MassProperties* mass) {
  assert(!parts.empty());
  assert(!mass || std::ranges::none_of(parts, is_fixed_kind, &RigidPart::kind));
  RigidShape shape;
  shape.inertia.setZero();
  add_root(shape, parts, mass);
  btVector3 lower, upper;
  shape.root->getAabb(btTransform::getIdentity(), lower, upper);
  shape.radius = shape.root->getAngularMotionDisc();
  shape.inner_radius = 0.5f * (upper - lower)[(upper - lower).minAxis()];
  return shape;
}

}  // namespace meniscus::collision
