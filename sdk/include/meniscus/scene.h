// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Scenes: definitions with names in place of ids, how to run them and look at them. A scene is read from a
// file or filled in by a program, is checked, and is built to a World. The program `meniscus` uses the same
// calls. Link Meniscus::meniscus_scene.
#pragma once

#include <meniscus/axis.h>
#include <meniscus/meniscus.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace meniscus {

// ---- parts of a scene ----

/// A region that is filled with particles at the start.
struct SceneVolume {
  std::string fluid;   ///< FluidDef::name, or GranularDef::name
  FluidVolumeDef def;  ///< build_scene fills in its fluid id
};

/// An opening that makes particles.
struct SceneEmitter {
  std::string fluid;  ///< FluidDef::name
  std::string body;   ///< BodyDef::name, or empty
  EmitterDef def;     ///< build_scene fills in its ids
};

/// A region that removes particles.
struct SceneSink {
  std::string body;  ///< BodyDef::name, or empty
  SinkDef def;       ///< build_scene fills in its body id
};

/// A measurement.
struct SceneProbe {
  std::string shape;  ///< ShapeDef::name, or empty
  std::string fluid;  ///< FluidDef::name or GranularDef::name, or empty
  ProbeDef def;       ///< build_scene fills in its ids
};

/// Equal bodies at the points of a lattice.
struct SceneCopies {
  std::vector<int> count{1, 1, 1};  ///< along x, y and z; at most 100,000 together
  Vec3 step{0, 0, 0};               ///< m, from one to the next along each axis
};

/// A body, or a lattice of equal bodies.
struct SceneBody {
  BodyDef def;                            ///< of the first copy
  std::optional<SceneCopies> copies;      ///< none: there is one body
  std::optional<MotionFile> motion_file;  ///< whose poses are the keyframes; read with the scene
};

/// A joint between bodies, or between a body and the world.
struct SceneJoint {
  std::string a, b;  ///< names of bodies; an empty b is the world
  JointDef def;      ///< build_scene fills in its body ids
};

/// Something that holds cloth or a rope.
struct SceneAttachment {
  std::string cloth, rope;                    ///< names; exactly one of them is given
  std::string body, other_cloth, other_rope;  ///< names; at most one of them is given
  AttachmentDef def;                          ///< build_scene fills in its ids
};

/// The view of pictures.
struct SceneCamera {
  Vec3 position{3, 2, 4};       ///< m
  Vec3 target{0, 0, 0};         ///< m; differs from the position
  float field_of_view = 35.0f;  ///< degrees, vertical, between 0 and 180
};

/// One more view, which is chosen by its name.
struct SceneNamedCamera {
  std::string name;  ///< what --camera takes
  SceneCamera view;  ///< where it looks from and to
};

/// Liquids whose absorption and scattering are known; see docs/methods/rendering.md.
enum class Liquid {
  clear,  ///< pure water
  sea,    ///< water of the open sea
  pool,   ///< water with fine matter in it
  milk,   ///< whole milk
  honey,  ///< clear honey
  oil,    ///< olive oil
};

/// How pictures show a fluid, in place of FluidDef::color.
struct SceneLook {
  std::string fluid;               ///< FluidDef::name
  Liquid liquid = Liquid::clear;   ///< whose absorption and scattering it has
  std::optional<Vec3> absorption;  ///< 1/m, of red, green and blue light; none: that of the liquid
  std::optional<Vec3> scattering;  ///< 1/m, likewise
};

/// What a check looks at after each frame.
enum class CheckKind {
  outside,         ///< particles beyond the wall of a container, or inside a solid
  crossings,       ///< passages of particles through cloth so far
  density_error,   ///< mean of max(C, 0) over all particles, C = ρ/ρ₀ − 1
  energy,          ///< of particles, cloth and ropes, above the floor, over that at the start
  share_inside,    ///< fraction of the particles that are in a box
  body_position,   ///< m, along an axis
  body_speed,      ///< m/s, of the centre of mass
  body_tilt,       ///< degrees, from the y axis of the body to the vertical
  cloth_position,  ///< m, of the centre of mass, along an axis
  mean_stretch,    ///< mean over edges of |l/L − 1|
  max_stretch,     ///< largest l/L
  cloth_volume,    ///< of a closed piece, over that at the start
  tears,           ///< vertices that have torn in two so far
  probe,           ///< the value of a probe, in its unit
};

/// A condition that a run of the scene must meet. The program evaluates it after each frame.
struct SceneCheck {
  CheckKind kind = CheckKind::outside;  ///< what it looks at
  std::string name;                     ///< what outputs call it
  std::string body;                     ///< BodyDef::name, for body_position, body_speed and body_tilt
  std::string cloth;    ///< ClothDef::name, for checks of cloth; with crossings, empty means all cloth
  std::string probe;    ///< ProbeDef::name, for probe
  Axis axis = Axis::y;  ///< for body_position and cloth_position
  Aabb region{};        ///< for share_inside
  std::optional<float> low{}, high{};  ///< bounds of the value; at least one of them
  float from = 0;                      ///< s, ≥ 0: frames that end earlier do not count
  std::optional<float> until{};        ///< s: frames that end later do not count; none: all do
};

// ---- the scene ----

/// A scene. `meniscus schema` prints the keys, units and ranges of its file.
struct Scene {
  std::string name;                          ///< what outputs call it
  std::string description;                   ///< what there is to see
  float frame_time = 0.016f;                 ///< s, ≥ 1e-12: length of a frame, which is one World::step
  int frames = 250;                          ///< ≥ 1: length of a run, unless the caller says otherwise
  int relax_iterations = 0;                  ///< 0 to 100,000, of World::relax before the first frame
  WorldDef world;                            ///< gravity, resolution and solvers
  std::vector<FluidDef> fluids;              ///< kinds of liquid
  std::vector<GranularDef> granulars;        ///< kinds of grains
  std::vector<ShapeDef> shapes;              ///< solids that do not move
  std::vector<SceneBody> bodies;             ///< rigid bodies
  std::vector<SceneJoint> joints;            ///< between bodies, or a body and the world
  std::vector<ClothDef> cloths;              ///< pieces of cloth
  std::vector<RopeDef> ropes;                ///< ropes and rods
  std::vector<SceneAttachment> attachments;  ///< what holds cloth and ropes
  std::optional<WindDef> wind;               ///< none: the air is at rest
  std::vector<SceneVolume> volumes;          ///< what is filled at the start
  std::vector<SceneEmitter> emitters;        ///< what makes particles
  std::vector<SceneSink> sinks;              ///< what removes particles
  std::vector<SceneProbe> probes;            ///< measurements
  std::vector<ForceFieldDef> force_fields;   ///< accelerations and forces at places
  std::vector<SceneCheck> checks;            ///< what must hold during a run
  std::vector<SceneLook> looks;              ///< at most one a fluid; others are shown by their colour
  std::optional<SceneCamera> camera;         ///< none: a view that holds everything
  std::vector<SceneNamedCamera> cameras;     ///< further views
};

/// The bodies of an entry: the body itself, or its copies. x is fastest. The names of copies end with their
/// number, as in crate_12.
std::vector<BodyDef> copies_of(const SceneBody& body);

/// All bodies of a scene, in its order.
std::vector<BodyDef> bodies_of(const Scene& scene);

// ---- errors ----

/// A scene that cannot be read, checked or built. The message contains all parts.
class SceneError : public Error {
 public:
  SceneError(ErrorCode code, const std::string& message, std::string file, std::string path,
             std::string fix = {})
      : Error(code, message), file_(std::move(file)), path_(std::move(path)), fix_(std::move(fix)) {}

  const std::string& file() const noexcept { return file_; }  ///< the scene file; empty if there is none
  /// The place in the scene, as in `fluids[0].rest_density`. It is empty for the whole scene.
  const std::string& path() const noexcept { return path_; }
  const std::string& fix() const noexcept { return fix_; }  ///< what to do, or what is allowed; may be empty

 private:
  std::string file_, path_, fix_;
};

// ---- from a file to a world ----

/// Reads a scene file: JSON, in which comments are allowed. Each override is `path=value`, as in
/// `fluids[0].dynamic_viscosity=0.1`. Its value is JSON, or else text. Paths of mesh files start from the
/// folder of the scene, and those in overrides from the current folder. `glmark2:bunny.obj` is a model of
/// Debian's glmark2-data, or of the folder in the environment variable MENISCUS_GLMARK2_DIR.
///
/// Throws SceneError with io for a file that cannot be read, and with parse for contents that are no scene.
/// Throws Error(invalid_argument) for an override that does not fit.
Scene read_scene(const std::string& path, std::span<const std::string> overrides = {});

/// Reads a scene from the text of a file. Paths of mesh files start from `folder`. `source` is the name of
/// the text in errors. Throws what read_scene throws.
///
/// `read_file` becomes WorldDef::read_file of the scene. Then it gets the names as they stand in the text,
/// with `folder` before them, and the file system is not asked.
Scene read_scene_text(const std::string& text, const std::string& folder = "",
                      const std::string& source = "scene", const FileReader& read_file = {});

/// Checks the names and values of a scene, without making a world. Throws SceneError: parse if a name is
/// missing or stands twice, and invalid_argument if a value is not allowed. Meshes are not read.
void check_scene(const Scene& scene);

/// A world made from a scene. The ids are in the order of the lists of the scene.
struct BuiltScene {
  World world;                               ///< with all of the scene in it
  std::vector<FluidId> fluids{};             ///< of the fluids, and then of the granular materials
  std::vector<ShapeId> shapes{};             ///< fixed solids
  std::vector<BodyId> bodies{};              ///< in the order of bodies_of
  std::vector<JointId> joints{};             ///< between bodies
  std::vector<ClothId> cloths{};             ///< pieces of cloth
  std::vector<RopeId> ropes{};               ///< ropes and rods
  std::vector<AttachmentId> attachments{};   ///< of cloth and ropes
  std::vector<std::size_t> volumes{};        ///< number of particles that each made
  std::vector<EmitterId> emitters{};         ///< what makes particles
  std::vector<SinkId> sinks{};               ///< what removes particles
  std::vector<ProbeId> probes{};             ///< measurements
  std::vector<ForceFieldId> force_fields{};  ///< accelerations and forces at places
};

/// Checks a scene and makes a world of it. Throws what check_scene throws, and what World throws, with the
/// item of the scene. Throws SceneError(invalid_argument) for a check of the volume of open cloth.
BuiltScene build_scene(const Scene& scene);

/// The JSON Schema (draft 2020-12) of scene files, as text. Values with a unit have it as `unit`.
std::string scene_schema();

}  // namespace meniscus
