// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The definitions of all that is in a world, as text.
#pragma once

#include <string>

#include "sdk/world/state/world_tables.h"

namespace meniscus {

/// The definitions of a world, read from a file.
struct Definitions {
  WorldDef world;
  std::vector<std::optional<ParticleMaterial>> fluids;  ///< by index, like the lists below
  std::vector<std::optional<ShapeDef>> shapes;
  std::vector<std::optional<BodyDef>> bodies;
  std::vector<std::optional<JointDef>> joints;
  std::vector<std::optional<EmitterDef>> emitters;
  std::vector<std::optional<SinkDef>> sinks;
  std::vector<std::optional<ProbeDef>> probes;
  std::vector<std::optional<ForceFieldDef>> force_fields;
  std::vector<std::optional<ClothDef>> cloths;
  std::vector<std::optional<RopeDef>> ropes;
  std::vector<std::optional<AttachmentDef>> attachments;
};

/// As JSON. Ids in definitions have generations that count from 0.
std::string definitions_text(const WorldTables& tables);
WorldDef read_world_def(const std::string& text);
/// Of the others. `first_generation`: of the world that is to have them. Throws Error(io) if something is
/// missing or has another type; values are checked where things are made.
Definitions read_definitions(const std::string& text, uint32_t first_generation);

}  // namespace meniscus
