// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Solids, cloth, ropes and the picture as a whole.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include "sdk/render/gl/program.h"
#include "sdk/render/gl/shader_text.h"
#include "tests/bench/harness/render_bench.h"
#include "tests/expect_error.h"

namespace meniscus::tests {
namespace {

class PictureTest : public RenderTest {
 protected:
  /// With a ground far below.
  static io::PreviewScene empty_scene() {
    io::PreviewScene scene = small_scene();
    scene.shapes = {shape(PlaneGeometry{}, {0, -50, 0})};
    return scene;
  }
  static io::PreviewScene with_body(const Geometry& geometry, Vec3 position = {0, 0, 0}) {
    io::PreviewScene scene = empty_scene();
    scene.bodies.resize(1);
    scene.bodies[0].geometry = geometry;
    scene.bodies[0].pose.position = position;
    return scene;
  }
  /// How many pixels differ clearly.
  static int changed(const io::Image& a, const io::Image& b) {
    int count = 0;
    for (int y = 0; y < a.height; ++y) {
      for (int x = 0; x < a.width; ++x) count += difference(at(a, x, y), at(b, x, y)) > 40;
    }
    return count;
  }
};

TEST_F(PictureTest, EachSolidIsSeenWhereItIs) {
  const HeightFieldGeometry hill{3, 3, 0.4f, {0, 0.1f, 0, 0.1f, 0.4f, 0.1f, 0, 0.1f, 0}};
  const HullGeometry wedge{{{-0.3f, -0.3f, 0}, {0.3f, -0.3f, 0}, {0, 0.3f, 0}, {0, 0, 0.3f}}};
  const Geometry kinds[] = {BoxGeometry{{0.3f, 0.3f, 0.3f}},
                            SphereGeometry{0.35f},
                            CapsuleGeometry{0.2f, 0.2f},
                            CylinderGeometry{0.3f, 0.3f},
                            wedge,
                            hill};
  for (const Geometry& kind : kinds) {
    io::PreviewScene scene = empty_scene();
    const io::Image nothing = draw(scene);
    scene.shapes.push_back(shape(kind, {0, -0.15f, 0}));
    const io::Image something = draw(scene);
    EXPECT_GT(difference(at(something, 80, 60), at(nothing, 80, 60)), 40) << "geometry " << kind.index();
    EXPECT_LT(difference(at(something, 10, 10), at(nothing, 10, 10)), 12) << "geometry " << kind.index();
    const int seen = changed(something, nothing);
    EXPECT_GT(seen, 400) << "geometry " << kind.index();
    EXPECT_LT(seen, 4000) << "geometry " << kind.index();
  }
}

TEST_F(PictureTest, AMeshHasTheColoursOfItsMaterials) {
  const std::filesystem::path folder = testing::TempDir();
  std::ofstream(folder / "two_tones.mtl") << "newmtl red\nKd 0.8 0.05 0.05\nnewmtl green\nKd 0.05 0.8 0.05\n";
  std::ofstream(folder / "two_tones.obj") << "mtllib two_tones.mtl\nv -0.5 -0.5 0\nv 0 -0.5 0\nv 0.5 -0.5 "
                                             "0\nv -0.5 0.5 0\nv 0 0.5 0\nv 0.5 0.5 0\n"
                                             "usemtl red\nf 1 2 5 4\nusemtl green\nf 2 3 6 5\n";
  const io::Image image = draw(with_body(MeshGeometry{(folder / "two_tones.obj").string()}));
  const Pixel left = at(image, 65, 60), right = at(image, 95, 60);
  EXPECT_GT(left.r, left.g + 60);
  EXPECT_GT(right.g, right.r + 60);
}

TEST_F(PictureTest, TheNearerSolidHidesTheOther) {
  io::PreviewScene scene = with_body(BoxGeometry{{0.2f, 0.2f, 0.2f}});
  const Pixel alone = at(draw(scene), 80, 60);
  scene.bodies.push_back(scene.bodies[0]);
  scene.bodies[1].pose.position.z = -1;
  EXPECT_EQ(difference(at(draw(scene), 80, 60), alone), 0);
  scene.bodies[1].pose.position.z = 1;
  EXPECT_GT(difference(at(draw(scene), 80, 60), alone), 30);
}

TEST_F(PictureTest, BodiesAreWhereTheirStatesSay) {
  const io::PreviewScene scene = with_body(BoxGeometry{{0.2f, 0.2f, 0.2f}});
  const io::Image nothing = draw(empty_scene());
  std::vector<BodyState> states(1);
  states[0].pose.position = {0.6f, 0, 0};
  const io::Image moved = draw(scene, {.bodies = states});
  EXPECT_LT(difference(at(moved, 80, 60), at(nothing, 80, 60)), 12);
  EXPECT_GT(difference(at(moved, 118, 60), at(nothing, 118, 60)), 40);
}

TEST_F(PictureTest, OfAContainerTheFarWallsFloorAndEdgesAreSeen) {
  io::PreviewScene scene = empty_scene();
  const io::Image nothing = draw(scene);
  scene.shapes.push_back(
      shape(ContainerGeometry{{0.6f, 0.5f, 0.6f}, {{Face::y_high, std::nullopt}}}, {0, -0.2f, -0.5f}));
  scene.camera->position = {0, 1.2f, 3};
  io::PreviewScene without = scene;
  without.shapes.pop_back();
  const io::Image with = draw(scene), plain = draw(without);
  // A box of the same size hides all that the container lets through.
  io::PreviewScene solid = without;
  solid.shapes.push_back(shape(BoxGeometry{{0.6f, 0.5f, 0.6f}}, {0, -0.2f, -0.5f}));
  const io::Image box = draw(solid);
  EXPECT_GT(changed(with, plain), 300);
  EXPECT_GT(changed(with, box), 1500);
  EXPECT_GT(difference(at(with, 80, 75), at(plain, 80, 75)), 30) << "the floor";
  EXPECT_GT(difference(at(with, 80, 50), at(plain, 80, 50)), 5) << "the far wall";
}

TEST_F(PictureTest, SolidsCastShadows) {
  io::PreviewScene scene = small_scene();
  scene.shapes = {shape(PlaneGeometry{}, {0, -0.5f, 0})};
  scene.camera = SceneCamera{{0, 3, 3}, {0, -0.5f, 0}, 35};
  const io::Image plain = draw(scene);
  // Outside of the picture, between it and the sun.
  scene.shapes.push_back(shape(BoxGeometry{{0.3f, 0.3f, 0.3f}}, {-2.05f, 2.9f, 0.59f}));
  const io::Image shaded = draw(scene);
  int dark = 0, penumbra = 0;
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) {
      const int change = sum(at(plain, x, y)) - sum(at(shaded, x, y));
      dark += change > 80;
      penumbra += change > 20 && change < 60;
    }
  }
  EXPECT_GT(dark, 150);
  EXPECT_GT(penumbra, 10) << "the shadow's edge is hard";
}

io::ClothFrame sheet(float towards_camera) {
  io::ClothFrame frame;
  frame.vertices = {{-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0.5f, 0.5f, 0}, {-0.5f, 0.5f, 0}};
  frame.normals.assign(4, {0, 0, towards_camera});
  frame.triangles = {{0, 1, 2}, {0, 2, 3}};
  frame.pieces = {0, 0};
  frame.vertex_pieces.assign(4, 0);
  frame.names = {"sheet"};
  return frame;
}

TEST_F(PictureTest, ClothIsSeenFromBothSidesAndDarkerAtTheBack) {
  io::PreviewScene scene = empty_scene();
  scene.cloth_colors = {{0.8f, 0.1f, 0.1f}};
  const Pixel front = at(draw(scene, {.cloth = sheet(1)}), 80, 60),
              back = at(draw(scene, {.cloth = sheet(-1)}), 80, 60);
  EXPECT_GT(front.r, front.b + 60);
  EXPECT_GT(back.r, back.b + 30);
  EXPECT_LT(back.r, front.r - 25);
}

TEST_F(PictureTest, ARopeIsATubeOfItsRadius) {
  io::RopeFrame frame;
  frame.vertices = {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}};
  frame.lines = {{0, 1, 2}};
  frame.radii = {0.1f};
  io::PreviewScene scene = empty_scene();
  scene.rope_colors = {{0.8f, 0.1f, 0.1f}};
  const io::Image nothing = draw(scene), image = draw(scene, {.ropes = frame});
  int rows = 0;
  for (int y = 0; y < 120; ++y) rows += difference(at(image, 90, y), at(nothing, 90, y)) > 40;
  // 120 pixels are 1.89 m, 3 m away.
  EXPECT_NEAR(rows, 0.2 / 1.89 * 120, 2.5);
}

TEST_F(PictureTest, EdgesAreSmooth) {
  io::PreviewScene scene = with_body(BoxGeometry{{0.4f, 0.4f, 0.4f}});
  scene.bodies[0].pose.rotation = about_z(20);
  const io::Image image = draw(scene), nothing = draw(empty_scene());
  int between = 0;
  for (int y = 1; y < 119; ++y) {
    for (int x = 1; x < 159; ++x) {
      const int here = difference(at(image, x, y), at(nothing, x, y));
      const int left = difference(at(image, x - 1, y), at(nothing, x - 1, y)),
                right = difference(at(image, x + 1, y), at(nothing, x + 1, y));
      // A step from nothing to all with something in between.
      between += std::min(left, right) < 12 && std::max(left, right) > 60 && here > 20 &&
                 here < std::max(left, right) - 20;
    }
  }
  EXPECT_GT(between, 40);
}

TEST_F(PictureTest, EqualInputGivesEqualBytes) {
  const io::PreviewScene scene = with_body(SphereGeometry{0.3f});
  const Water water(points_where(0.05f, {0.5f, 0.3f, 0.5f}, [](Vec3) { return true; }));
  EXPECT_EQ(draw(scene, water.moment()).rgb, draw(scene, water.moment()).rgb);
}

TEST_F(PictureTest, OneRendererDrawsOneFrameAfterTheOther) {
  const io::PreviewScene scene = empty_scene();
  const Water water(points_where(0.05f, {0.5f, 0.3f, 0.5f}, [](Vec3) { return true; }));
  render::Renderer renderer(scene, water.moment());
  const io::Image first = renderer.draw(water.moment());
  const io::Image empty = renderer.draw({});
  EXPECT_GT(changed(first, empty), 2000);
  EXPECT_EQ(renderer.draw(water.moment()).rgb, first.rgb);
}

TEST_F(PictureTest, ThroughOpeningsOneSeesWhatIsBehind) {
  io::PreviewScene scene = empty_scene();
  scene.camera->position = {0, 1.2f, 3};
  const auto drawn = [&](std::vector<Opening> openings) {
    openings.push_back({Face::y_high, std::nullopt});
    scene.shapes.push_back(shape(ContainerGeometry{{0.6f, 0.5f, 0.6f}, openings}, {0, -0.2f, -0.5f}));
    const io::Image image = draw(scene);
    scene.shapes.pop_back();
    return image;
  };
  const Aabb hole{{-0.4f, -0.4f, -0.4f}, {0.4f, 0.4f, 0.4f}};
  const io::Image closed = drawn({}), open = drawn({{Face::y_low, hole}, {Face::z_low, hole}}),
                  without = drawn({{Face::y_low, std::nullopt}, {Face::z_low, std::nullopt}});
  EXPECT_GT(difference(at(closed, 80, 75), at(open, 80, 75)), 30) << "the floor";
  EXPECT_LT(difference(at(without, 80, 75), at(open, 80, 75)), 3) << "the hole in it";
  EXPECT_GT(difference(at(closed, 80, 48), at(open, 80, 48)), 5) << "the far wall";
  EXPECT_LT(difference(at(without, 80, 48), at(open, 80, 48)), 3) << "the hole in that";
}

TEST_F(PictureTest, VesselsMoveFromFrameToFrame) {
  const io::PreviewScene scene =
      with_body(ContainerGeometry{{0.3f, 0.3f, 0.3f}, {{Face::y_high, std::nullopt}}});
  render::Renderer renderer(scene, {});
  std::vector<BodyState> states(1);
  const io::Image first = renderer.draw({.bodies = states});
  states[0].pose = {{0.5f, 0.2f, 0}, {0, 0, 0.3826834f, 0.9238795f}};
  EXPECT_GT(changed(first, renderer.draw({.bodies = states})), 500);
  states[0].pose = {};
  EXPECT_EQ(renderer.draw({.bodies = states}).rgb, first.rgb);
}

TEST_F(PictureTest, ACameraThatMovesSeesSolidsAnew) {
  io::PreviewScene scene = with_body(BoxGeometry{{0.2f, 0.2f, 0.2f}});
  scene.shapes.push_back(
      shape(ContainerGeometry{{0.6f, 0.5f, 0.6f}, {{Face::y_high, std::nullopt}}}, {0, -0.2f, -0.5f}));
  render::Renderer renderer(scene, {});
  const SceneCamera here = renderer.camera(), aside{here.position, {0.3f, 0, 0}, here.field_of_view};
  const io::Image first = renderer.draw({});
  renderer.set_camera(aside);
  EXPECT_GT(changed(first, renderer.draw({})), 1000);
  renderer.set_camera(here);
  EXPECT_EQ(renderer.draw({}).rgb, first.rgb);
}

TEST_F(PictureTest, BodiesMoveFromFrameToFrame) {
  const io::PreviewScene scene = with_body(BoxGeometry{{0.2f, 0.2f, 0.2f}});
  render::Renderer renderer(scene, {});
  std::vector<BodyState> states(1);
  const io::Image first = renderer.draw({.bodies = states});
  states[0].pose.position = {0.6f, 0, 0};
  EXPECT_GT(changed(first, renderer.draw({.bodies = states})), 300);
  states[0].pose.position = {0, 0, 0};
  EXPECT_EQ(renderer.draw({.bodies = states}).rgb, first.rgb);
}

TEST_F(PictureTest, BadInputIsRefusedByName) {
  io::PreviewScene scene = with_body(BoxGeometry{});
  const std::vector<BodyState> states(2);
  expect_error(ErrorCode::invalid_argument, "states has 2", [&] { draw(scene, {.bodies = states}); });
  const std::vector<Ellipsoid> ellipsoids(3);
  expect_error(ErrorCode::invalid_argument, "fluids has 0", [&] { draw(scene, {.ellipsoids = ellipsoids}); });
  render::RenderSettings balls;
  balls.anisotropic = false;
  const std::vector<uint32_t> fluids(3);
  expect_error(ErrorCode::invalid_argument, "positions has 0", [&] {
    render::Renderer(scene, {}, balls).draw({.ellipsoids = ellipsoids, .fluids = fluids});
  });
  scene.width = 0;
  expect_error(ErrorCode::invalid_argument, "width is 0", [&] { draw(scene); });
}

TEST_F(PictureTest, MorePixelsThanBuffersHoldAreAnError) {
  GLint64 bytes = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
  if (bytes >= GLint64{4} * 16384 * 16384) GTEST_SKIP() << "this OpenGL's buffers hold " << bytes << " bytes";
  render::Renderer renderer(small_scene(), {});
  expect_error(ErrorCode::capacity, "16384 x 16384", [&] { renderer.set_size(16384, 16384); });
  EXPECT_EQ(renderer.draw({}).width, small_scene().width) << "it goes on as it was";
}

TEST_F(PictureTest, ABrokenShaderIsNamed) {
  expect_error(ErrorCode::not_found, "no shader called nowhere.glsl",
               [] { render::Program("nowhere.glsl", "solids/nothing.frag.glsl"); });
  // A file without a main is no program.
  expect_error(ErrorCode::device, "light/sky.glsl",
               [] { render::Program("screen/screen.vert.glsl", "light/sky.glsl"); });
}

TEST(ShaderText, IncludesAreThere) {
  const std::string text = render::shader_text("light/fluid.comp.glsl");
  EXPECT_EQ(text.find("#include"), std::string::npos);
  EXPECT_NE(text.find("uniform Frame"), std::string::npos);
}

}  // namespace
}  // namespace meniscus::tests
