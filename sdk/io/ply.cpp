// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Writes binary PLY files.
#include "sdk/io/ply.h"

#include <spdlog/fmt/fmt.h>

#include <bit>
#include <limits>
#include <vector>

#include "sdk/files/output_file.h"

namespace meniscus::io {
namespace {

static_assert(std::endian::native == std::endian::little,
              "the records below are written as they lie in memory");

struct PlyVertex {
  Vec3 position, velocity;
  uint32_t fluid, id;
  float density_error;
};
static_assert(sizeof(PlyVertex) == 9 * 4);

struct PlySolidVertex {
  Vec3 position, velocity;
};
static_assert(sizeof(PlySolidVertex) == 6 * 4);

/// Of cloth and liquids.
struct PlySmoothVertex {
  Vec3 position, normal, velocity;
};
static_assert(sizeof(PlySmoothVertex) == 9 * 4);

struct PlyRopeVertex {
  Vec3 position, velocity;
  float radius;
};
static_assert(sizeof(PlyRopeVertex) == 7 * 4);

struct PlyEdge {
  uint32_t from, to, rope;
};
static_assert(sizeof(PlyEdge) == 3 * 4);

/// Without padding, as in the file.
#pragma pack(push, 1)
struct PlyFace {
  uint8_t count;
  std::array<uint32_t, 3> corners;
  uint32_t piece;  // index of its body or fluid
};
struct PlyClothFace {
  uint8_t count;
  std::array<uint32_t, 3> corners;
  uint32_t cloth;
  float strain;
};
struct PlyTexturedFace {
  PlyClothFace face;
  uint8_t count;
  std::array<TexturePoint, 3> texture;
};
#pragma pack(pop)
static_assert(sizeof(PlyFace) == 1 + 4 * 4);
static_assert(sizeof(PlyClothFace) == 1 + 5 * 4);
static_assert(sizeof(PlyTexturedFace) == 2 + 11 * 4);

std::string header(const SurfaceFrame& frame) {
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment Meniscus solids at {:.7g} s; metres, metres a second\n"
      "element vertex {}\n"
      "property float x\nproperty float y\nproperty float z\n"
      "property float vx\nproperty float vy\nproperty float vz\n"
      "element face {}\n"
      "property list uchar uint vertex_indices\nproperty uint {}\n"
      "end_header\n",
      frame.time, frame.vertices.size(), frame.triangles.size(), frame.kind);
}

std::string header(const ClothFrame& frame) {
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment Meniscus cloth at {:.7g} s; metres, metres a second\n"
      "element vertex {}\n"
      "property float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty float nz\n"
      "property float vx\nproperty float vy\nproperty float vz\n"
      "element face {}\n"
      "property list uchar uint vertex_indices\nproperty uint cloth\nproperty float strain\n"
      "{}end_header\n",
      frame.time, frame.vertices.size(), frame.triangles.size(),
      frame.texture.empty() ? "" : "property list uchar float texcoord\n");
}

std::string header(const LiquidFrame& frame) {
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment Meniscus liquid at {:.7g} s; metres, metres a second\n"
      "element vertex {}\n"
      "property float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty float nz\n"
      "property float vx\nproperty float vy\nproperty float vz\n"
      "element face {}\n"
      "property list uchar uint vertex_indices\nproperty uint fluid\n"
      "end_header\n",
      frame.time, frame.vertices.size(), frame.triangles.size());
}

std::string header(const RopeFrame& frame, std::size_t edges) {
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment Meniscus ropes at {:.7g} s; metres, metres a second\n"
      "element vertex {}\n"
      "property float x\nproperty float y\nproperty float z\n"
      "property float vx\nproperty float vy\nproperty float vz\nproperty float radius\n"
      "element edge {}\n"
      "property uint vertex1\nproperty uint vertex2\nproperty uint rope\n"
      "end_header\n",
      frame.time, frame.vertices.size(), edges);
}

std::string header(const ParticleFrame& frame) {
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment Meniscus particles at {:.7g} s; metres, metres a "
      "second\n"
      "element vertex {}\n"
      "property float x\nproperty float y\nproperty float z\n"
      "property float vx\nproperty float vy\nproperty float vz\n"
      "property uint fluid\nproperty uint id\nproperty float density_error\n"
      "end_header\n",
      frame.time, frame.size());
}

uint32_t narrow_id(ParticleId id) {
  if (id <= std::numeric_limits<uint32_t>::max()) return static_cast<uint32_t>(id);
  throw Error(ErrorCode::capacity, "particle id " + std::to_string(id) +
                                       " does not fit the 32-bit integers of a PLY file; export vtp");
}

template <class Frame>
std::vector<PlySmoothVertex> smooth_vertices(const Frame& frame) {
  std::vector<PlySmoothVertex> vertices(frame.vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
    vertices[i] = {frame.vertices[i], frame.normals[i], frame.velocities[i]};
  return vertices;
}

std::vector<PlyClothFace> cloth_faces(const ClothFrame& frame) {
  std::vector<PlyClothFace> faces(frame.triangles.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
    faces[i] = {3, frame.triangles[i], frame.pieces[i], frame.strains[i]};
  return faces;
}

/// `texture`: one a corner.
std::vector<PlyTexturedFace> textured(const std::vector<PlyClothFace>& faces,
                                      std::span<const TexturePoint> texture) {
  std::vector<PlyTexturedFace> result(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
    result[i] = {faces[i], 6, {texture[3 * i], texture[3 * i + 1], texture[3 * i + 2]}};
  return result;
}

}  // namespace

void write_ply(const std::filesystem::path& path, const ParticleFrame& frame) {
  check_lengths(frame);
  std::vector<PlyVertex> vertices(frame.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    vertices[i] = {frame.positions[i], frame.velocities[i], frame.fluids[i], narrow_id(frame.ids[i]),
                   frame.density_errors[i]};
  }
  OutputFile file(path);
  file.write(header(frame));
  file.write(std::span<const PlyVertex>(vertices));
  file.commit();
}

void write_ply(const std::filesystem::path& path, const DiffuseFrame& frame) {
  static_assert(sizeof(DiffuseParticle) == 8 * 4, "it is written as it lies in memory");
  OutputFile file(path);
  file.write(
      fmt::format("ply\nformat binary_little_endian 1.0\ncomment Meniscus spray, foam and bubbles at {:.7g} "
                  "s; metres, metres "
                  "a second\n"
                  "element vertex {}\n"
                  "property float x\nproperty float y\nproperty float z\n"
                  "property float vx\nproperty float vy\nproperty float vz\n"
                  "property float life\nproperty uint kind\n"
                  "end_header\n",
                  frame.time, frame.particles.size()));
  file.write(frame.particles);
  file.commit();
}

void write_ply(const std::filesystem::path& path, const SurfaceFrame& frame) {
  std::vector<PlySolidVertex> vertices(frame.vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i] = {frame.vertices[i], frame.velocities[i]};
  std::vector<PlyFace> faces(frame.triangles.size());
  for (std::size_t i = 0; i < faces.size(); ++i) faces[i] = {3, frame.triangles[i], frame.bodies[i]};
  OutputFile file(path);
  file.write(header(frame));
  file.write(std::span<const PlySolidVertex>(vertices));
  file.write(std::span<const PlyFace>(faces));
  file.commit();
}

void write_ply(const std::filesystem::path& path, const ClothFrame& frame) {
  const std::vector<PlyClothFace> faces = cloth_faces(frame);
  OutputFile file(path);
  file.write(header(frame));
  file.write(std::span<const PlySmoothVertex>(smooth_vertices(frame)));
  if (frame.texture.empty())
    file.write(std::span<const PlyClothFace>(faces));
  else
    file.write(std::span<const PlyTexturedFace>(textured(faces, frame.texture)));
  file.commit();
}

void write_ply(const std::filesystem::path& path, const LiquidFrame& frame) {
  std::vector<PlyFace> faces(frame.triangles.size());
  for (std::size_t i = 0; i < faces.size(); ++i) faces[i] = {3, frame.triangles[i], frame.fluids[i]};
  OutputFile file(path);
  file.write(header(frame));
  file.write(std::span<const PlySmoothVertex>(smooth_vertices(frame)));
  file.write(std::span<const PlyFace>(faces));
  file.commit();
}

void write_ply(const std::filesystem::path& path, const RopeFrame& frame) {
  std::vector<PlyRopeVertex> vertices(frame.vertices.size());
  std::vector<PlyEdge> edges;
  for (std::size_t i = 0; i < frame.lines.size(); ++i) {
    const std::vector<uint32_t>& line = frame.lines[i];
    for (const uint32_t v : line) vertices[v] = {frame.vertices[v], frame.velocities[v], frame.radii[i]};
    for (std::size_t k = 1; k < line.size(); ++k)
      edges.push_back({line[k - 1], line[k], static_cast<uint32_t>(i)});
  }
  OutputFile file(path);
  file.write(header(frame, edges.size()));
  file.write(std::span<const PlyRopeVertex>(vertices));
  file.write(std::span<const PlyEdge>(edges));
  file.commit();
}

}  // namespace meniscus::io
