// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A scene in which everything occurs, as a list of calls that are made one after another.
#pragma once

#include <meniscus/meniscus.h>

#include <functional>
#include <string>
#include <vector>

#include "tests/devices.h"

namespace meniscus::tests {

/// Ids of what the calls have made so far.
struct SceneIds {
  FluidId water, sand;
  ShapeId tank, hull, hills;
  BodyId box, club, door;
  JointId joint;
  ClothId cloth;
  RopeId rope;
  AttachmentId held, tied;
  EmitterId emitter;
  SinkId sink;
  ProbeId probe;
};

/// A call whose definition is made before it, so that only the call itself meets failures.
struct SceneCall {
  std::string name;
  std::function<std::function<void()>(World&, SceneIds&)> prepare;

  void make(World& world, SceneIds& ids) const { prepare(world, ids)(); }
};

WorldDef coupled_world(pbd::DeviceKind device);
/// All calls, of which each succeeds in a world where those before it were made.
std::vector<SceneCall> coupled_calls(int steps);

}  // namespace meniscus::tests
