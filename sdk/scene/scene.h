// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A scene as a file describes it: definitions with names in place of ids, and how to run and look at it.
#pragma once

#include <meniscus/meniscus.h>

#include <optional>
#include <string>
#include <vector>

#include "sdk/scene/scene_check.h"

namespace meniscus {

struct SceneVolume {
  std::string fluid;   ///< FluidDef::name, or GranularDef::name
  FluidVolumeDef def;  ///< its fluid id is filled in when the scene is built
};

struct SceneEmitter {
  std::string fluid;  ///< FluidDef::name
  std::string body;   ///< BodyDef::name, or empty
  EmitterDef def;     ///< its ids are filled in when the scene is built
};

struct SceneSink {
  std::string body;  ///< BodyDef::name, or empty
  SinkDef def;       ///< its body id is filled in when the scene is built
};

struct SceneProbe {
  std::string shape;  ///< ShapeDef::name, or empty
  std::string fluid;  ///< FluidDef::name or GranularDef::name, or empty
  ProbeDef def;       ///< its ids are filled in when the scene is built
};

/// Equal bodies at the points of a lattice.
struct SceneCopies {
  std::vector<int> count{1, 1, 1};  ///< along x, y and z
  Vec3 step{0, 0, 0};               ///< m, from one to the next along each
};

struct SceneBody {
  BodyDef def;                        ///< of the first copy
  std::optional<SceneCopies> copies;  ///< left out, there is one
};

struct SceneJoint {
  std::string a, b;  ///< names of bodies; an empty b is the world
  JointDef def;      ///< its body ids are filled in when the scene is built
};

struct SceneAttachment {
  std::string cloth, rope;                    ///< names; one of them is empty
  std::string body, other_cloth, other_rope;  ///< likewise, at most one is not
  AttachmentDef def;                          ///< its ids are filled in when the scene is built
};

/// Where pictures are taken from. Left out, a view is chosen that holds everything.
struct SceneCamera {
  Vec3 position{3, 2, 4};       ///< m
  Vec3 target{0, 0, 0};         ///< m
  float field_of_view = 35.0f;  ///< degrees, vertical

  bool operator==(const SceneCamera&) const = default;
};

/// One more view, to be chosen by its name.
struct SceneNamedCamera {
  std::string name;
  SceneCamera view;
};

struct Scene {
  std::string name;
  std::string description;
  float frame_time = 0.016f;  ///< s; one World::step
  int frames = 250;           ///< how many, unless the caller says otherwise
  int relax_iterations = 0;   ///< World::relax before the first frame
  WorldDef world;
  std::vector<FluidDef> fluids;
  std::vector<GranularDef> granulars;
  std::vector<ShapeDef> shapes;
  std::vector<SceneBody> bodies;
  std::vector<SceneJoint> joints;
  std::vector<ClothDef> cloths;
  std::vector<RopeDef> ropes;
  std::vector<SceneAttachment> attachments;
  std::optional<WindDef> wind;
  std::vector<SceneVolume> volumes;
  std::vector<SceneEmitter> emitters;
  std::vector<SceneSink> sinks;
  std::vector<SceneProbe> probes;
  std::vector<SceneCheck> checks;
  std::optional<SceneCamera> camera;
  std::vector<SceneNamedCamera> cameras;
};

/// The bodies of an entry: itself, or its copies, x fastest, with their numbers from 0 on at the end of their
/// names, as in crate_12.
std::vector<BodyDef> copies_of(const SceneBody& body);

/// All bodies of a scene, in its order.
std::vector<BodyDef> bodies_of(const Scene& scene);

/// A world made from a scene. The ids stand in the order of the scene's lists; of bodies, in that of
/// bodies_of.
struct BuiltScene {
  World world;
  std::vector<FluidId> fluids;  ///< and behind them the granular materials
  std::vector<ShapeId> shapes;
  std::vector<BodyId> bodies;
  std::vector<JointId> joints;
  std::vector<ClothId> cloths;
  std::vector<RopeId> ropes;
  std::vector<AttachmentId> attachments;
  std::vector<std::size_t> volumes;  ///< how many particles each made
  std::vector<EmitterId> emitters;
  std::vector<SinkId> sinks;
  std::vector<ProbeId> probes;
};

/// Throws what World throws, with the item of the scene; and Error(invalid_argument) where a check is of the
/// volume of cloth that is not closed.
BuiltScene build_scene(const Scene& scene);

}  // namespace meniscus
