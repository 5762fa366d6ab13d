// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cloth, ropes and rods, their attachments and read-outs, and wind. Units as in defs.h.
#pragma once

#include <meniscus/defs.h>

#include <limits>

namespace meniscus {

// ---- fabric ----

/// The elements that resist stretch and shear.
enum class StretchModel {
  /// The lengths of edges. This is the cheaper model. It needs edges along warp and weft. In a mesh without
  /// such edges a pull along warp or weft also shears. A strip of the default fabric then stretches five to
  /// ten times as far.
  edges,
  triangles,  ///< strains of each triangle along warp and weft, and its shear (Müller et al. 2014)
};

/// How bending is measured.
enum class BendingModel {
  isometric,  ///< quadratic bending (Bergou et al. 2006) for cloth that is flat at rest, else dihedral
  dihedral,   ///< the angle between two triangles, relative to rest
};

/// Stiffnesses are per width of cloth, as in tests of fabric, and ≥ 0. Infinity is unyielding.
struct FabricDef {
  float density = 0.2f;  ///< kg/m², 1e-6 to 1e4; silk .05, cotton .15, denim .4, canvas .6
  StretchModel stretch_model = StretchModel::edges;      ///< what resists stretch and shear
  float warp_stiffness = 20000.0f;                       ///< N/m, along u: tension over strain
  float weft_stiffness = 20000.0f;                       ///< N/m, along v
  float shear_stiffness = 100.0f;                        ///< N/m: shear force over the shear angle
  BendingModel bending_model = BendingModel::isometric;  ///< what resists bending
  float bending_stiffness = 5e-5f;                       ///< N·m: moment over curvature
  /// s, Rayleigh's, 0 to 1e6: the viscous force is this time multiplied by the rate of the elastic force.
  float stretch_damping = 0.002f;
  float bending_damping = 0.01f;  ///< s, likewise
  float thickness = 0.0f;  ///< m, up to 1000: distance that two layers keep; 0: a quarter of the mean edge
  float friction = 0.3f;   ///< Coulomb's μ of cloth on cloth; on solids SurfaceDef::friction counts
  float fluid_friction = 0.0f;  ///< Coulomb's μ between fluid and cloth
  float fluid_adhesion = 0.0f;  ///< Pa: pull on a wet layer of particles, as SurfaceDef::adhesion
  /// m, ≥ 0: how viscous fluid slips along either side, as SurfaceDef::slip_length. 0: no slip; infinite:
  /// free.
  float slip_length = std::numeric_limits<float>::infinity();
  /// 1/s: the flow through the cloth, in m/s for each metre of water column across it (ISO 11058, ASTM D4491:
  /// Darcy's permeability over thickness). 0 is tight. Particles on their way through do not press, so at
  /// 0.8/s a tenth less passes.
  float permittivity = 0.0f;
  /// kg/m²: the most fluid that it absorbs, of the first fluid that it touches. 0: none. Whole particles are
  /// absorbed, if the cloth around them has room. One particle wets an area of its mass divided by this.
  float absorbency = 0.0f;
  /// 0 to 1: the fraction of the absorbency that stays in cloth that hangs to drip (ISO 9073-6). The rest
  /// runs down, gathers at the lowest vertices and drips from there. Strained cloth keeps less.
  float retention = 0.8f;
  float drainage = 0.05f;    ///< m/s: speed of fluid that runs down steep cloth
  float drag = 1.0f;         ///< C_D of a flat plate in the world's wind; 0: no drag
  float lift = 0.5f;         ///< C_L of a flat plate
  float tear_strain = 0.0f;  ///< strain beyond which edges tear; 0: never
};

/// A flat sheet in the plane y = 0 of its frame, centred at the origin. The warp is along x and
/// the weft along z.
struct SheetGeometry {
  float width = 1.0f;  ///< m, along x
  float depth = 1.0f;  ///< m, along z
  int columns = 33;    ///< vertices along x, 2 to 10,000
  /// Vertices along z, 2 to 10,000; vertex (column, row) has the number row · columns + column.
  int rows = 33;
};

/// Any triangles, from a mesh file. Vertices at the same position are merged, and then those
/// within `weld`. Numbers of vertices are those after that.
struct ClothFile {
  std::string file;    ///< its path
  float scale = 1.0f;  ///< metres a file unit; a factor if the file states its unit, as FBX does
  /// Mean edges, 0 to 0.1: vertices no further apart are merged. World::cloth_welded_vertices counts them.
  float weld = 1e-3f;
};

/// Any triangles. An edge has at most two. Vertices keep their numbers, and none are merged.
struct ClothTriangles {
  std::vector<Vec3> vertices;       ///< m, at rest; at least 3
  std::vector<uint32_t> triangles;  ///< three numbers each; at least one triangle
};

/// A closed sphere about the origin, of nearly equal triangles: a subdivided icosahedron.
struct ClothSphere {
  float radius = 0.5f;  ///< m
  int divisions = 8;    ///< of an edge of the icosahedron, 1 to 500; there are 10 · divisions² + 2 vertices
};

/// A tube or cone about the y axis, centred at the origin and open at both ends. With a bottom it is a bag.
struct ClothTube {
  float top_radius = 0.2f;     ///< m
  float bottom_radius = 0.5f;  ///< m
  float height = 0.6f;         ///< m
  int columns = 64;            ///< vertices around, 3 to 10,000
  /// Vertices along y, 2 to 10,000, from the top; numbered row by row as those of a sheet.
  int rows = 25;
  bool bottom = false;  ///< a disc closes the lower end; its vertices come last, from its border inwards
};

/// Where the vertices of a driven surface are at a time.
struct ClothKeyframe {
  float time = 0;                ///< s, of World::time; ≥ 0 and later than the keyframe before
  std::vector<Vec3> vertices{};  ///< m, in the frame of ClothDef::pose; as many in each keyframe
};

/// A driven surface: triangles whose vertices move as given, whatever they meet. Between two keyframes each
/// vertex moves along a line at a constant rate. Before the first and after the last the surface is at rest.
struct DrivenTriangles {
  std::vector<uint32_t> triangles{};       ///< three numbers each; the same in all keyframes
  std::vector<ClothKeyframe> keyframes{};  ///< at least one
  /// Whether the first keyframe follows the last. The last one should then have the vertices of the first. It
  /// needs at least 2 keyframes.
  bool loop = false;
};

/// A driven surface from numbered mesh files, one a frame. All have the same triangles and as many vertices,
/// in the same order. Vertices at the same position in the first file are merged, in all files.
struct DrivenFiles {
  /// Their path, with the frame's number as %d, or as %04d with leading zeros: "walk/figure_%04d.obj".
  std::string files{};
  int first = 1;                 ///< number of the first file, 0 to 999,999,999
  int last = 1;                  ///< number of the last file, at least the first
  float frames_per_second = 24;  ///< 1e-3 to 1e6
  float start = 0;               ///< s, ≥ 0: World::time of the first file
  float scale = 1;               ///< metres a file unit, as ClothFile::scale
  bool loop = false;             ///< as DrivenTriangles::loop
};

/// The rest shape of a piece of cloth, or the motion of a driven surface.
using ClothGeometry = std::variant<SheetGeometry, ClothFile, ClothTriangles, ClothSphere, ClothTube,
                                   DrivenTriangles, DrivenFiles>;

/// Gas inside a closed piece of cloth. It escapes if the cloth tears. Its overpressure is
/// air_pressure · (fills − V)/V₀, with V₀ the volume at rest and fills = V₀ (1 + pressure/air_pressure). Near
/// V₀ this is the pressure of an ideal gas at constant temperature.
struct InflationDef {
  float pressure = 0.0f;           ///< Pa above the air outside, at the volume of the rest shape
  float air_pressure = 101325.0f;  ///< Pa outside, > 0: resistance of the gas to a change of volume
};

/// Cloth that starts inside a solid is pushed out by half its thickness per 0.02 s and gains no
/// further speed.
///
/// A driven surface has infinite mass: fluid, bodies and other cloth meet it, and nothing stops it. It takes
/// no velocity, tearing, gas, collision with itself or attachment to the world or to a body. Cloth can be
/// sewn to it. Of its fabric only contacts with others count. Fluid is not seeded inside a closed one.
struct ClothDef {
  std::string name{};                        ///< what World::find_cloth takes
  ClothGeometry geometry = SheetGeometry{};  ///< its shape at rest
  Pose pose{};                               ///< of the geometry's frame
  Vec3 stretch{1, 1, 1};                     ///< scales the geometry at creation; the rest shape is unscaled
  Vec3 velocity{0, 0, 0};                    ///< m/s
  FabricDef fabric{};                        ///< what it is made of
  CollisionFilter filter{};                  ///< with solids, and with other cloth
  bool self_collision = true;                ///< whether it collides with itself
  /// Whether tethers pull a vertex that is further from the nearest held vertex than along the cloth at rest
  /// (Kim, Chentanez & Müller 2012). Cloth that is no grid then hangs with hardly more stretch at few
  /// substeps than at many. All tethers together are as stiff as the fabric, so soft cloth hangs with half of
  /// its stretch.
  bool tethers = true;
  std::optional<InflationDef> inflation{};  ///< closed pieces alone
  Vec3 color{0.75f, 0.2f, 0.2f};            ///< linear RGB, 0 to 1
};

// ---- ropes and rods ----

/// A row of straight segments with a radius. A rod bends and twists, and each of its segments has a frame
/// (Kugelstadt & Schömer 2016). A rope has a length alone.
struct RopeDef {
  std::string name{};        ///< what World::find_rope takes
  std::vector<Vec3> points;  ///< m, in the frame of `pose`: vertices at rest, or corners with `segments`
  int segments = 0;          ///< if > 0, the path along the points is divided into so many; at most a million
  Pose pose{};               ///< of the points
  Vec3 velocity{0, 0, 0};    ///< m/s
  float radius = 0.005f;     ///< m, 1e-6 to 1000
  float density = 1000.0f;   ///< kg/m³, 0.001 to 1e6
  bool bends_and_twists = false;  ///< a rod; else a rope
  float youngs_modulus = 1e8f;    ///< Pa, ≥ 1e-6; infinity: unyielding
  float shear_modulus = 3.5e7f;   ///< Pa, ≥ 1e-6, finite: for the twist of rods
  float damping = 0.001f;         ///< s, Rayleigh's
  bool closed = false;            ///< the last vertex is joined to the first
  bool straight_at_rest = false;  ///< for rods: whether they are straight at rest, however the points lie
  CollisionFilter filter{};       ///< with solids; ropes pass through ropes and cloth
  Vec3 color{0.6f, 0.5f, 0.3f};   ///< linear RGB, 0 to 1
};

// ---- attachments ----

/// Holds vertices of a piece of cloth or a rope where they are. They are held to the world, to a body, or to
/// other vertices at their present distance. These may belong to another piece or rope or to the same one.
/// Exactly one of `cloth` and `rope` is given, and at most one of `body`, `other_cloth` and `other_rope`.
/// Vertices do not collide with a body that they are attached to, nor do faces with such a vertex.
struct AttachmentDef {
  std::string name{};                ///< what World::find_attachment takes
  std::optional<ClothId> cloth{};    ///< the piece that is held
  std::optional<RopeId> rope{};      ///< the rope that is held
  std::vector<uint32_t> vertices{};  ///< by number
  std::optional<Aabb> region{};  ///< in addition those in this box of the world, at their present positions
  std::optional<BodyId> body{};  ///< the body that holds them
  std::optional<ClothId> other_cloth{};  ///< the piece that they are sewn to
  std::optional<RopeId> other_rope{};    ///< the rope that they are sewn to
  /// m, > 0: each vertex is sewn to the nearest vertex of the other piece within this distance, or stays
  /// free.
  float reach = 0.05f;
  float compliance = 0.0f;  ///< m/N, of a seam
  bool clamped = false;     ///< segments of a rod between held vertices keep their directions as well
};

// ---- wind ----

/// Moving air. Gusts are a divergence-free field of waves, equal for equal seeds.
struct WindDef {
  Vec3 velocity{0, 0, 0};    ///< m/s
  float air_density = 1.2f;  ///< kg/m³; 0: no air and no drag
  float gust_speed = 0.0f;   ///< m/s, standard deviation, 0 to 1e6
  float gust_size = 2.0f;    ///< m
  uint32_t seed = 1;         ///< of the gusts
};

// ---- read-outs ----

/// Masses, stretch, volume and motion of a piece of cloth.
struct ClothState {
  float mass = 0;        ///< kg, with the fluid that it holds
  float fluid_mass = 0;  ///< kg, of that fluid
  float area = 0;        ///< m², at rest
  /// Mean of |l/L − 1| over the edges of all triangles, with length l and length at rest L. 0 is unstretched.
  /// An edge of two triangles counts twice.
  float mean_stretch = 0;
  float max_stretch = 0;     ///< largest l/L: 1 is unstretched
  float volume = 0;          ///< m³, of a closed piece
  float pressure = 0;        ///< Pa, overpressure of its gas
  Vec3 centre{0, 0, 0};      ///< m, of mass
  Vec3 momentum{0, 0, 0};    ///< kg·m/s
  float kinetic_energy = 0;  ///< J
  bool closed = false;       ///< whether it has no border
};

/// A vertex that tore in two in the last step. `original` keeps its number. `copy` is the number of the new
/// one, at the end of the piece's read-outs.
struct TearEvent {
  ClothId cloth{};                  ///< the piece
  uint32_t copy = 0, original = 0;  ///< numbers of the new and of the old vertex
};

}  // namespace meniscus
