// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Rigid worlds whose contacts a device solves.
#pragma once

#include "collision/rigid_contact/rigid_contact_set.h"
#include "pbd/device/cpu/cpu_device.h"
#include "tests/many_threads.h"
#include "tests/unit/collision/rigid/scene.h"

namespace meniscus::collision {

struct DeviceWorld {
  pbd::CpuDevice device;
  RigidContactSet<pbd::CpuDevice> contacts{device};
  RigidWorld world;

  explicit DeviceWorld(const RigidWorldDef& def = {.on_device = true}, int threads = 1)
      : device(threads), world(def) {
    world.set_contacts(&contacts);
  }
};

/// Boxes, balls and capsules that fall on one another.
inline void drop_jumble(RigidWorld& world, int count) {
  const RigidPart parts[] = {box_part({0.05f, 0.04f, 0.06f}), round_part(Kind::sphere, 0.05f),
                             round_part(Kind::capsule, 0.03f, 0.04f)};
  for (int n = 0; n < count; ++n) {
    const Vec3 at{0.13f * static_cast<float>(n % 4), 0.1f + 0.13f * static_cast<float>(n / 16),
                  0.13f * static_cast<float>(n / 4 % 4)};
    const Quat turn = about({0.6f, 0, 0.8f}, 0.3f * static_cast<float>(n % 7));
    world.add_body(body_def({parts[n % 3]}, {at, turn}));
  }
}

}  // namespace meniscus::collision
