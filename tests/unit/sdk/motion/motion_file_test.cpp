// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Motions of bodies from files.
#include <gtest/gtest.h>
#include <meniscus/meniscus.h>
#include <meniscus/scene.h>
#include <sys/resource.h>

#include <cmath>
#include <numbers>

#include "pbd/math/vec.h"
#include "tests/expect_error.h"

namespace meniscus::tests {
namespace {

constexpr float right_angle = std::numbers::pi_v<float> / 2;

FileReader only(const std::string& text) {
  return [text](const std::string&) { return std::optional(text); };
}

std::vector<Keyframe> read_usda(const std::string& text, const std::string& prim = {}) {
  return read_keyframes({.file = "arm.usda", .prim = prim}, only("#usda 1.0\n" + text));
}

void expect_near(Vec3 a, Vec3 b, float most) {
  EXPECT_LT(length(a - b), most) << a.x << ", " << a.y << ", " << a.z;
}

// Two prims: the one below turns about z at the end of an arm that moves along x, in centimetres.
constexpr const char* arm = R"((
    defaultPrim = "World"
    framesPerSecond = 30
    metersPerUnit = 0.01
    timeCodesPerSecond = 25
    upAxis = "Y"
)

def Xform "World" (
    kind = "assembly" # a comment
)
{
    custom string note = "it says } and ="
    def Xform "Arm"
    {
        double3 xformOp:translate.timeSamples = {
            0: (0, 100, 0),
            50: (200, 100, 0),
        }
        uniform token[] xformOpOrder = ["xformOp:translate"]

        def Xform "Hand" (
            prepend apiSchemas = ["PhysicsRigidBodyAPI"]
        )
        {
            float xformOp:rotateZ.timeSamples = { 0: 0, 25: 90 }
            float3 xformOp:scale = (1, 1, 1)
            double3 xformOp:translate = (10, 0, 0)
            double3 xformOp:translate:pivot
            rel material:binding = </World/Looks>
            uniform token[] xformOpOrder = ["xformOp:rotateZ", "xformOp:translate", "xformOp:scale"]
        }
    }
}
)";

TEST(MotionFile, FollowsAPrimAndAllAboveIt) {
  const std::vector<Keyframe> arms = read_usda(arm, "/World/Arm");
  ASSERT_EQ(arms.size(), 2u);
  EXPECT_FLOAT_EQ(arms[1].time, 2);
  expect_near(arms[1].pose.position, {2, 1, 0}, 1e-6f);
  const std::vector<Keyframe> hands = read_usda(arm, "/World/Arm/Hand");
  expect_near(hands.front().pose.position, {0.1f, 1, 0}, 1e-6f);
  expect_near(hands.back().pose.position, {2, 1.1f, 0}, 1e-6f);
  expect_near(rotate(hands.back().pose.rotation, {1, 0, 0}), {0, 1, 0}, 1e-6f);
}

TEST(MotionFile, TurnsTheWholeWayBetweenTwoSamples) {
  const std::vector<Keyframe> turn = read_usda(R"(def Xform "Wheel" {
    float3 xformOp:rotateXYZ.timeSamples = { 0: (0, 0, 0), 24: (0, 360, 0) }
    uniform token[] xformOpOrder = ["xformOp:rotateXYZ"]
  })");
  ASSERT_GT(turn.size(), 8u);
  EXPECT_FLOAT_EQ(turn.back().time, 1);  // 24 time codes a second, where the file says nothing
  for (const Keyframe& k : turn) {
    const float angle = 4 * right_angle * k.time;
    expect_near(rotate(k.pose.rotation, {1, 0, 0}), {std::cos(angle), 0, -std::sin(angle)}, 1e-5f);
  }
  for (size_t k = 1; k < turn.size(); ++k) {
    const float cosine =
        dot(rotate(turn[k].pose.rotation, {1, 0, 0}), rotate(turn[k - 1].pose.rotation, {1, 0, 0}));
    EXPECT_GT(cosine, std::cos(right_angle / 15));
  }
}

TEST(MotionFile, KnowsAllOperations) {
  // A pivot, a quaternion with w first, and rotations about x before those about z.
  const std::vector<Keyframe> a = read_usda(R"(( metersPerUnit = 1 )
  def Xform "A" {
    double3 xformOp:translate:pivot = (1, 0, 0)
    quatf xformOp:orient.timeSamples = { 0: (1, 0, 0, 0), 24: (0.70710678, 0, 0, 0.70710678) }
    uniform token[] xformOpOrder = ["xformOp:translate:pivot", "xformOp:orient", "!invert!xformOp:translate:pivot"]
  })");
  expect_near(to_world(a.back().pose, {2, 0, 0}), {1, 1, 0}, 1e-6f);
  const std::vector<Keyframe> b = read_usda(R"(( metersPerUnit = 1 )
  def Xform "B" {
    float3 xformOp:rotateXYZ.timeSamples = { 0: (90, 0, 90) }
    uniform token[] xformOpOrder = ["xformOp:rotateXYZ"]
  })");
  expect_near(rotate(b[0].pose.rotation, {0, 1, 0}), {0, 0, 1}, 1e-6f);
  expect_near(rotate(b[0].pose.rotation, {1, 0, 0}), {0, 1, 0}, 1e-6f);
  // Rows, for vectors from the left: a turn of 90 degrees about z, and a translation.
  const std::vector<Keyframe> c = read_usda(R"(( metersPerUnit = 1 )
  def Xform "C" {
    matrix4d xformOp:transform.timeSamples = {
      0: ( (0, 1, 0, 0), (-1, 0, 0, 0), (0, 0, 1, 0), (3, 4, 5, 1) )
    }
    uniform token[] xformOpOrder = ["xformOp:transform"]
  })");
  expect_near(to_world(c[0].pose, {1, 0, 0}), {3, 5, 5}, 1e-6f);
  // Between two matrices a body stays rigid, and between two quaternions it turns at a constant rate.
  const std::vector<Keyframe> d = read_usda(R"(( metersPerUnit = 1 )
  def Xform "Up" {
    double3 xformOp:translate.timeSamples = { 0: (0, 0, 0), 8: (0, 8, 0), 24: (0, 24, 0) }
    uniform token[] xformOpOrder = ["xformOp:translate"]
    def Xform "D" {
      matrix4d xformOp:transform.timeSamples = {
        0: ( (1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1) ),
        24: ( (0, 1, 0, 0), (-1, 0, 0, 0), (0, 0, 1, 0), (3, 0, 0, 1) )
      }
      quatf xformOp:orient.timeSamples = { 0: (1, 0, 0, 0), 24: (0.70710678, 0, 0, 0.70710678) }
      uniform token[] xformOpOrder = ["xformOp:transform", "xformOp:orient"]
    }
  })",
                                            "/Up/D");
  ASSERT_EQ(d.size(), 3u);
  expect_near(d[1].pose.position, {1, 8, 0}, 1e-6f);
  expect_near(rotate(d[1].pose.rotation, {1, 0, 0}), {0.5f, std::sqrt(0.75f), 0}, 1e-6f);
}

TEST(MotionFile, RefusesWhatItCannotFollow) {
  const auto refused = [](const std::string& named, const std::string& text, const std::string& prim = {}) {
    expect_error(ErrorCode::parse, named, [&] { read_usda(text, prim); });
  };
  refused("/World/Arm, /World/Arm/Hand", arm);
  refused("no prim '/World/Leg'", arm, "/World/Leg");
  refused("no time samples", arm, "/World");
  const auto with = [](const std::string& op) {
    return "def Xform \"A\" {\n" + op +
           "\nuniform token[] xformOpOrder = [\"xformOp:scale\", \"xformOp:translate\"]\n}";
  };
  const std::string moves = "double3 xformOp:translate.timeSamples = { 0: (0, 0, 0), 1: (1, 0, 0) }";
  refused("xformOp:scale of /A scales", with("float3 xformOp:scale = (2, 2, 2)\n" + moves));
  refused("xformOp:scale of /A has no value", with(moves));
  refused(
      "not finite",
      with("float3 xformOp:scale = (1, 1, 1)\ndouble3 xformOp:translate.timeSamples = { 0: (nan, 0, 0) }"));
  refused("a of /A has no value", R"(def "A" { uniform token[] xformOpOrder = ["a"] })", "/A");
  refused("line 3", "def Xform \"A\" {\n = }");
  refused("ends too early", "def Xform \"A\" {");
  expect_error(ErrorCode::parse, "#usda", [] { read_keyframes({.file = "a.usda"}, only("PXR-USDC")); });
  expect_error(ErrorCode::invalid_argument, "usdcat", [] { read_keyframes({.file = "a.usdc"}, only("")); });
  expect_error(ErrorCode::io, "not there", [] { read_keyframes({.file = "/nowhere/a.usda"}); });
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int k = 0; k < times; ++k) all += text;
  return all;
}

/// Kilobytes, the most so far.
long memory() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return used.ru_maxrss;
}

TEST(MotionFile, ASmallFileTakesLittleMemory) {
  const std::string moves = R"(float xformOp:rotateZ.timeSamples = { 0: 0, 24: 90 }
    uniform token[] xformOpOrder = ["xformOp:rotateZ"])";
  const std::string parent = std::string(100'000, 'p'), skipped(2'000'000, '(');
  const std::string text = "def \"" + parent + "\" { custom int[] a = " + skipped +
                           std::string(skipped.size(), ')') + repeated("def \"c\" {}\n", 5000) +
                           "def \"last\" {\n" + moves + "\n} }";
  const std::string file = "#usda 1.0\n" + text;
  const long before = memory();
  EXPECT_EQ(read_keyframes({.file = "arm.usda", .prim = "/" + parent + "/last"}, only(file)).back().time, 1);
  EXPECT_LT(memory() - before, 100'000);
}

TEST(MotionFile, HasBounds) {
  const auto refused = [](const std::string& named, const std::string& text) {
    expect_error(ErrorCode::parse, named, [&] { read_usda(text); });
  };
  refused("more than 256 deep", repeated("def \"a\" {", 100'000));
  refused("ends too early", "int a = " + std::string(1'000'000, '('));
  const auto turning = [](const std::string& samples, const std::string& more = {}) {
    return "def \"Wheel\" { float xformOp:rotateZ.timeSamples = { " + samples +
           "}\nuniform token[] xformOpOrder = [" + more + "\"xformOp:rotateZ\"] }";
  };
  EXPECT_EQ(read_usda(turning("0: 0, 24: 1080000")).size(), 216'001u) << "3,000 turns, in steps of 5 degrees";
  refused("more than 1000000 keyframes", turning("0: 0, 1: 999999, 2: 0, 3: 999999, 4: 0, 5: 999999, 6: 0"));
  refused("more than 1000000 keyframes", turning("0: 0, 1: 1e300"));
  refused("more than 1024 operations", turning("0: 0, 1: 1", repeated("\"xformOp:rotateZ\", ", 1024)));
  refused("pose 0 at a time or place beyond all floats",
          "( timeCodesPerSecond = 1e-300 )\n" + turning("1: 0, 2: 1"));
  std::string moving;
  for (int k = 0; k < 100; ++k) moving += turning("0: 0, 1: 1");
  refused("and 92 more", moving);
  expect_error(ErrorCode::parse, "67108864 bytes",
               [] { read_keyframes({.file = "a.csv"}, only(std::string((size_t{1} << 26) + 1, ' '))); });
}

TEST(MotionFile, ReadsLinesOfPoses) {
  const std::string text =
      "# made by hand\ntime,x,y,z,qx,qy,qz,qw\n0, 1, 2, 3, 0, 0, 0, 1\n\n0.5 1 2 4 0 0 0.70710678 "
      "0.70710678\n";
  const std::vector<Keyframe> read = read_keyframes(
      {.file = "a.csv", .start = 2, .scale = 10, .pose = {{0, 0, 1}, {0, 0, 0, 1}}}, only(text));
  ASSERT_EQ(read.size(), 2u);
  EXPECT_FLOAT_EQ(read[1].time, 2.5f);
  expect_near(read[1].pose.position, {10, 20, 41}, 1e-5f);
  expect_near(rotate(read[1].pose.rotation, {1, 0, 0}), {0, 1, 0}, 1e-6f);
  const auto refused = [](const std::string& named, const std::string& lines) {
    expect_error(ErrorCode::parse, named, [&] { read_keyframes({.file = "a.tum"}, only(lines)); });
  };
  refused("7 values in line 1", "0 0 0 0 0 0 0");
  refused("line 2", "0 0 0 0 0 0 0 1\n1 0 0 x 0 0 0 1");
  refused("length", "0 0 0 0 0 0 0 2");
  refused("pose 1", "1 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1");
  refused("no pose", "# nothing\n");
}

// The first frame of Blender is 1, and docs/manual/animated_colliders.md has this start.
TEST(MotionFile, BeginsAtZeroWhereTheStartHasFewDigits) {
  const std::string moves = R"(def Xform "A" {
    double3 xformOp:translate.timeSamples = { 1: (0, 0, 0), 25: (1, 0, 0) }
    uniform token[] xformOpOrder = ["xformOp:translate"]
  })";
  const auto begin = [&](float start, const std::string& rate) {
    return read_keyframes({.file = "a.usda", .start = start},
                          only("#usda 1.0\n( timeCodesPerSecond = " + rate + " )\n" + moves))[0]
        .time;
  };
  EXPECT_EQ(begin(-0.0416667f, "24"), 0);
  EXPECT_EQ(begin(-0.0166667f, "60"), 0);
  EXPECT_LT(begin(-0.0417f, "24"), 0) << "a thousandth away is no rounding";
  EXPECT_LT(begin(-1, "24"), 0);
  const std::string scene = R"({"name": "arm", "bodies": [{"name": "arm", "motion": "kinematic",
    "geometry": {"type": "sphere"}, "motion_file": {"file": "a.usda", "start": -0.0416667}}]})";
  const Scene read = read_scene_text(
      scene, "folder", "scene", [&](const std::string&) { return std::optional("#usda 1.0\n" + moves); });
  World world(WorldDef{.device = DeviceChoice::cpu});
  const BodyId body = world.create_body(read.bodies[0].def);
  EXPECT_EQ(world.body_state(body).pose.position.x, 0);
}

TEST(MotionFile, ASceneTakesItsKeyframesFromIt) {
  const std::string scene = R"({"name": "arm", "bodies": [{"name": "arm", "motion": "kinematic",
    "geometry": {"type": "sphere"}, "motion_file": {"file": "arm.usda", "prim": "/World/Arm"}}]})";
  const Scene read = read_scene_text(scene, "folder", "scene", [](const std::string& name) {
    return name == "folder/arm.usda" ? std::optional(std::string("#usda 1.0\n") + arm) : std::nullopt;
  });
  ASSERT_EQ(read.bodies[0].def.keyframes.size(), 2u);
  expect_near(read.bodies[0].def.pose.position, {0, 1, 0}, 1e-6f);
  try {
    read_scene_text(scene, "elsewhere", "scene",
                    [](const std::string&) { return std::optional<std::string>(); });
    ADD_FAILURE();
  } catch (const SceneError& error) {
    EXPECT_EQ(error.path(), "bodies[0].motion_file");
  }
}

}  // namespace
}  // namespace meniscus::tests
