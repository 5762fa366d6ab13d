// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What a world knows on the host. A snapshot holds a copy of all of it.
#pragma once

#include <meniscus/world.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sdk/engine/engine.h"
#include "sdk/world/check/id_table.h"
#include "sdk/world/check/origin.h"
#include "sdk/world/check/world_number.h"
#include "sdk/world/cloth/cloth_table.h"
#include "sdk/world/flow/world_flow.h"
#include "sdk/world/solids/world_shapes.h"

namespace meniscus {

struct ShapeEntry {
  ShapeDef def;
  SolidPieces solid;
};

struct BodyEntry {
  BodyDef def;
  SolidPieces solid;
  Pose principal;  ///< the frame that the rigid world moves, in the geometry's frame
  BodyMass mass;
};

/// The state of a world on the host. What is not here belongs to a device or to Bullet, or can be made again
/// at any time.
struct WorldTables {
  explicit WorldTables(const WorldDef& world_def)
      : given(world_def), origin(given.origin), def(origin.inward(given)) {}

  WorldDef given;  ///< as the user has it
  Origin origin;
  WorldDef def;              ///< the same in the frame about the origin
  float air_density = 1.2f;  ///< kg/m³, of the wind
  double time = 0;
  float last_substep = 0;

  std::shared_ptr<const WorldNumber> world_number = std::make_shared<WorldNumber>();
  uint32_t first_generation = world_number->first_generation();
  IdTable<FluidId, ParticleMaterial> fluids{"fluid", first_generation};  ///< and granular materials
  IdTable<ShapeId, ShapeEntry> shapes{"shape", first_generation};
  IdTable<BodyId, BodyEntry> bodies{"body", first_generation};
  IdTable<JointId, JointDef> joints{"joint", first_generation};
  /// Differs where solids or joints were created, destroyed or set in between. Not in files.
  uint64_t solids_revision = 0;
  std::vector<MeshRepair> mesh_repairs;
  bool solids_are_on_device = true;            ///< shapes and bodies
  std::vector<collision::RigidTouch> touches;  ///< after the last step
  std::vector<ContactEvent> events;            ///< of the last step
  std::vector<uint8_t> awake;                  ///< by the index of bodies, after the last step
  std::vector<SleepEvent> sleeps;              ///< of the last step
  IdTable<EmitterId, EmitterEntry> emitters{"emitter", first_generation};
  IdTable<SinkId, SinkEntry> sinks{"sink", first_generation};
  bool sinks_are_carried = false;  ///< a body carries at least one sink
  std::vector<uint32_t> taken;     ///< by sink, in the last step
  std::vector<FlowEvent> flows;    ///< of the last step
  IdTable<ProbeId, ProbeDef> probes{"probe", first_generation};
  IdTable<ForceFieldId, ForceFieldDef> force_fields{"force field", first_generation};
  bool forces_are_on_device = true;
  // Each creation that uploads all before it would make many of them quadratic. So the next use uploads.
  bool materials_are_on_device = false, probes_are_on_device = false, sinks_are_on_device = true;
  std::vector<fluid::ProbeSum> probe_sums;    ///< in the order of the probes
  std::vector<fluid::ProbeSum> probe_values;  ///< by the index of their ids

  IdTable<ClothId, ClothEntry> cloths{"cloth", first_generation};
  IdTable<RopeId, RopeEntry> ropes{"rope", first_generation};
  IdTable<AttachmentId, AttachmentEntry> attachments{"attachment", first_generation};
  bool cloth_is_on_device = true;  ///< all of it, in its present state
  bool cloth_is_on_host = true;    ///< its latest state
  /// As it was last uploaded. It depends on when that was: water has changed masses since.
  std::shared_ptr<const EngineCloth> uploaded_cloth;
  uint32_t vertex_count = 0;            ///< on the device
  std::vector<ClothId> pieces;          ///< on the device, by number; ropes have no id here
  std::vector<uint32_t> held;           ///< vertices on the device, ascending
  std::vector<ClothId> touched_pieces;  ///< the pieces of the last step
  bool reactions_known = true;
  uint32_t planned_drips = 0;    ///< number of drips with room in this step
  float last_step = 0;           ///< s
  std::vector<TearEvent> tears;  ///< of the last step

  uint64_t crowding_bound = 0;  ///< see check_crowding
  ParticleId next_id = 0;
  std::vector<ParticleId> ids;  ///< by slot, ascending
};

}  // namespace meniscus
