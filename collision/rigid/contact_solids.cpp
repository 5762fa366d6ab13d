// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The parts of solids whose contacts a device solves (collision/rigid_contact/).
#include <meniscus/error.h>

#include <algorithm>
#include <cassert>

#include "collision/rigid/rigid_impl.h"

namespace meniscus::collision {

namespace {

[[noreturn]] void refuse_part(const char* what) {
  throw Error(ErrorCode::invalid_argument, std::string("RigidSolverDef::solver is device, which has no ") +
                                               what + " among solids; bullet has them");
}

/// The shortest rotation that takes the y axis to a unit normal.
Quat turn_up_to(Vec3 normal) {
  if (normal.y < -0.9999f) return {1, 0, 0, 0};
  return normalized(Quat{normal.z, 0, -normal.x, 1 + normal.y});
}

/// A part in the geometry's frame.
ContactPart contact_part(const RigidPart& part) {
  ContactPart made;
  made.pose = part.pose;
  switch (part.kind) {
    case RigidPart::Kind::box:
      made.shape = {ConvexKind::box, part.size};
      return made;
    case RigidPart::Kind::sphere:
      made.shape = {ConvexKind::sphere, {part.size.x, 0, 0}};
      return made;
    case RigidPart::Kind::capsule:
      made.shape = {ConvexKind::capsule, {part.size.x, part.size.y, 0}};
      return made;
    case RigidPart::Kind::plane:
      made.shape = {ConvexKind::plane, {0, 0, 0}};
      made.pose = part.pose * Pose{part.offset * part.size, turn_up_to(part.size)};
      return made;
    case RigidPart::Kind::hull:
    case RigidPart::Kind::mesh:
    case RigidPart::Kind::height_field:
      assert(false);  // they have tables
      break;
    case RigidPart::Kind::cylinder:
      break;
  }
  refuse_part("cylinders");
}

void add_hull(ContactSolid& solid, const RigidPart& part, std::shared_ptr<const ContactHull> hull) {
  ContactPart made;
  made.pose = part.pose * Pose{hull->centre, {0, 0, 0, 1}};
  made.shape = {ConvexKind::hull, hull->half, static_cast<uint32_t>(solid.hulls.size()), hull->radius};
  solid.hulls.push_back(std::move(hull));
  solid.parts.push_back(made);
}

void add_ground(ContactSolid& solid, const RigidPart& part, std::shared_ptr<const ContactGround> ground) {
  ContactPart made;
  made.pose = part.pose * Pose{ground->centre, {0, 0, 0, 1}};
  made.shape = {ConvexKind::ground, ground->half, static_cast<uint32_t>(solid.grounds.size())};
  solid.grounds.push_back(std::move(ground));
  solid.parts.push_back(made);
}

/// The surface of a height field. It has no sides and no bottom.
TriangleMesh surface_of(const HeightFieldGeometry& g) {
  TriangleMesh mesh;
  const auto columns = static_cast<uint32_t>(g.columns), rows = static_cast<uint32_t>(g.rows);
  const auto at = [&](uint32_t n, uint32_t count) {
    return g.cell_size * (static_cast<float>(n) - 0.5f * static_cast<float>(count - 1));
  };
  for (uint32_t j = 0; j < rows; ++j)
    for (uint32_t i = 0; i < columns; ++i)
      mesh.vertices.push_back({at(i, columns), g.heights[j * columns + i], at(j, rows)});
  for (uint32_t j = 0; j + 1 < rows; ++j) {
    for (uint32_t i = 0; i + 1 < columns; ++i) {
      const uint32_t a = j * columns + i, b = a + columns, c = a + 1;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({c, b, b + 1});
    }
  }
  return mesh;
}

/// Lists the parts of all solids, and each hull and ground once.
class PartList {
 public:
  /// With the surface, filter and pose of today.
  void add(const ContactSolid& own, const btRigidBody& bullet, const Pose& frame, uint64_t solid,
           uint32_t body) {
    for (size_t k = 0; k < own.parts.size(); ++k) {
      ContactPart part = own.parts[k];
      part.pose = frame * part.pose;
      part.body = body;
      part.friction = bullet.getFriction();
      part.restitution = bullet.getRestitution();
      part.groups = static_cast<uint32_t>(bullet.getBroadphaseHandle()->m_collisionFilterGroup);
      part.mask = static_cast<uint32_t>(bullet.getBroadphaseHandle()->m_collisionFilterMask);
      part.key = solid << 16 | k;
      if (part.shape.kind == ConvexKind::hull)
        part.shape.table = number_of(own.hulls[part.shape.table], all_.hulls);
      if (part.shape.kind == ConvexKind::ground)
        part.shape.table = number_of(own.grounds[part.shape.table], all_.grounds);
      all_.parts.push_back(part);
    }
  }
  const ContactSolid& all() const { return all_; }

 private:
  template <class T>
  uint32_t number_of(const std::shared_ptr<const T>& table, std::vector<std::shared_ptr<const T>>& all) {
    const auto [at, is_new] = numbers_.emplace(table.get(), static_cast<uint32_t>(all.size()));
    if (is_new) all.push_back(table);
    return at->second;
  }

  ContactSolid all_;
  std::unordered_map<const void*, uint32_t> numbers_;
};

constexpr uint64_t fixed_key = uint64_t{1} << 32;  // of fixed solids, whose keys come after those of bodies

}  // namespace

RigidRef solid_of_key(uint64_t key) {
  return {(key >> 16 & fixed_key) == 0, static_cast<uint32_t>(key >> 16)};
}

ContactSolid RigidWorld::Impl::contact_solid(const RigidSolid& solid) {
  if (!def.on_device) return {};
  if (solid.parts.size() > 1u << 16) refuse_part("solids of more than 65536 parts");
  ContactSolid made;
  for (const RigidPart& part : solid.parts) {
    if (part.kind == RigidPart::Kind::hull)
      add_hull(made, part,
               hulls.of(part.mesh, [](const TriangleMesh& m) { return make_contact_hull(m.vertices); }));
    else if (part.kind == RigidPart::Kind::mesh)
      add_ground(made, part, grounds.of(part.mesh, make_contact_ground));
    else if (part.kind == RigidPart::Kind::height_field)
      add_ground(made, part,
                 std::make_shared<const ContactGround>(make_contact_ground(surface_of(part.heights))));
    else
      made.parts.push_back(contact_part(part));
  }
  return made;
}

bool RigidWorld::Impl::is_removed(const RigidRef& solid) const {
  return std::ranges::any_of(removed, [&](const RigidRef& other) {
    return other.is_body == solid.is_body && other.number == solid.number;
  });
}

/// Another solid may have the number of one that was removed.
void RigidWorld::Impl::drop_contacts_of_removed() {
  if (removed.empty()) return;
  const auto is_stale = [&](const SavedContact& c) {
    return is_removed(solid_of_key(c.key_a)) || is_removed(solid_of_key(c.key_b));
  };
  std::vector<SavedContact> kept = contacts->save();
  std::erase_if(kept, is_stale);
  contacts->restore(kept);
  std::erase_if(resting, is_stale);
  removed.clear();
}

void RigidWorld::Impl::update_parts() {
  assert(contacts);
  if (!parts_changed) return;
  drop_contacts_of_removed();
  PartList list;
  for (uint32_t n = 0; n < bodies.slots.size(); ++n) {
    if (!bodies.has(n)) continue;
    const RigidBodyRecord& body = *bodies.slots[n];
    list.add(body.contact, *body.bullet, inverse(body.shape.frame), n, n);
  }
  for (uint32_t n = 0; n < fixed.slots.size(); ++n) {
    if (!fixed.has(n)) continue;
    const RigidFixedRecord& solid = *fixed.slots[n];
    const Pose pose = from_bullet(solid.bullet->getWorldTransform()) * inverse(solid.shape.frame);
    list.add(solid.contact, *solid.bullet, pose, fixed_key | n, pbd::no_index);
  }
  contacts->set_parts(list.all());
  parts_changed = false;
}

}  // namespace meniscus::collision
