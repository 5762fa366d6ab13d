// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of pressure_grid.h: from particles to nodes and faces, and back. Nodes are the corners of the
// cells that particles are sorted by; face (node, axis) lies half way to the next node on that axis.
#pragma once

#include "fluid/density_wall_kernels.h"
#include "fluid/multigrid_kernels.h"
#include "pbd/grid.h"

namespace meniscus::fluid::grid_kernels {

using multigrid_kernels::along;
using multigrid_kernels::Coefficients;
using pbd::Contact;
using pbd::ContactView;
using pbd::Vec4;
using pbd::View;

/// Where a particle is in its cell, on each axis from 0 to 1.
struct Place {
  NodeCoordinates cell;
  Vec3 t;
};

struct Space {
  pbd::GridView cells;
  NodeTable nodes;

  /// Where in its cell a point is.
  MENISCUS_HD Vec3 part(Vec3 p) const { return place(p).t; }
  MENISCUS_HD Place place(Vec3 p) const {
    pbd::CellCoordinates c = cells.coordinates(p);
    c.x = c.x >> 2;  // floor of a quarter
    const Vec3 x = cells.inverse_reach * p;
    const auto part = [](float v, int32_t cell) {
      return pbd::clamp(v - static_cast<float>(cell), 0.0f, 1.0f);
    };
    return {{{c.x, c.y, c.z}}, {part(x.x, c.x), part(x.y, c.y), part(x.z, c.z)}};
  }
  MENISCUS_HD float width() const { return 1 / cells.inverse_reach; }
  /// Of the cell behind a node: its slices lie side by side.
  MENISCUS_HD pbd::Run particles_behind(uint32_t node) const {
    return {cells.start[slices * node], cells.start[slices * (node + 1)]};
  }

  static constexpr uint32_t slices = pbd::GridView::slices;
  static_assert(slices == 4);
};

MENISCUS_HD inline float component(Vec3 v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/// Calls visit(node, weight) for the eight nodes around a particle: weights are linear, and add up to 1.
template <class Visit>
MENISCUS_HD void for_each_node(const NodeTable& nodes, const Place& p, const Visit& visit) {
  MENISCUS_UNROLL
  for (int k = 0; k < 8; ++k) {
    const int x = k & 1, y = k >> 1 & 1, z = k >> 2;
    const float weight = (x ? p.t.x : 1 - p.t.x) * (y ? p.t.y : 1 - p.t.y) * (z ? p.t.z : 1 - p.t.z);
    visit(nodes.index(p.cell.at[0] + x, p.cell.at[1] + y, p.cell.at[2] + z), weight);
  }
}

/// The same for the eight faces of one axis.
template <class Visit>
MENISCUS_HD void for_each_face(const NodeTable& nodes, const Place& p, int axis, const Visit& visit) {
  Place shifted = p;
  const bool before = component(p.t, axis) < 0.5f;
  float* t = axis == 0 ? &shifted.t.x : axis == 1 ? &shifted.t.y : &shifted.t.z;
  *t += before ? 0.5f : -0.5f;
  shifted.cell.at[axis] -= before ? 1 : 0;
  for_each_node(nodes, shifted, visit);
}

/// What lies around a node.
enum NodeFlags : uint32_t {
  node_fluid = 1,       ///< its pressure is an unknown
  node_solid = 2,       ///< it is in a solid
  node_touched = 4,     ///< near contacts
  node_wall_below = 8,  ///< the node before it on x is in a solid; then after it; then y and z
};

MENISCUS_HD inline uint32_t wall_flag(int axis, bool after) {
  return node_wall_below << (2 * axis + (after ? 1 : 0));
}

enum class Face { none, open, closed };

struct NodeMap {
  NodeTable nodes;
  View<const uint32_t> flags;

  /// A face is closed where there is fluid on one side and a solid on the other.
  MENISCUS_HD Face face(uint32_t node, int axis) const {
    const uint32_t other = nodes.beside(nodes.coordinates(node), axis, 1);
    return between(flags[node], flags[other], axis);
  }
  MENISCUS_HD static Face between(uint32_t before, uint32_t after, int axis) {
    const bool a = before & node_fluid, b = after & node_fluid;
    if (a && b) return Face::open;
    if (a) return before & wall_flag(axis, true) ? Face::closed : Face::open;
    if (b) return after & wall_flag(axis, false) ? Face::closed : Face::open;
    return Face::none;
  }
};

/// Too much volume at a particle, of a particle's own volume. What was too much or too little already at the
/// last substep's end is undone at a rate, not at once: short steps would make great speeds of small errors.
struct ExcessOf {
  View<const density_kernels::Multiplier> last;
  float kept;  ///< share of the old error that stays

  MENISCUS_HD float operator()(uint32_t i, float constraint) const {
    // Nothing holds up what closes a gap, until it is closed.
    const float change = pbd::min(constraint - kept * last[i].relieved, pbd::max(constraint, 0.0f));
    // Where the density lacks by little, the lattice is loose there, and the sign counts; where it lacks by
    // much there is a surface.
    return change * pbd::clamp(5 * constraint + 1.5f, 0.0f, 1.0f);
  }
};

/// Of one particle: x, y, z: where in its cell it is, from 0 to 1; w: its excess.
using Found = Vec4;

struct Excess {
  Kernel kernel;
  Space space;
  pbd::NeighbourView neighbours;
  View<const uint32_t> contact_start;
  View<const Vec4> position;
  View<const pbd::Phase> phase;
  ExcessOf excess_of;
  View<Found> found;

  template <class D>
  MENISCUS_HD void run(uint32_t i) const {
    if (contact_start[i] != contact_start[i + 1]) return;
    const float value = density_kernels::density_constraint<D>(kernel, position, neighbours, i).value;
    if (!D::leads()) return;
    const float excess = pbd::is_grain(phase[i]) ? 0.0f : excess_of(i, value);
    found[i] = pbd::with_w(space.part(position[i].xyz()), excess);
  }
};

struct ExcessAtWalls {
  Kernel kernel;
  Space space;
  pbd::NeighbourView neighbours;
  ContactView contacts;
  View<const Vec4> position;
  View<const pbd::Phase> phase;
  ExcessOf excess_of;
  View<Found> found;

  template <class D>
  MENISCUS_HD void run(uint32_t contact) const {
    const uint32_t i = contacts.particle_starting_at(contact);
    if (i == pbd::no_index) return;
    const float value =
        density_kernels::density_constraint_at_walls<D, false>(kernel, position, neighbours, contacts, i)
            .value;
    if (!D::leads()) return;
    const float excess = pbd::is_grain(phase[i]) ? 0.0f : excess_of(i, value);
    found[i] = pbd::with_w(space.part(position[i].xyz()), excess);
  }
};

/// Calls visit(particle, way to the node in widths of a cell) for the particles in those of the eight cells
/// around that `wanted(first, end)` takes, by their particles.
template <class Wanted, class Visit>
MENISCUS_HD void for_each_around(const Space& space, uint32_t node, View<const Found> found,
                                 const Wanted& wanted, const Visit& visit) {
  const NodeCoordinates c = space.nodes.coordinates(node);
  for (int k = 0; k < 8; ++k) {
    const int x = k & 1, y = k >> 1 & 1, z = k >> 2;  // 0: the cell lies before the node
    const uint32_t cell = space.nodes.index(c.at[0] + x - 1, c.at[1] + y - 1, c.at[2] + z - 1);
    const auto [first, end] = space.particles_behind(cell);
    if (first == end || !wanted(first, end)) continue;
    for (uint32_t i = first; i < end; ++i) {
      const Vec3 t = found[i].xyz();
      visit(i, Vec3{x ? -t.x : 1 - t.x, y ? -t.y : 1 - t.y, z ? -t.z : 1 - t.z});
    }
  }
}

struct AllCells {
  MENISCUS_HD bool operator()(uint32_t, uint32_t) const { return true; }
};

/// Cells where particles touch something: contacts stand in the order of their particles.
struct TouchingCells {
  View<const uint32_t> contact_start;

  MENISCUS_HD bool operator()(uint32_t first, uint32_t end) const {
    return contact_start[first] != contact_start[end];
  }
};

/// Of a particle at a node that is so far away, in widths of a cell.
MENISCUS_HD inline float node_weight(Vec3 away) {
  return (1 - fabsf(away.x)) * (1 - fabsf(away.y)) * (1 - fabsf(away.z));
}

/// How much of a node's share of space lies behind a plane that is this far away, in widths of a cell.
MENISCUS_HD inline float share_behind(float distance) {
  const float a = pbd::max(0.0f, 1 - fabsf(distance)), half = 0.5f * a * a;
  return distance > 0 ? half : 1 - half;
}

/// How deep in solids a node may be, in widths of a cell, to be an unknown. Half a width deeper than fluid
/// reaches there are no faces that move any.
inline constexpr float deepest = -0.45f;

/// What a node is: fluid where particles fill half of what solids leave.
struct GatherNodes {
  Space space;
  View<const Found> found;
  View<const Vec4> position;
  ContactView contacts;
  float volume;  ///< m³, of a particle
  View<uint32_t> flags;
  View<float> filled;  ///< share of the node's space that particles fill

  /// What is seen from a node: solids as whoever touches most of them sees them.
  struct Sight {
    float weight = 0, open = 1, distance = 1;
    float beside[6] = {1, 1, 1, 1, 1, 1};  ///< distances of the nodes beside
    bool touched = false;
  };

  MENISCUS_HD void operator()(uint32_t node) const {
    Sight sight;
    for_each_around(space, node, found, AllCells{},
                    [&](uint32_t, Vec3 away) { sight.weight += node_weight(away); });
    for_each_around(space, node, found, TouchingCells{contacts.start},
                    [&](uint32_t i, Vec3 away) { add(sight, i, away); });
    const float inverse_width = space.cells.inverse_reach;
    const float share = volume * inverse_width * inverse_width * inverse_width * sight.weight;
    flags[node] = flags_of(sight, share);
    filled[node] = share;
  }

  MENISCUS_HD void add(Sight& sight, uint32_t i, Vec3 away) const {
    float open = 1;
    for (uint32_t k = contacts.start[i]; k < contacts.start[i + 1]; ++k) {
      const Contact& c = contacts.contacts[k];
      if (c.body == pbd::on_sheet || pbd::is_tie(c) || c.fraction < 0.5f) continue;
      const float distance =
          space.cells.inverse_reach * plane_distance(c, position[i].xyz()) + dot(c.normal, away);
      open *= 1 - share_behind(distance);
      sight.touched = true;
      sight.distance = pbd::min(sight.distance, distance);
      MENISCUS_UNROLL
      for (int b = 0; b < 6; ++b) {
        const float step = component(c.normal, b / 2);
        sight.beside[b] = pbd::min(sight.beside[b], distance + (b % 2 ? step : -step));
      }
    }
    sight.open = pbd::min(sight.open, open);
  }

  MENISCUS_HD static uint32_t flags_of(const Sight& sight, float share) {
    uint32_t flags = sight.touched ? node_touched : 0u;
    if (sight.distance < deepest)
      flags |= node_solid;
    else if (share > (sight.open < 0.5f ? 0.3f : 0.5f) * sight.open)
      flags |= node_fluid;
    for (int b = 0; b < 6; ++b) {
      if (sight.beside[b] < deepest) flags |= wall_flag(b / 2, b % 2);
    }
    return flags;
  }
};

/// Which nodes have fluid all around.
struct MarkInside {
  NodeTable nodes;
  View<const uint32_t> flags;
  View<uint32_t> inside;

  MENISCUS_HD void operator()(uint32_t node) const {
    const NodeCoordinates c = nodes.coordinates(node);
    uint32_t all = flags[node];
    for (int axis = 0; axis < 3; ++axis)
      all &= flags[nodes.beside(c, axis, -1)] & flags[nodes.beside(c, axis, 1)];
    inside[node] = all & node_fluid;
  }
};

/// By what to multiply a particle's weights on the faces of each axis, so that those which can move it add up
/// to 1; 0 where there are next to none.
struct Normalize {
  Space space;
  NodeMap map;
  View<const uint32_t> inside;
  View<const Vec4> position;
  ContactView contacts;
  View<Vec4> scale;   ///< w: mass, kg; 0 for who takes no part
  View<Found> found;  ///< what would count at nodes in solids counts at the others

  MENISCUS_HD void operator()(uint32_t i) const {
    const Vec4 p = position[i];
    const Place place = space.place(p.xyz());
    uint32_t all = node_fluid;
    for_each_node(space.nodes, place, [&](uint32_t node, float) { all &= inside[node]; });
    if (all) {
      scale[i] = {1, 1, 1, mass_of(i)};
      return;
    }
    float inverse[3];
    for (int axis = 0; axis < 3; ++axis) {
      float total = 0;
      for_each_face(space.nodes, place, axis, [&](uint32_t node, float weight) {
        if (map.face(node, axis) != Face::none) total += weight;
      });
      inverse[axis] = total > 0.05f ? 1 / total : 0.0f;
    }
    float outside_solids = 0;
    for_each_node(space.nodes, place, [&](uint32_t node, float weight) {
      if (!(map.flags[node] & node_solid)) outside_solids += weight;
    });
    found[i].w /= pbd::max(outside_solids, 0.1f);
    scale[i] = {inverse[0], inverse[1], inverse[2], mass_of(i)};
  }

  MENISCUS_HD float mass_of(uint32_t i) const {
    const float w = position[i].w;
    return w > 0 && !touches_sheet(i) ? 1 / w : 0.0f;
  }

  MENISCUS_HD bool touches_sheet(uint32_t i) const {
    for (uint32_t k = contacts.start[i]; k < contacts.start[i + 1]; ++k) {
      if (contacts.contacts[k].body == pbd::on_sheet) return true;
    }
    return false;
  }
};

/// A face as the pressure sees it.
struct FaceState {
  float area = 0;  ///< share that is open
  float mass = 0;  ///< kg, of the particles that it moves
  /// 1/kg; of a face that moves next to nothing less than its mass's, or spray would be thrown about.
  float inverse_mass = 0;
};

/// All faces of one node.
struct alignas(8) NodeFaces {
  FaceState face[3];
};

struct GatherFaces {
  Space space;
  NodeMap map;
  View<const Found> found;
  View<const Vec4> scale;
  float volume;
  View<NodeFaces> faces;

  MENISCUS_HD void operator()(uint32_t k) const {
    const int axis = static_cast<int>(k / space.nodes.count());
    const uint32_t node = k % space.nodes.count();
    faces[node].face[axis] = map.face(node, axis) == Face::open ? gather(node, axis) : FaceState{};
  }

  MENISCUS_HD FaceState gather(uint32_t node, int axis) const {
    const NodeCoordinates c = space.nodes.coordinates(node);
    const int side = (axis + 1) % 3, other = (axis + 2) % 3;
    float mass = 0, filled = 0, least = 0;
    for (int k = 0; k < 12; ++k) {
      const int along_axis = k % 3 - 1, s = k / 3 % 2 - 1, o = k / 6 - 1;
      NodeCoordinates cell = c;
      cell.at[axis] += along_axis;
      cell.at[side] += s;
      cell.at[other] += o;
      const pbd::Run run = space.particles_behind(space.nodes.index(cell));
      for (uint32_t i = run.begin; i < run.end; ++i) {
        const Vec3 t = found[i].xyz();
        const float away = fabsf(static_cast<float>(along_axis) + component(t, axis) - 0.5f);
        if (away >= 1) continue;
        const float ts = component(t, side), to = component(t, other);
        const float weight = (1 - away) * (s ? ts : 1 - ts) * (o ? to : 1 - to);
        const Vec4 own = scale[i];
        filled += weight * along(own, axis);
        mass += weight * along(own, axis) * own.w;
        least = pbd::max(least, 0.5f * own.w);
      }
    }
    const uint32_t flags = map.flags[node] | map.flags[space.nodes.beside(c, axis, 1)];
    const float inverse_width = space.cells.inverse_reach;
    const float share = filled * volume * inverse_width * inverse_width * inverse_width;
    return {flags & node_touched ? pbd::min(1.0f, share) : 1.0f, mass,
            mass > 0 ? 1 / pbd::max(mass, least) : 0.0f};
  }
};

/// How much volume around a node is too much, m³.
struct GatherExcess {
  Space space;
  View<const uint32_t> flags;
  View<const Found> found;
  float volume;  ///< m³, of a particle
  float least;   ///< m³: what lacks more is no longer noise, and for gravity to close
  View<float> right;

  MENISCUS_HD void operator()(uint32_t node) const {
    float sum = 0;
    if (flags[node] & node_fluid) {
      for_each_around(space, node, found, AllCells{},
                      [&](uint32_t i, Vec3 away) { sum += found[i].w * node_weight(away); });
    }
    right[node] = pbd::max(volume * sum, least);
  }
};

/// The equation: what a pressure P, in kg·m/m², drives through a face is a² H⁴ P/M.
struct MakeEquation {
  NodeTable nodes;
  View<const uint32_t> flags;
  View<const NodeFaces> faces;
  View<const float> filled;
  float width2;      ///< H², m²
  float compliance;  ///< m⁴/kg, of a whole node
  View<const float> give;
  View<Coefficients> coefficients;

  MENISCUS_HD float coefficient(uint32_t node, int axis) const {
    const FaceState f = faces[node].face[axis];
    return width2 * width2 * f.area * f.area * f.inverse_mass;
  }

  MENISCUS_HD void operator()(uint32_t node) const {
    const NodeCoordinates c = nodes.coordinates(node);
    Coefficients own{coefficient(node, 0), coefficient(node, 1), coefficient(node, 2), 0};
    if (flags[node] & node_fluid) {
      float sum = own.x + own.y + own.z;
      for (int axis = 0; axis < 3; ++axis) sum += coefficient(nodes.beside(c, axis, -1), axis);
      own.w = sum + compliance * filled[node] + give[node];
    }
    coefficients[node] = own;
  }
};

/// How far each face moves its particles.
struct FaceMoves {
  NodeTable nodes;
  View<const NodeFaces> faces;
  View<const float> pressure;
  float width2;
  float share;  ///< of the whole motion
  float limit;  ///< m

  /// kg·m
  MENISCUS_HD float impulse(const NodeCoordinates& c, uint32_t node, int axis) const {
    const float fall = pressure[node] - pressure[nodes.beside(c, axis, 1)];
    return share * faces[node].face[axis].area * width2 * fall;
  }
  /// m
  MENISCUS_HD float way(const NodeCoordinates& c, uint32_t node, int axis) const {
    return pbd::clamp(faces[node].face[axis].inverse_mass * impulse(c, node, axis), -limit, limit);
  }
};

/// What faces do not hand on, as they move too little or their motion is bounded, and the mass that all move.
struct Lost {
  double impulse[3] = {0, 0, 0}, mass[3] = {0, 0, 0};
};

struct AddLost {
  MENISCUS_HD Lost operator()(Lost a, const Lost& b) const {
    for (int axis = 0; axis < 3; ++axis) {
      a.impulse[axis] += b.impulse[axis];
      a.mass[axis] += b.mass[axis];
    }
    return a;
  }
};

struct FindLost {
  FaceMoves moves;

  MENISCUS_HD Lost operator()(uint32_t node) const {
    const NodeCoordinates c = moves.nodes.coordinates(node);
    Lost lost;
    for (int axis = 0; axis < 3; ++axis) {
      const float mass = moves.faces[node].face[axis].mass;
      if (!(mass > 0)) continue;
      lost.mass[axis] = double{mass};
      lost.impulse[axis] =
          double{moves.impulse(c, node, axis)} - double{mass} * double{moves.way(c, node, axis)};
    }
    return lost;
  }
};

/// All that is moved makes up for what is lost.
struct MoveFaces {
  FaceMoves moves;
  View<const Lost> lost;
  View<Vec4> motion;

  MENISCUS_HD void operator()(uint32_t node) const {
    const NodeCoordinates c = moves.nodes.coordinates(node);
    const Lost& all = lost[0];
    float way[3] = {0, 0, 0};
    for (int axis = 0; axis < 3; ++axis) {
      if (moves.faces[node].face[axis].mass > 0)
        way[axis] = moves.way(c, node, axis) + static_cast<float>(all.impulse[axis] / all.mass[axis]);
    }
    motion[node] = {way[0], way[1], way[2], 0};
  }
};

struct MoveParticles {
  Space space;
  View<const Vec4> scale;
  View<const Vec4> motion;
  View<const uint32_t> flags;
  View<const float> pressure;
  float to_multiplier;  ///< m³
  View<Vec4> position, moved;
  View<float> multiplier;  ///< kg·m², as the density constraint would have it

  MENISCUS_HD void operator()(uint32_t i) const {
    const Vec4 p = position[i], own = scale[i];
    const Place place = space.place(p.xyz());
    float step[3] = {0, 0, 0};
    if (own.w > 0) {
      for (int axis = 0; axis < 3; ++axis) {
        for_each_face(space.nodes, place, axis,
                      [&](uint32_t node, float weight) { step[axis] += weight * along(motion[node], axis); });
        step[axis] *= along(own, axis);
      }
    }
    float sum = 0, weights = 0;
    for_each_node(space.nodes, place, [&](uint32_t node, float weight) {
      if (flags[node] & node_solid) return;
      sum += weight * pressure[node];
      weights += weight;
    });
    multiplier[i] = weights > 0 ? to_multiplier * sum / weights : 0.0f;
    const Vec3 way{step[0], step[1], step[2]};
    position[i] = pbd::with_w(p.xyz() + way, p.w);
    moved[i] = pbd::with_w(moved[i].xyz() + way, 0);
  }
};

}  // namespace meniscus::fluid::grid_kernels
