// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bodies for tests of worlds, and a folder for their meshes.
#pragma once

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "tests/expect_error.h"
#include "tests/worlds.h"

namespace meniscus::tests {

inline constexpr float infinity = std::numeric_limits<float>::infinity();
inline constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
inline constexpr float pi = 3.14159265f;

inline BodyDef body(const Geometry& geometry, Vec3 position = {0, 0, 0}) {
  BodyDef def;
  def.geometry = geometry;
  def.pose.position = position;
  return def;
}

inline BodyDef kinematic(const Geometry& geometry, Vec3 position = {0, 0, 0}) {
  BodyDef def = body(geometry, position);
  def.motion = BodyMotion::kinematic;
  return def;
}

inline JointDef joint(const JointKind& kind, BodyId a, std::optional<BodyId> b = {}) {
  JointDef def;
  def.a = a;
  def.b = b;
  def.kind = kind;
  return def;
}

/// A tank that has no lid, with its bottom's centre at the origin.
inline ShapeDef open_tank(Vec3 half_extents) {
  return shape(ContainerGeometry{half_extents, {{Face::y_high, {}}}}, {0, half_extents.y, 0});
}

/// On a device, or a device with a solver.
template <class Case>
WorldDef weightless(const Case& which, float spacing = 0.05f) {
  WorldDef def = world_def(which, spacing);
  def.gravity = {0, 0, 0};
  return def;
}

inline void expect_near(Vec3 value, Vec3 expected, float tolerance) {
  EXPECT_NEAR(value.x, expected.x, tolerance);
  EXPECT_NEAR(value.y, expected.y, tolerance);
  EXPECT_NEAR(value.z, expected.z, tolerance);
}

/// A folder that goes with what made it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "meniscus_bodies_XXXXXX").string();
    if (mkdtemp(name.data())) folder_ = name;
  }
  ~TemporaryFolder() { std::filesystem::remove_all(folder_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  std::string missing() const { return (folder_ / "missing.obj").string(); }

 private:
  std::filesystem::path folder_;
};

/// A box of 1 × 2 × 3 file units, its lowest corner at the origin.
inline const char* const brick_obj =
    "v 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 2 0\nv 0 0 3\nv 1 0 3\nv 1 2 3\nv 0 2 3\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 1 5 8 4\n";
/// The same without its last face, which is what makes the edges of face 0 open.
inline const char* const open_brick_obj =
    "v 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 2 0\nv 0 0 3\nv 1 0 3\nv 1 2 3\nv 0 2 3\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\n";

}  // namespace meniscus::tests
