// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What an engine takes and returns: parameters, solids, cloth, batches of particles, results of steps.
#pragma once

#include <meniscus/hooks.h>
#include <meniscus/host.h>
#include <meniscus/ids.h>
#include <meniscus/outputs.h>

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cloth/build/cloth_model.h"
#include "cloth/rods/rod.h"
#include "cloth/self_contact/contact_piece.h"
#include "cloth/solve/cloth_set.h"
#include "collision/body/attachments.h"
#include "collision/body/proxy.h"
#include "collision/contact/shape.h"
#include "collision/contact/shape_contacts.h"
#include "collision/film/film_surface.h"
#include "collision/fluid_cloth/cloth_surface.h"
#include "collision/grains/grain_set.h"
#include "collision/mesh/mesh.h"
#include "collision/rigid/rigid_world.h"
#include "fluid/density/density_set.h"
#include "fluid/density/probes.h"
#include "fluid/diffuse/diffuse.h"
#include "fluid/kernel/material.h"
#include "fluid/surface/surface_mesh.h"
#include "pbd/device/gl_buffers.h"
#include "pbd/solver.h"
#include "pbd/state/saved_state.h"
#include "pbd/state/state_visitor.h"
#include "sdk/engine/force_fields/force_field.h"
#include "sdk/engine/vertex_track.h"

namespace meniscus {

struct EngineDef {
  pbd::SolverParameters solver;
  fluid::Kernel kernel{};
  float particle_spacing = 0;  ///< m
  Vec3 origin{0, 0, 0};        ///< m, added to the places that write_particles writes
  fluid::DensityParameters density;
  std::optional<fluid::DiffuseParameters> diffuse;
  cloth::ClothSolverParameters cloth;
  collision::RigidWorld* rigid = nullptr;  ///< must outlive the engine
};

/// The material of the particles of one group: a fluid, or grains.
struct ParticleMaterial {
  fluid::Material fluid;  ///< for grains only the density is used
  collision::GrainMaterial grain;
  CollisionFilter filter;  ///< which solids they collide with
  std::string name{};
  // As given, for pictures and readers of files. Files of 0.2 have neither.
  std::optional<Vec3> color{};
  std::optional<float> slope{};  ///< GranularDef::friction
};

/// All solids in the solver's form: fixed shapes first. Shapes of bodies are placed by `carried`. Those of a
/// batch's worlds follow one another, and so do their bodies.
struct SolidShapes {
  std::vector<collision::Shape> shapes;
  uint32_t fixed = 0;
  std::vector<collision::PlaneOpening> openings;
  std::vector<collision::CarriedShape> carried;
  std::vector<collision::FilmPart> films;  ///< the surfaces of bodies
  uint32_t worlds = 1;
};

enum class TouchedKind { shape, body, cloth };

/// The effect of a contact in the last substep.
struct ContactReadout {
  uint32_t slot;   ///< of the particle
  uint32_t solid;  ///< fixed shape, body or piece of cloth
  TouchedKind kind;
  Vec3 point, normal;
  Vec3 impulse;  ///< N·s, on the particle
};

/// A place on the surface of the nearest solid.
struct NearestSolid {
  uint32_t solid;  ///< fixed shape or body
  TouchedKind kind;
  Vec3 normal;     ///< unit, out of the solid
  float distance;  ///< m, negative inside
};

/// Takes the particles of fluids inside its region, or those outside of it.
struct Sink {
  enum class Kind : uint32_t { box, ball, half_space };
  Kind kind = Kind::box;
  uint32_t outside = 0;
  Pose pose{};                     ///< of the region
  Aabb box{{0, 0, 0}, {0, 0, 0}};  ///< m
  Vec3 normal{0, 1, 0};            ///< half space: unit
  float size = 0;                  ///< m; ball: radius; half space: normal · p below this is inside
};

/// A particle that is to be placed at `to`, where it has arrived from the opening at `from`.
struct Arrival {
  Vec3 from, to;           ///< m
  Vec3 velocity;           ///< m/s
  CollisionFilter filter;  ///< which solids block it
  uint32_t waits;          ///< 1: it has waited, and now drives away particles that are too near
  uint32_t in_duct = 0;    ///< 1: solids do not block it
};

/// The mouth of a duct, whose particles a step moves as they are told.
struct Piston {
  Pose mouth;         ///< its plane is y = 0 in this frame; y points out
  Vec3 half;          ///< m, half extents along x and z; of a round mouth the radius
  uint32_t is_round;  ///< 1: a disc, 0: a rectangle
  Vec3 velocity;      ///< m/s
  float front;        ///< m, of the foremost layer in front of the mouth at the step's end

  MENISCUS_HD Vec3 direction() const { return rotate(mouth.rotation, {0, 1, 0}); }
  /// Whether the line through q along y passes through the mouth, in the mouth's frame.
  MENISCUS_HD bool holds(Vec3 q) const {
    if (is_round) return q.x * q.x + q.z * q.z <= half.x * half.x;
    return fabsf(q.x) <= half.x && fabsf(q.z) <= half.z;
  }
};

struct PistonParticle {
  uint32_t slot;
  uint32_t piston;  ///< number
};

/// What a piston met in a step.
struct PistonReading {
  double impulse = 0;      ///< N·s on it, against its direction
  double error_ahead = 0;  ///< mean C of the fluid up to a support radius in front, at the step's end
};

struct ParticleBatch {
  std::vector<pbd::Vec4> position;  ///< w: inverse mass
  std::vector<pbd::Vec4> velocity;
  std::vector<pbd::Phase> phase;
  bool by_hand = false;    ///< nobody has checked for room: the particles may be in solids
  bool may_crowd = false;  ///< nor whether they are far enough apart

  void clear() {
    position.clear();
    velocity.clear();
    phase.clear();
  }
};

/// All cloth and ropes of a world: their vertices, by number, and their constraints.
struct EngineCloth {
  std::vector<pbd::Vec4> position;  ///< w: inverse mass
  std::vector<pbd::Vec4> velocity;
  std::vector<pbd::Phase> phase;                    ///< the group is the piece
  std::vector<collision::Touch> touches;            ///< by piece
  std::vector<cloth::ContactPiece> contact_pieces;  ///< by piece
  std::vector<collision::FluidClothPiece> sheets;   ///< by piece
  std::vector<collision::BodyAttachment> attachments;
  cloth::ClothModel model;
  cloth::RodModel rods, ropes;
  std::vector<cloth::SegmentState> segments;  ///< of the rods
  std::vector<DrivenPiece> driven;
};

/// The bodies that vertices are attached to.
inline std::vector<uint32_t> attached_bodies(const EngineCloth& cloth) {
  std::vector<uint32_t> bodies;
  for (const collision::BodyAttachment& a : cloth.attachments) bodies.push_back(a.body);
  return bodies;
}

/// Numbers by which World::state_hash hashes the vertices of one world; empty without cloth.
using VertexNumbers = std::vector<uint64_t>;

/// Arrays in the memory of the device, by slot.
struct EngineArrays {
  Vec3* positions = nullptr;
  Vec3* velocities = nullptr;
  uint32_t* groups = nullptr;
  ParticleId* ids = nullptr;
};

using HookCalls = std::array<SubstepCall, hook_count>;

/// The lengths of the last substeps whose multipliers and impulses the next one starts from, s; 0: none was.
struct LastSubsteps {
  float of_all = 0;
  float density = 0, cloth = 0, grains = 0;  ///< relaxing counts for these parts

  bool operator==(const LastSubsteps&) const = default;
  bool none() const { return *this == LastSubsteps{}; }
};

/// The particles of one world of a batch, in their order on the device, and what they start a step from.
struct EngineWorld {
  std::vector<pbd::Vec4> position, velocity;
  std::vector<pbd::Phase> phase;
  std::vector<uint32_t> slot, number;
  std::vector<fluid::density_kernels::Multiplier> multiplier;
  std::vector<collision::RigidImpulse> body_forces;  ///< see Engine::body_forces
  LastSubsteps last;
  std::vector<pbd::Vec4> vertex_position, vertex_velocity;
  std::vector<pbd::Phase> vertex_phase;
  std::shared_ptr<pbd::SavedState> parts;  ///< what grains and parts of cloth carry
};

struct EngineStep {
  pbd::StepResult result;
  std::array<double, stage_count> stage_ms{};
  double rigid_ms = 0;
  bool any_world_failed = false;    ///< in a batch: a body of some world was not finite
  uint32_t density_iterations = 0;  ///< over all substeps
  Overflows overflows;
  std::vector<PistonReading> pistons;
};

/// Results of a fresh neighbour search.
struct EngineMeasure {
  double neighbours_mean = 0;
  uint32_t contacts = 0;
  std::size_t wall_overflows = 0;
};

}  // namespace meniscus
