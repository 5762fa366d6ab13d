// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads the meshes of numbered files.
#include "collision/mesh/sequence.h"

#include <meniscus/error.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "collision/mesh/clean.h"
#include "collision/mesh/soup.h"
#include "collision/mesh/tuning.h"
#include "pbd/math/vec.h"

namespace meniscus::collision {

namespace {

/// %d or %04d in a pattern.
struct Number {
  size_t begin, end;
  size_t width;  ///< least number of digits

  static Number in(const std::string& pattern, size_t from) {
    const size_t begin = pattern.find('%', from);
    if (begin == std::string::npos) return {begin, begin, 0};
    size_t at = begin + 1;
    Number number{begin, std::string::npos, 1};
    if (at < pattern.size() && pattern[at] == '0' && at + 1 < pattern.size()) {
      const char width = pattern[at + 1];
      if (width >= '1' && width <= '9') number.width = static_cast<size_t>(width - '0'), at += 2;
    }
    if (at < pattern.size() && pattern[at] == 'd') number.end = at + 1;
    return number;
  }
};

[[noreturn]] void refuse(const std::string& file, const std::string& why) {
  throw Error(ErrorCode::mesh, "mesh file '" + file + "' " + why);
}

std::string counts_of(const TriangleMesh& mesh) {
  return std::to_string(mesh.vertices.size()) + " vertices and " + std::to_string(mesh.triangles.size()) +
         " triangles";
}

/// What the first file determines for all.
struct FirstFile {
  std::string file;
  TriangleMesh soup;
  CleanedMesh clean;
  std::vector<uint32_t> kept;  ///< by vertex of a used triangle: the clean vertex that it was merged into

  FirstFile(std::string name, TriangleMesh triangles, CleanedMesh cleaned)
      : file(std::move(name)),
        soup(std::move(triangles)),
        clean(std::move(cleaned)),
        kept(soup.vertices.size(), no_vertex) {
    // Faces may have been turned, so corners are found by their places.
    for (size_t t = 0; t < clean.sources.size(); ++t) {
      for (const uint32_t v : soup.triangles[clean.sources[t]]) kept[v] = nearest(clean.mesh.triangles[t], v);
    }
  }

  std::vector<Vec3> vertices_of(const std::string& other_file, const TriangleMesh& other) const {
    if (other.vertices.size() != soup.vertices.size() || other.triangles.size() != soup.triangles.size())
      refuse(other_file, "has " + counts_of(other) + ", and '" + file + "' has " + counts_of(soup) +
                             ": all frames of a sequence must have the same");
    for (size_t t = 0; t < soup.triangles.size(); ++t) {
      if (other.triangles[t] != soup.triangles[t])
        refuse(other_file, "has other vertices in triangle " + std::to_string(t) + " than '" + file +
                               "': all frames of a sequence must have the same triangles");
    }
    check_merged(other_file, other);
    std::vector<Vec3> vertices;
    for (const uint32_t v : clean.vertex_sources) vertices.push_back(other.vertices[v]);
    return vertices;
  }

 private:
  static constexpr uint32_t no_vertex = 0xffffffff;

  uint32_t nearest(const std::array<uint32_t, 3>& corners, uint32_t v) const {
    return *std::ranges::min_element(
        corners, {}, [&](uint32_t corner) { return length(clean.mesh.vertices[corner] - soup.vertices[v]); });
  }

  /// A file that repeats vertices for each face has no other sign of changed triangles.
  void check_merged(const std::string& other_file, const TriangleMesh& other) const {
    const Aabb box = bounds(other);
    const auto reach =
        static_cast<float>(mesh_tuning::sequence_weld_distance * double{length(box.upper - box.lower)});
    for (uint32_t v = 0; v < kept.size(); ++v) {
      if (kept[v] == no_vertex) continue;
      const uint32_t same = clean.vertex_sources[kept[v]];
      if (!(length(other.vertices[v] - other.vertices[same]) <= reach))
        refuse(other_file, "has its vertices " + std::to_string(same) + " and " + std::to_string(v) +
                               " apart, which are at one place in '" + file +
                               "': all frames of a sequence must have the same triangles");
    }
  }
};

}  // namespace

std::string numbered_path(const std::string& pattern, int number) {
  const Number place = Number::in(pattern, 0);
  if (place.end == std::string::npos || Number::in(pattern, place.end).begin != std::string::npos)
    throw Error(ErrorCode::invalid_argument,
                "DrivenFiles::files is '" + pattern +
                    "'; it must have the number of a frame once, as %d or as %04d with leading zeros");
  std::string digits = std::to_string(number);
  digits.insert(0, place.width > digits.size() ? place.width - digits.size() : 0, '0');
  return pattern.substr(0, place.begin) + digits + pattern.substr(place.end);
}

MeshSequence load_sequence(const std::string& pattern, int first, int last, float scale,
                           const FileReader& files) {
  const std::string first_file = numbered_path(pattern, first);
  const MeshSource source(first_file, scale, files);
  const FirstFile all(first_file, load_soup(source), load_cleaned_mesh(source));
  MeshSequence sequence{all.clean.mesh, {all.clean.mesh.vertices}};
  for (int number = first + 1; number <= last; ++number) {
    const std::string file = numbered_path(pattern, number);
    sequence.frames.push_back(all.vertices_of(file, load_soup(MeshSource(file, scale, files))));
  }
  return sequence;
}

}  // namespace meniscus::collision
