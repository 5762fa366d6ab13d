// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The cloth and ropes of a world on the host: their meshes and constraints, and the state of their vertices.
#pragma once

#include <meniscus/cloth.h>
#include <meniscus/outputs.h>

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "sdk/engine/engine.h"
#include "sdk/world/check/id_table.h"

namespace meniscus {

/// Positions (m) and velocities (m/s) of vertices on the host.
struct VertexStates {
  std::vector<Vec3> positions, velocities;
};

/// What cloth and ropes have in common. Their vertices have consecutive numbers in the world, from `first`
/// on.
struct VertexRange {
  VertexStates state;     ///< valid unless the device has a later state
  uint32_t first = 0;     ///< since the last upload
  bool uploaded = false;  ///< true: the device has the latest state
  bool placed = true;     ///< it was placed by a call, and the device does not know this yet
  std::vector<float> masses;
  CollisionFilter filter;
  float contact_radius = 0;  ///< m, towards solids

  uint32_t count() const { return static_cast<uint32_t>(masses.size()); }
};

/// The neighbours of each vertex of a piece, along edges.
struct VertexGraph {
  struct Edge {
    uint32_t to;
    float length;  ///< m, at rest
  };
  std::vector<uint32_t> start;
  std::vector<Edge> edges;

  std::span<const Edge> of(uint32_t v) const {
    return std::span(edges).subspan(start[v], start[v + 1] - start[v]);
  }
};

struct ClothEntry {
  ClothDef def;  ///< without keyframes, which the track has
  VertexRange range;
  VertexTrackPtr track;   ///< of a driven surface; else null
  cloth::ClothMesh mesh;  ///< at rest
  cloth::ClothConstraints constraints;
  float thickness = 0;  ///< m
  bool closed = false;
  float rest_volume = 0;               ///< m³, of a closed piece
  uint32_t welded = 0;                 ///< vertices of a file that were merged into others
  std::vector<uint32_t> held;          ///< vertices for which the tethers were found
  std::vector<cloth::Tether> tethers;  ///< numbered within the piece
  std::vector<Vec3> outward;           ///< positions in the user's frame
  std::vector<Vec3> normals;           ///< of the latest state, computed on request
  std::vector<float> strains;          ///< as for the normals
  /// By corner, or none: that of a file from the creation on, else computed on request. Tearing keeps it.
  std::optional<std::vector<TexturePoint>> texture;
  // Of absorbent cloth, by vertex:
  std::vector<double> water;           ///< kg
  std::optional<FluidId> soaked_with;  ///< one fluid at a time
  VertexGraph graph;
  std::vector<float> wetness;  ///< computed on request
};

struct RopeEntry {
  RopeDef def;
  VertexRange range;
  cloth::RodModel model;  ///< with vertices numbered from 0
  std::vector<cloth::SegmentState> segments;
  std::vector<Quat> frames;   ///< of the segments, computed on request
  std::vector<Vec3> outward;  ///< positions in the user's frame
};

struct AttachmentEntry {
  AttachmentDef def;
  std::vector<uint32_t> vertices;  ///< of its cloth or rope
  std::vector<Vec3> anchors;       ///< in the body's principal frame, for vertices attached to a body
  uint32_t first_attachment = pbd::no_index;  ///< since the last upload; no_index: none yet
  std::vector<cloth::EdgeConstraint>
      seams;                      ///< from its vertices to the other's, each numbered within its own range
  std::vector<uint32_t> clamped;  ///< segments of a rod
  Vec3 force{0, 0, 0};            ///< N, in the last step, as read so far
};

/// Whether its vertices move as given.
bool is_driven(const ClothGeometry& geometry);

/// Mean edge length at rest, m.
float mean_edge(const cloth::ClothMesh& mesh);
/// Drops the keyframes of DrivenTriangles, which a track has.
void drop_keyframes(ClothDef& def);
/// A driven surface is where it is at `time`, World::time.
ClothEntry make_cloth(const ClothDef& def, const FileReader& files, double time);
RopeEntry make_rope(const RopeDef& def);

/// Throws Error(capacity) if the driven surfaces have more positions than 32 bits count, together with
/// `added` more.
void check_driven_room(const IdTable<ClothId, ClothEntry>& cloths, size_t added = 0);
/// What the engine moves: the driven surfaces of a world, at their places since the last upload.
std::vector<DrivenPiece> driven_pieces(const IdTable<ClothId, ClothEntry>& cloths);

/// Builds the constraints anew after the mesh has changed.
void build_constraints(ClothEntry& entry);
/// Finds the tethers to these held vertices, unless they are known already.
void attach_to_held(ClothEntry& entry, const std::vector<uint32_t>& held);

/// The volume of a closed mesh, m³.
float enclosed_volume(const cloth::ClothMesh& mesh, std::span<const Vec3> positions);

}  // namespace meniscus
