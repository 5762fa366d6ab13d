// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Meshes of numbered files.
#include <gtest/gtest.h>

#include <map>

#include "collision/mesh/sequence.h"
#include "pbd/math/vec.h"
#include "tests/expect_error.h"

namespace meniscus::tests {
namespace {

using collision::load_sequence;
using collision::MeshSequence;
using collision::numbered_path;

/// A tent of two triangles, as an indexed file.
std::string tent(float height) {
  return "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 1 " + std::to_string(height) + " 1\nf 1 2 3\nf 2 4 3\n";
}

/// Two triangles with vertices of their own. They share an edge where `gap` is 0.
std::string pair_of(float height, float gap) {
  const std::string h = std::to_string(height), g = std::to_string(gap);
  return "solid pair\nfacet normal 0 1 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 "
         "1\nendloop\nendfacet\n"
         "facet normal 0 1 0\nouter loop\nvertex 1 " +
         g + " 0\nvertex 1 " + h + " 1\nvertex 0 " + g + " 1\nendloop\nendfacet\nendsolid pair\n";
}

class MeshSequenceTest : public testing::Test {
 protected:
  std::map<std::string, std::string> files_;
  FileReader reader_ = [this](const std::string& name) -> std::optional<std::string> {
    const auto found = files_.find(name);
    return found == files_.end() ? std::nullopt : std::optional(found->second);
  };

  void refused(ErrorCode code, const std::string& text, const std::string& pattern, int last) {
    expect_error(code, text, [&] { load_sequence(pattern, 1, last, 1, reader_); });
  }
};

TEST(NumberedPath, PutsInTheNumber) {
  EXPECT_EQ(numbered_path("a_%d.obj", 7), "a_7.obj");
  EXPECT_EQ(numbered_path("a_%04d.obj", 7), "a_0007.obj");
  EXPECT_EQ(numbered_path("%02d/a.obj", 123), "123/a.obj");
  for (const char* bad : {"a.obj", "a_%d_%d.obj", "a_%s.obj", "a_%04x.obj", "a_%", "a_%0"})
    expect_error(ErrorCode::invalid_argument, bad, [&] { numbered_path(bad, 1); });
}

TEST_F(MeshSequenceTest, FollowsTheVerticesOfTheFirstFile) {
  for (int k = 1; k <= 3; ++k) files_["t" + std::to_string(k) + ".obj"] = tent(static_cast<float>(k));
  const MeshSequence sequence = load_sequence("t%d.obj", 1, 3, 2, reader_);
  ASSERT_EQ(sequence.frames.size(), 3u);
  ASSERT_EQ(sequence.mesh.vertices.size(), 4u);
  EXPECT_EQ(sequence.mesh.triangles.size(), 2u);
  for (size_t k = 0; k < 3; ++k) {
    float highest = 0;
    for (const Vec3 v : sequence.frames[k]) highest = std::max(highest, v.y);
    EXPECT_FLOAT_EQ(highest, 2 * static_cast<float>(k + 1));
  }
}

TEST_F(MeshSequenceTest, MergesVerticesInAllFiles) {
  files_ = {{"p1.stl", pair_of(0.5f, 0)}, {"p2.stl", pair_of(1, 0)}};
  const MeshSequence sequence = load_sequence("p%d.stl", 1, 2, 1, reader_);
  EXPECT_EQ(sequence.frames[0].size(), 4u);
  EXPECT_EQ(sequence.frames[1].size(), 4u);
}

TEST_F(MeshSequenceTest, NamesTheFileThatDoesNotFit) {
  files_ = {{"t1.obj", tent(1)}, {"t2.obj", tent(2)}};
  refused(ErrorCode::io, "t3.obj", "t%d.obj", 3);
  files_["t2.obj"] = tent(2) + "v 3 3 3\nf 2 4 5\n";
  refused(ErrorCode::mesh, "t2.obj", "t%d.obj", 2);
  files_["t2.obj"] = "v 0 0 0\nv 1 0 0\nv 0 0 1\nv nan 1 1\nf 1 2 3\nf 2 4 3\n";
  refused(ErrorCode::mesh, "t2.obj", "t%d.obj", 2);
}

TEST_F(MeshSequenceTest, RefusesOtherTrianglesWithRepeatedVertices) {
  files_ = {{"p1.stl", pair_of(0.5f, 0)}, {"p2.stl", pair_of(0.5f, 0.01f)}};
  refused(ErrorCode::mesh, "p2.stl", "p%d.stl", 2);
}

}  // namespace
}  // namespace meniscus::tests
