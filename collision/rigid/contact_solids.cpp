// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The parts of solids whose contacts a device solves (collision/rigid_contact/).
#include <meniscus/error.h>

#include <cassert>

#include "collision/rigid/rigid_impl.h"

namespace meniscus::collision {

namespace {

[[noreturn]] void refuse_part(const char* what) {
  throw Error(ErrorCode::invalid_argument,
              std::string("RigidSolverDef::solver is device, which has no ") + what +
                  " among solids, only boxes, spheres, capsules, planes and hulls; bullet has all");
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
    case RigidPart::Kind::cylinder:
      refuse_part("cylinders");
    case RigidPart::Kind::height_field:
      refuse_part("height fields");
    case RigidPart::Kind::hull:
    case RigidPart::Kind::mesh:
      break;
  }
  refuse_part("meshes");
}

void add_hull(ContactSolid& solid, const RigidPart& part, std::shared_ptr<const ContactHull> hull) {
  ContactPart made;
  made.pose = part.pose * Pose{hull->centre, {0, 0, 0, 1}};
  made.shape = {ConvexKind::hull, hull->half, static_cast<uint32_t>(solid.hulls.size()), hull->radius};
  solid.hulls.push_back(std::move(hull));
  solid.parts.push_back(made);
}

/// Lists the parts of all solids, and each hull once.
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
      if (part.shape.kind == ConvexKind::hull) part.shape.hull = number_of(own.hulls[part.shape.hull]);
      all_.parts.push_back(part);
    }
  }
  const ContactSolid& all() const { return all_; }

 private:
  uint32_t number_of(const std::shared_ptr<const ContactHull>& hull) {
    const auto [at, is_new] = numbers_.emplace(hull.get(), static_cast<uint32_t>(all_.hulls.size()));
    if (is_new) all_.hulls.push_back(hull);
    return at->second;
  }

  ContactSolid all_;
  std::unordered_map<const ContactHull*, uint32_t> numbers_;
};

constexpr uint64_t fixed_key = uint64_t{1} << 32;  // of fixed solids, whose keys come after those of bodies

}  // namespace

RigidRef solid_of_key(uint64_t key) {
  return {(key >> 16 & fixed_key) == 0, static_cast<uint32_t>(key >> 16)};
}

/// Solids that share a mesh share its hull.
std::shared_ptr<const ContactHull> RigidWorld::Impl::hull_of(
    const std::shared_ptr<const TriangleMesh>& mesh) {
  HullOfMesh& known = hulls[mesh.get()];
  std::shared_ptr<const ContactHull> hull = known.hull.lock();
  // Another mesh may have had this address.
  if (hull && known.mesh.lock() == mesh) return hull;
  hull = std::make_shared<const ContactHull>(make_contact_hull(mesh->vertices));
  known = {mesh, hull};
  return hull;
}

ContactSolid RigidWorld::Impl::contact_solid(const RigidSolid& solid) {
  if (!def.on_device) return {};
  if (solid.parts.size() > 1u << 16) refuse_part("solids of more than 65536 parts");
  ContactSolid made;
  for (const RigidPart& part : solid.parts) {
    if (part.kind == RigidPart::Kind::hull)
      add_hull(made, part, hull_of(part.mesh));
    else
      made.parts.push_back(contact_part(part));
  }
  return made;
}

void RigidWorld::Impl::update_parts() {
  assert(contacts);
  if (!parts_changed) return;
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
