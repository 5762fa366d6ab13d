// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of how defects of meshes are found.
#include "collision/mesh/defects.h"

#include <gtest/gtest.h>

#include "collision/mesh/clean.h"
#include "collision/mesh/orient.h"
#include "tests/unit/collision/solid_shapes.h"
#include "tests/unit/moebius_strip.h"

namespace meniscus::collision {
namespace {

const TriangleMesh unit_box = box_mesh({0, 0, 0}, {1, 1, 1});

TriangleMesh oriented(TriangleMesh mesh) {
  orient_faces(mesh);
  return mesh;
}

// Turns about one face in `every`.
TriangleMesh muddled(TriangleMesh mesh, float every, uint32_t seed) {
  Noise noise(seed);
  for (auto& t : mesh.triangles) {
    if (noise.next() * every < 1) std::swap(t[1], t[2]);
  }
  return mesh;
}

TEST(MeshDefects, SolidsHaveNone) {
  for (const TriangleMesh& mesh : {unit_box, ball_mesh(1, 4), cup_mesh(0.1f, 0.01f)}) {
    EXPECT_TRUE(find_defects(mesh).none());
  }
}

TEST(MeshDefects, AMissingFaceLeavesItsThreeEdgesOpen) {
  TriangleMesh mesh = ball_mesh(1, 3);
  mesh.triangles.erase(mesh.triangles.begin() + 100);
  const MeshDefects defects = find_defects(mesh);
  EXPECT_EQ(defects.open_edges.size(), 3u);
  EXPECT_TRUE(defects.non_manifold_edges.empty());
  EXPECT_TRUE(defects.self_intersections.empty());
}

TEST(MeshDefects, BoxesThatShareAnEdgeAreNotManifoldThere) {
  const TriangleMesh mesh = clean_mesh(joined(unit_box, box_mesh({1, 1, 0}, {2, 2, 1})));
  const MeshDefects defects = find_defects(mesh);
  ASSERT_EQ(defects.non_manifold_edges.size(), 1u);
  const MeshDefect edge = defects.non_manifold_edges.front();
  EXPECT_LT(edge.face, 12u);
  EXPECT_GE(edge.other, 12u);
  EXPECT_TRUE(defects.open_edges.empty());
  EXPECT_TRUE(defects.self_intersections.empty());
}

TEST(MeshDefects, AFinIsNotManifold) {
  TriangleMesh mesh = unit_box;
  mesh.vertices.push_back({0.5f, 2, -1});
  mesh.triangles.push_back({2, 3, 8});  // on an edge of the top
  const MeshDefects defects = find_defects(mesh);
  EXPECT_EQ(defects.non_manifold_edges.size(), 1u);
  EXPECT_EQ(defects.open_edges.size(), 2u);
}

TEST(MeshDefects, AStripWithOneSideCannotBeRepaired) {
  const MeshDefects defects = find_defects(oriented(tests::moebius_strip<TriangleMesh>()));
  EXPECT_GE(defects.non_manifold_edges.size(), 1u);
  EXPECT_EQ(defects.open_edges.size(), 24u);
}

TEST(MeshDefects, PartsThatPassThroughOneAnotherCross) {
  const TriangleMesh mesh = joined(unit_box, box_mesh({0.53f, 0.41f, 0.37f}, {1.6f, 1.7f, 1.8f}));
  const MeshDefects defects = find_defects(mesh);
  ASSERT_FALSE(defects.self_intersections.empty());
  for (const MeshDefect& d : defects.self_intersections) {
    EXPECT_LT(d.face, 12u);
    EXPECT_GE(d.other, 12u);
  }
}

// Each edge passes through another edge or a diagonal, never through the inside of a triangle.
TEST(MeshDefects, ACrossingThroughEdgesIsFound) {
  const TriangleMesh bar = box_mesh({-0.3f, -2, -0.3f}, {0.3f, 2, 0.3f});
  EXPECT_FALSE(find_defects(joined(box_mesh({-1, -1, -1}, {1, 1, 1}), bar)).self_intersections.empty());
  const TriangleMesh across = box_mesh({-2, -0.3f, -0.3f}, {2, 0.3f, 0.3f});
  EXPECT_FALSE(find_defects(joined(across, bar)).self_intersections.empty());
}

TEST(MeshDefects, PartsThatTouchOrLieApartDoNotCross) {
  const TriangleMesh top = box_mesh({0, 1, 0}, {3, 1.2f, 3});
  const TriangleMesh leg = box_mesh({1, 0, 1}, {1.5f, 1, 1.5f});
  const Quat turn{0.18257419f, 0.36514837f, 0.54772256f, 0.73029674f};
  for (const Pose& pose : {Pose{}, Pose{{7, -3, 2}, turn}}) {
    EXPECT_TRUE(find_defects(placed(joined(top, leg), pose)).none());
  }
  EXPECT_TRUE(find_defects(joined(ball_mesh(1, 3), ball_mesh(0.5f, 3))).none());
}

TEST(OrientFaces, MuddledFacesTurnOutwards) {
  for (const TriangleMesh& mesh : {unit_box, ball_mesh(1, 4), cup_mesh(0.1f, 0.01f)}) {
    const TriangleMesh repaired = oriented(muddled(mesh, 3, 5));
    EXPECT_NEAR(signed_volume(repaired), signed_volume(mesh), 1e-9);
    EXPECT_TRUE(find_defects(repaired).none());
    EXPECT_EQ(clean_mesh(joined(mesh, repaired)).triangles.size(), mesh.triangles.size());
    EXPECT_NEAR(signed_volume(oriented(inside_out(mesh))), signed_volume(mesh), 1e-9);
  }
}

TEST(OrientFaces, EachPartTurnsOnItsOwn) {
  const TriangleMesh far = box_mesh({5, 0, 0}, {6, 1, 1});
  EXPECT_NEAR(signed_volume(oriented(joined(inside_out(unit_box), far))), 2, 1e-5);
  // Vertices of either lie inside the other.
  const TriangleMesh near = box_mesh({0.5f, 0.5f, 0.5f}, {2, 2, 2});
  EXPECT_NEAR(signed_volume(oriented(joined(unit_box, near))), 1 + 1.5 * 1.5 * 1.5, 1e-5);
}

TEST(OrientFaces, InnerShellsOfHollowBodiesFaceInwards) {
  const TriangleMesh outer = box_mesh({0, 0, 0}, {4, 4, 4}), inner = box_mesh({1, 1, 1}, {3, 3, 3});
  const TriangleMesh core = box_mesh({1.5f, 1.5f, 1.5f}, {2.5f, 2.5f, 2.5f});
  for (const TriangleMesh& shell : {inner, inside_out(inner), muddled(inner, 3, 2)}) {
    EXPECT_NEAR(signed_volume(oriented(joined(outer, shell))), 64 - 8, 1e-4);
    EXPECT_NEAR(signed_volume(oriented(joined(inside_out(outer), joined(shell, core)))), 64 - 8 + 1, 1e-4);
  }
}

TEST(OrientFaces, AnOpenMeshAgreesWithMostOfItsFaces) {
  const TriangleMesh open = open_ball_mesh(1, 4, 0.7f);
  EXPECT_EQ(oriented(open).triangles, open.triangles);
  EXPECT_NEAR(signed_volume(oriented(muddled(open, 4, 3))), signed_volume(open), 1e-9);
}

}  // namespace
}  // namespace meniscus::collision
