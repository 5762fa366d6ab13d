// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What a snapshot of a rigid world holds.
#pragma once

#include <vector>

#include "collision/rigid/rigid_impl.h"

namespace meniscus::collision {

struct SavedBody {
  btTransform pose, interpolated, detected;
  btVector3 velocity, angular_velocity, interpolated_velocity, interpolated_angular_velocity;
  float idle_time;  ///< s
  int activation;
  RigidMemory memory;
};

struct SavedPair {
  int a, b;                ///< ids of the proxies
  uint32_t has_algorithm;  ///< 1: it has one
};

struct SavedManifold {
  int index, points;
};

/// A predicted contact of two solids, as their codes (RigidLayout::objects).
struct SavedPrediction {
  uint32_t a, b;
  int points;
};

struct RigidWorld::Snapshot {
  std::vector<SavedBody> bodies;
  std::vector<SavedPair> pairs;
  std::vector<SavedManifold> manifolds;
  std::vector<btManifoldPoint> points;
  std::vector<SavedPrediction> predictions;
  std::vector<btManifoldPoint> predicted_points;
  RigidBroadphase::State broadphase;
  bool is_kept = false;  ///< contacts on the device stay there; `on_device` has nothing
  std::vector<SavedContact> on_device, resting;
  double time = 0;
};

}  // namespace meniscus::collision
