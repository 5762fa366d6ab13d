// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Writes Wavefront OBJ files.
#include "sdk/io/obj.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "sdk/files/output_file.h"
#include "sdk/io/plain_text.h"

namespace meniscus::io {
namespace {

void add_vertices(std::string& text, std::span<const Vec3> vertices) {
  for (const Vec3 p : vertices) fmt::format_to(std::back_inserter(text), "v {} {} {}\n", p.x, p.y, p.z);
}

/// Readers end a name at a blank, and a line break would begin another statement.
std::string object_name(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return c <= ' '; }, '_');
  return plain_text(name);
}

/// A line that begins an object.
std::string object_line(const std::string& name) {
  return "o " + object_name(name) + '\n';
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

/// Adds each texture coordinate once; returns its number for each corner.
std::vector<std::size_t> add_texture_points(std::string& text, std::span<const TexturePoint> texture) {
  std::map<std::pair<float, float>, std::size_t> known;
  std::vector<std::size_t> numbers;
  for (const TexturePoint p : texture) {
    const auto [found, is_new] = known.emplace(std::pair(p.u, p.v), known.size() + 1);
    if (is_new) fmt::format_to(std::back_inserter(text), "vt {} {}\n", p.u, p.v);
    numbers.push_back(found->second);
  }
  return numbers;
}

/// `objects`: one per triangle; `texture`: one per corner, or none.
template <class Frame>
void write_with_normals(const std::filesystem::path& path, const char* what, const Frame& frame,
                        std::span<const uint32_t> objects, std::span<const TexturePoint> texture = {}) {
  std::string text = fmt::format("# Meniscus {} at {:.7g} s; metres\n", what, frame.time);
  add_vertices(text, frame.vertices);
  const std::vector<std::size_t> numbers = add_texture_points(text, texture);
  for (const Vec3 n : frame.normals)
    fmt::format_to(std::back_inserter(text), "vn {:.7g} {:.7g} {:.7g}\n", n.x, n.y, n.z);
  for (std::size_t i = 0; i < frame.triangles.size(); ++i) {
    if (i == 0 || objects[i] != objects[i - 1]) text += object_line(frame.names[objects[i]]);
    text += 'f';
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string number = numbers.empty() ? "" : std::to_string(numbers[3 * i + k]);
      fmt::format_to(std::back_inserter(text), " {0}/{1}/{0}", frame.triangles[i][k] + 1, number);
    }
    text += '\n';
  }
  write_text(path, text);
}

}  // namespace

void write_obj(const std::filesystem::path& path, const ParticleFrame& frame) {
  std::string text = fmt::format("# Meniscus particles at {:.7g} s; metres\n", frame.time);
  add_vertices(text, frame.positions);
  for (std::size_t i = 1; i <= frame.size(); ++i) fmt::format_to(std::back_inserter(text), "p {}\n", i);
  write_text(path, text);
}

void write_obj(const std::filesystem::path& path, const DiffuseFrame& frame) {
  std::string text = fmt::format("# Meniscus spray, foam and bubbles at {:.7g} s; metres\n", frame.time);
  std::vector<Vec3> positions;
  for (const DiffuseParticle& p : frame.particles) positions.push_back(p.position);
  add_vertices(text, positions);
  for (std::size_t i = 1; i <= positions.size(); ++i) fmt::format_to(std::back_inserter(text), "p {}\n", i);
  write_text(path, text);
}

void write_obj(const std::filesystem::path& path, const SurfaceFrame& frame) {
  std::string text = fmt::format("# Meniscus solids at {:.7g} s; metres\n", frame.time);
  add_vertices(text, frame.vertices);
  for (std::size_t i = 0; i < frame.triangles.size(); ++i) {
    if (i == 0 || frame.bodies[i] != frame.bodies[i - 1]) {
      text += object_line(frame.names[frame.bodies[i]]);
    }
    const auto& [a, b, c] = frame.triangles[i];
    fmt::format_to(std::back_inserter(text), "f {} {} {}\n", a + 1, b + 1, c + 1);
  }
  write_text(path, text);
}

void write_obj(const std::filesystem::path& path, const ClothFrame& frame) {
  write_with_normals(path, "cloth", frame, frame.pieces, frame.texture);
}

void write_obj(const std::filesystem::path& path, const LiquidFrame& frame) {
  write_with_normals(path, "liquid", frame, frame.fluids);
}

void write_obj(const std::filesystem::path& path, const RopeFrame& frame) {
  std::string text = fmt::format("# Meniscus ropes at {:.7g} s; metres\n", frame.time);
  add_vertices(text, frame.vertices);
  for (std::size_t i = 0; i < frame.lines.size(); ++i) {
    text += object_line(frame.names[i]) + 'l';
    for (const uint32_t v : frame.lines[i]) fmt::format_to(std::back_inserter(text), " {}", v + 1);
    text += '\n';
  }
  write_text(path, text);
}

}  // namespace meniscus::io
