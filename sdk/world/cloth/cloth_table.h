// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The cloth and ropes of a world on the host: what they are made of, and where their vertices stand.
#pragma once

#include <meniscus/cloth.h>

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "sdk/engine/engine.h"
#include "sdk/world/check/id_table.h"

namespace meniscus {

/// Where vertices stand on the host, m and m/s.
struct VertexStates {
  std::vector<Vec3> positions, velocities;
};

/// What cloth and ropes have in common. Vertices are numbered from `first` on among all of the world.
struct VertexRange {
  VertexStates state;     ///< when it is not the device that has the latest
  uint32_t first = 0;     ///< since the last upload
  bool uploaded = false;  ///< then the device has the latest state
  bool placed = true;     ///< it was put where it is, and the device does not know it yet
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
  ClothDef def;
  VertexRange range;
  cloth::ClothMesh mesh;  ///< at rest
  cloth::ClothConstraints constraints;
  float thickness = 0;  ///< m
  bool closed = false;
  float rest_volume = 0;               ///< m³, of a closed piece
  std::vector<uint32_t> held;          ///< that the tethers are for
  std::vector<cloth::Tether> tethers;  ///< numbered on their own
  std::vector<Vec3> normals;           ///< of the latest state, when it was asked for
  std::vector<float> strains;          ///< likewise
  // Of absorbent cloth, by vertex:
  std::vector<double> water;           ///< kg
  std::optional<FluidId> soaked_with;  ///< one fluid at a time
  VertexGraph graph;
  std::vector<float> wetness;  ///< when it was asked for
};

struct RopeEntry {
  RopeDef def;
  VertexRange range;
  cloth::RodModel model;  ///< its vertices numbered from 0
  std::vector<cloth::SegmentState> segments;
  std::vector<Quat> frames;  ///< of the segments, when they were asked for
};

struct AttachmentEntry {
  AttachmentDef def;
  std::vector<uint32_t> vertices;  ///< of its cloth or rope
  std::vector<Vec3> anchors;       ///< in the body's principal frame, of those that are attached to one
  uint32_t first_attachment = pbd::no_index;  ///< since the last upload; none yet: no_index
  std::vector<cloth::EdgeConstraint> seams;   ///< from its vertex to the other's, each numbered on its own
  std::vector<uint32_t> clamped;              ///< segments of a rod
  Vec3 force{0, 0, 0};                        ///< N, in the last step, as far as it was read
};

/// m, at rest.
float mean_edge(const cloth::ClothMesh& mesh);
ClothEntry make_cloth(const ClothDef& def);
RopeEntry make_rope(const RopeDef& def);

/// From the mesh, which has changed.
void build_constraints(ClothEntry& entry);
/// Finds its tethers, once for the vertices that are held.
void attach_to_held(ClothEntry& entry, const std::vector<uint32_t>& held);

/// Of a closed mesh, m³.
float enclosed_volume(const cloth::ClothMesh& mesh, std::span<const Vec3> positions);

}  // namespace meniscus
