// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cloth, ropes and rods, what holds them, and what can be read of them. Units as in defs.h.
#pragma once

#include <meniscus/defs.h>

#include <limits>

namespace meniscus {

// ---- fabric ----

/// What stretch and shear act on.
enum class StretchModel {
  /// The lengths of edges: the cheaper one. It takes edges along warp and weft; where there are none, what is
  /// pulled along these shears as well, and a strip of the default fabric yields five to ten times as far.
  edges,
  triangles,  ///< strain along warp and weft, and shear, of each triangle (Müller et al. 2014)
};

/// How bending is measured.
enum class BendingModel {
  isometric,  ///< quadratic bending (Bergou et al. 2006) where cloth is flat at rest, dihedral elsewhere
  dihedral,   ///< the angle between two triangles, from that at rest
};

/// Stiffnesses are per width of cloth, as tests of fabric give them, ≥ 0; infinity is unyielding.
struct FabricDef {
  float density = 0.2f;  ///< kg/m², 1e-6 to 1e4; silk .05, cotton .15, denim .4, canvas .6
  StretchModel stretch_model = StretchModel::edges;
  float warp_stiffness = 20000.0f;  ///< N/m, along u: tension over strain
  float weft_stiffness = 20000.0f;  ///< N/m, along v
  float shear_stiffness = 100.0f;   ///< N/m: shear force over the shear angle
  BendingModel bending_model = BendingModel::isometric;
  float bending_stiffness = 5e-5f;  ///< N·m: moment over curvature
  /// s, Rayleigh's, 0 to 1e6: viscous forces are so many times the elastic ones' rate.
  float stretch_damping = 0.002f;
  float bending_damping = 0.01f;  ///< s, likewise
  float thickness = 0.0f;  ///< m, up to 1000: two layers keep this distance; 0: a quarter of the mean edge
  float friction = 0.3f;   ///< Coulomb's μ between cloth and cloth; on solids SurfaceDef::friction counts
  float fluid_friction = 0.0f;  ///< Coulomb's μ between fluid and cloth
  float fluid_adhesion =
      0.0f;  ///< Pa: the pull on a wet layer of particles, per area, as SurfaceDef::adhesion
  /// 1/s: how much fluid passes through, in m/s for each metre of water column across it (ISO 11058, ASTM
  /// D4491: Darcy's permeability over thickness); 0: tight. What is on its way through does not press: at
  /// 0.8/s a tenth less passes.
  float permittivity = 0.0f;
  /// kg/m² of fluid that it takes up at most, of the first fluid that it touches; 0: none. Particles are
  /// taken up whole, where the cloth around has room: one wets an area of its mass over this.
  float absorbency = 0.0f;
  /// 0 to 1: the share of it that is kept for good (as ISO 9073-6 measures it, hung up to drip); the rest
  /// runs down, gathers at the lowest places and drips from there. Cloth that is strained keeps less.
  float retention = 0.8f;
  float drainage = 0.05f;    ///< m/s: how fast what it does not keep runs down steep cloth
  float drag = 1.0f;         ///< C_D of a flat plate in the world's wind; 0: no drag
  float lift = 0.5f;         ///< C_L of a flat plate
  float tear_strain = 0.0f;  ///< edges stretched further than this tear; 0: never
};

/// A flat sheet in the plane y = 0 of its frame, centred there: the warp along x, the weft along z.
struct SheetGeometry {
  float width = 1.0f;  ///< m, along x
  float depth = 1.0f;  ///< m, along z
  int columns = 33;    ///< vertices along x, 2 to 10,000
  /// Vertices along z, 2 to 10,000; vertex (column, row) has the number row · columns + column.
  int rows = 33;
};

/// Any triangles: from a file that assimp reads, in which vertices at one place are one vertex.
struct ClothFile {
  std::string file;
  float scale =
      1.0f;  ///< metres a file unit; where the file says how long its unit is, as FBX does, a factor
};

/// Any triangles. Edges have at most two.
struct ClothTriangles {
  std::vector<Vec3> vertices;       ///< m, at rest
  std::vector<uint32_t> triangles;  ///< three numbers each
};

/// A closed sphere about the origin, of nearly equal triangles: an icosahedron's, divided.
struct ClothSphere {
  float radius = 0.5f;  ///< m
  int divisions = 8;    ///< of an edge of the icosahedron, 1 to 500; there are 10 · divisions² + 2 vertices
};

/// A tube or cone about the y axis, centred at the origin, open at both ends; or, with a bottom, a bag.
struct ClothTube {
  float top_radius = 0.2f;     ///< m
  float bottom_radius = 0.5f;  ///< m
  float height = 0.6f;         ///< m
  int columns = 64;            ///< vertices around, 3 to 10,000
  /// Vertices along y, 2 to 10,000, from the top; numbered row by row as those of a sheet.
  int rows = 25;
  bool bottom = false;  ///< a disc closes the lower end; its vertices come last, from its border inwards
};

using ClothGeometry = std::variant<SheetGeometry, ClothFile, ClothTriangles, ClothSphere, ClothTube>;

/// Gas inside a closed piece of cloth. Where the cloth tears, it escapes. Its overpressure is
/// air_pressure · (fills − V)/V₀, with V₀ the volume at rest and fills = V₀ (1 + pressure/air_pressure): near
/// V₀ that of an ideal gas at one temperature.
struct InflationDef {
  float pressure = 0.0f;           ///< Pa above the air outside, at the volume of the cloth's rest shape
  float air_pressure = 101325.0f;  ///< Pa outside: how much the gas resists a change of its volume; > 0
};

/// Where it starts in a solid it comes out by half its thickness in .02 s, and gains no more speed by that.
struct ClothDef {
  std::string name;
  ClothGeometry geometry = SheetGeometry{};
  Pose pose{};             ///< of the geometry's frame
  Vec3 stretch{1, 1, 1};   ///< at creation the geometry is scaled by this; at rest it is not
  Vec3 velocity{0, 0, 0};  ///< m/s
  FabricDef fabric{};
  CollisionFilter filter{};  ///< with solids, and with other cloth
  bool self_collision = true;
  /// Whether each vertex is pulled, where it is further from the nearest vertex that is held fast than along
  /// the cloth at rest (Kim, Chentanez & Müller 2012): cloth that is no grid then hangs with hardly more
  /// stretch at few substeps than at many. All that pulls so is together as stiff as the fabric, so that
  /// soft cloth hangs with half its stretch.
  bool tethers = true;
  std::optional<InflationDef> inflation{};  ///< closed pieces alone
  Vec3 color{0.75f, 0.2f, 0.2f};            ///< linear RGB, 0 to 1
};

// ---- ropes and rods ----

/// A chain of straight segments, as thick as its radius. A rod bends and twists, each segment having a frame
/// (Kugelstadt & Schömer 2016); a rope has a length alone.
struct RopeDef {
  std::string name;
  std::vector<Vec3> points;  ///< m, in the frame below: the vertices at rest, or with `segments` corners
  int segments = 0;  ///< when > 0, the way along the points is divided into so many; at most a million
  Pose pose{};
  Vec3 velocity{0, 0, 0};         ///< m/s
  float radius = 0.005f;          ///< m, 1e-6 to 1000
  float density = 1000.0f;        ///< kg/m³, 0.001 to 1e6
  bool bends_and_twists = false;  ///< a rod; else a rope
  float youngs_modulus = 1e8f;    ///< Pa, ≥ 1e-6; infinity: unyielding
  float shear_modulus = 3.5e7f;   ///< Pa, ≥ 1e-6: of rods' twist
  float damping = 0.001f;         ///< s, Rayleigh's
  bool closed = false;            ///< the last vertex is joined to the first
  bool straight_at_rest = false;  ///< rods: however the points lie
  CollisionFilter filter{};       ///< with solids; ropes pass through ropes and cloth
  Vec3 color{0.6f, 0.5f, 0.3f};   ///< linear RGB, 0 to 1
};

// ---- attachments ----

/// Holds vertices of a piece of cloth or of a rope where they are: to the world, to a body, or to other
/// vertices of another piece or rope or of the same, which are then held at the distance that they have.
/// Exactly one of `cloth` and `rope` is given, and at most one of `body`, `other_cloth` and `other_rope`.
struct AttachmentDef {
  std::string name;
  std::optional<ClothId> cloth{};
  std::optional<RopeId> rope{};
  std::vector<uint32_t> vertices{};  ///< by number
  std::optional<Aabb> region{};      ///< and those in this box of the world, as they lie now
  std::optional<BodyId> body{};
  std::optional<ClothId> other_cloth{};
  std::optional<RopeId> other_rope{};
  /// Each vertex is sewn to the nearest vertex of the other piece no further away than this, m; the rest stay
  /// free.
  float reach = 0.05f;
  float compliance = 0.0f;  ///< m/N, of a seam
  bool clamped = false;     ///< a rod's segments between its held vertices keep their direction as well
};

// ---- wind ----

/// Air that moves. Gusts are a field of waves without divergence, the same for the same seed.
struct WindDef {
  Vec3 velocity{0, 0, 0};    ///< m/s
  float air_density = 1.2f;  ///< kg/m³; 0: no air at all, and no drag
  float gust_speed = 0.0f;   ///< m/s, standard deviation, 0 to 1e6
  float gust_size = 2.0f;    ///< m
  uint32_t seed = 1;
};

// ---- read-outs ----

struct ClothState {
  float mass = 0;        ///< kg, with the fluid that it holds
  float fluid_mass = 0;  ///< kg, of that fluid
  float area = 0;        ///< m², at rest
  /// Mean of |l/L − 1| over the edges of all triangles, l their length and L that at rest: 0 is unstretched.
  /// An edge of two triangles counts twice.
  float mean_stretch = 0;
  float max_stretch = 0;     ///< largest l/L: 1 is unstretched
  float volume = 0;          ///< m³, of a closed piece
  float pressure = 0;        ///< Pa, overpressure of its gas
  Vec3 centre{0, 0, 0};      ///< m, of mass
  Vec3 momentum{0, 0, 0};    ///< kg·m/s
  float kinetic_energy = 0;  ///< J
  bool closed = false;
};

/// A vertex that tore in two in the last step: `original` keeps its number, and `copy` is that of the new
/// one, at the end of the piece's read-outs.
struct TearEvent {
  ClothId cloth{};
  uint32_t copy = 0, original = 0;
};

}  // namespace meniscus
