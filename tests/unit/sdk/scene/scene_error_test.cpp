// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Errors in scene files, and their messages.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "sdk/scene/scene_file.h"

namespace meniscus {
namespace {

struct Mistake {
  const char* name;
  const char* text;
  const char* message;
};

void PrintTo(const Mistake& mistake, std::ostream* out) {
  *out << mistake.text;
}

class SceneMistake : public testing::TestWithParam<Mistake> {};

TEST_P(SceneMistake, IsNamed) {
  try {
    parse_scene(nlohmann::json::parse(GetParam().text), "scene.json");
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::parse);
    EXPECT_EQ(error.what(), std::string("scene.json: ") + GetParam().message);
  }
}

std::string mistake_name(const testing::TestParamInfo<Mistake>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(
    UnknownKey, SceneMistake,
    testing::Values(
        Mistake{"InScene", R"({"name": "x", "fluid": []})", R"(fluid: unknown key; did you mean "fluids"?)"},
        Mistake{"InWorld", R"({"name": "x", "world": {"iteration": 4}})",
                R"(world.iteration: unknown key; did you mean "iterations"?)"},
        Mistake{"InTheKernel", R"({"name": "x", "world": {"kernel": "wendland"}})",
                R"(world.kernel: "wendland" is not known; did you mean "wendland_c2"?)"},
        Mistake{
            "InTheSeeding",
            R"({"name": "x", "fluids": [{"name": "w"}], "volumes": [{"fluid": "w", "region": {"type": "ball", "radius": 1}, "seeding": "disorder"}]})",
            R"(volumes[0].seeding: "disorder" is not known; did you mean "disordered"?)"},
        Mistake{
            "InDensity", R"({"name": "x", "world": {"density": {"artificial_pressure": {"k": 4}}}})",
            R"(world.density.artificial_pressure.k: unknown key; allowed: "strength", "exponent", "distance")"},
        Mistake{"InFluid", R"({"name": "x", "fluids": [{"rest_denisty": 1000}]})",
                R"(fluids[0].rest_denisty: unknown key; did you mean "rest_density"?)"},
        Mistake{"Retired", R"({"name": "x", "fluids": [{"viscosity": 0.01}]})",
                R"(fluids[0].viscosity: was kinematic, in m²/s; write "dynamic_viscosity" in Pa·s, which is )"
                "the old value times rest_density"},
        Mistake{"InShape",
                R"({"name": "x", "shapes": [{"name": "a", "geometry": {"type": "plane"}, "frction": 1}]})",
                R"(shapes[0].frction: unknown key; did you mean "friction"?)"},
        Mistake{"InGeometry",
                R"({"name": "x", "shapes": [{"name": "a", "geometry": {"type": "sphere", "radii": 1}}]})",
                R"(shapes[0].geometry.radii: unknown key; did you mean "radius"?)"},
        Mistake{
            "OfAnotherType",
            R"({"name": "x", "shapes": [{"name": "a", "geometry": {"type": "sphere", "half_height": 1}}]})",
            R"(shapes[0].geometry.half_height: unknown key; allowed: "type", "radius")"},
        Mistake{"InOpening", R"({"name": "x", "shapes": [{"name": "a", "geometry":
                             {"type": "container", "openings": [{"fase": "y_high"}]}}]})",
                R"(shapes[0].geometry.openings[0].fase: unknown key; did you mean "face"?)"},
        Mistake{
            "InPose",
            R"({"name": "x", "shapes": [{"name": "a", "geometry": {"type": "plane"}, "pose": {"positon": 1}}]})",
            R"(shapes[0].pose.positon: unknown key; did you mean "position"?)"},
        Mistake{"InRotation", R"({"name": "x", "shapes": [{"name": "a", "geometry": {"type": "plane"},
                              "pose": {"rotation": {"axis": [0, 1, 0], "radians": 1}}}]})",
                R"(shapes[0].pose.rotation.radians: unknown key; allowed: "axis", "degrees")"},
        Mistake{
            "InVolume", R"({"name": "x", "fluids": [{}], "volumes": [{"liquid": "water"}]})",
            R"(volumes[0].liquid: unknown key; allowed: "fluid", "region", "pose", "velocity", "seeding")"},
        Mistake{"InRegion",
                R"({"name": "x", "volumes": [{"fluid": "water", "region": {"type": "ball", "radis": 1}}]})",
                R"(volumes[0].region.radis: unknown key; did you mean "radius"?)"},
        Mistake{"InSink", R"({"name": "x", "sinks": [{"nam": "a"}]})",
                R"(sinks[0].nam: unknown key; did you mean "name"?)"},
        Mistake{
            "InBox",
            R"({"name": "x", "probes": [{"type": "wall_force", "name": "a", "shape": "b", "patch": {"min": [0, 0, 0]}}]})",
            R"(probes[0].patch.min: unknown key; allowed: "lower", "upper")"},
        Mistake{"InProbe",
                R"({"name": "x", "probes": [{"type": "wall_force", "name": "a", "point": [0, 0, 0]}]})",
                R"(probes[0].point: unknown key; allowed: "type", "name", "shape", "patch")"},
        Mistake{"InCamera", R"({"name": "x", "camera": {"targte": [0, 0, 0]}})",
                R"(camera.targte: unknown key; did you mean "target"?)"}),
    mistake_name);

INSTANTIATE_TEST_SUITE_P(
    Type, SceneMistake,
    testing::Values(
        Mistake{"Document", "[]", "an array of 0 is not allowed; must be an object {...}"},
        Mistake{"Text", R"({"name": 5})", "name: 5 is not allowed; must be text in quotes"},
        Mistake{"Number", R"({"name": "x", "frame_time": "16 ms"})",
                "frame_time: \"16 ms\" is not allowed; must be a number"},
        Mistake{"Whole", R"({"name": "x", "frames": 2.5})",
                "frames: 2.5 is not allowed; must be a whole number"},
        Mistake{"Truth",
                R"({"name": "x", "sinks": [{"name": "a", "region": {"type": "ball"}, "outside": 1}]})",
                "sinks[0].outside: 1 is not allowed; must be true or false"},
        Mistake{"Null", R"({"name": "x", "camera": null})",
                "camera: null is not allowed; must be an object {...}"},
        Mistake{"Object", R"({"name": "x", "world": [1]})",
                "world: an array of 1 is not allowed; must be an object {...}"},
        Mistake{"List", R"({"name": "x", "fluids": {}})",
                "fluids: an object is not allowed; must be an array [...]"},
        Mistake{"Vector", R"({"name": "x", "world": {"gravity": [0, -9.81]}})",
                "world.gravity: an array of 2 is not allowed; must be an array of 3 numbers"},
        Mistake{"Component", R"({"name": "x", "world": {"gravity": [0, "g", 0]}})",
                "world.gravity[1]: \"g\" is not allowed; must be a number"},
        Mistake{
            "Rotation",
            R"({"name": "x", "shapes": [{"name": "a", "geometry": {"type": "plane"}, "pose": {"rotation": 90}}]})",
            "shapes[0].pose.rotation: 90 is not allowed; must be an array of 4 numbers [x, y, z, w], or an "
            "object "
            "with axis and degrees"},
        Mistake{"Name", R"({"name": "x", "world": {"device": "gpu"}})",
                R"(world.device: "gpu" is not known; did you mean "cpu"?)"},
        Mistake{"Alternative", R"({"name": "x", "shapes": [{"name": "a", "geometry": {"type": "spere"}}]})",
                R"(shapes[0].geometry.type: "spere" is not known; did you mean "sphere"?)"},
        Mistake{"NoAlternative", R"({"name": "x", "volumes": [{"fluid": "water", "region": {"radius": 1}}]})",
                R"(volumes[0].region.type: missing, and needed; allowed: "box", "ball", "mesh")"}),
    mistake_name);

INSTANTIATE_TEST_SUITE_P(
    Range, SceneMistake,
    testing::Values(
        Mistake{"Positive", R"({"name": "x", "wind": {"gust_size": 0}})",
                "wind.gust_size: 0 is not allowed; must be greater than 0"},
        Mistake{"AtLeast", R"({"name": "x", "frames": 0})", "frames: 0 is not allowed; must be at least 1"},
        Mistake{"BetweenFractions", R"({"name": "x", "world": {"density": {"relaxation": 0.45}}})",
                "world.density.relaxation: 0.45 is not allowed; must be at least 0.01 and at most 0.44"},
        Mistake{"Between", R"({"name": "x", "fluids": [{"color": [0, 0, 1.5]}]})",
                "fluids[0].color[2]: 1.5 is not allowed; must be at least 0 and at most 1"},
        Mistake{"Inside", R"({"name": "x", "camera": {"field_of_view": 180}})",
                "camera.field_of_view: 180 is not allowed; must be greater than 0 and less than 180"},
        Mistake{"BeyondFloat", R"({"name": "x", "world": {"gravity": [0, -1e39, 0]}})",
                "world.gravity[1]: -1e+39 is not allowed; must be a finite number of single precision"},
        Mistake{"TooSmallForFloat", R"({"name": "x", "wind": {"gust_size": 1e-60}})",
                "wind.gust_size: 1e-60 is not allowed; must be far enough from 0 for single precision"},
        Mistake{"BeyondInt", R"({"name": "x", "frames": 3000000000})",
                "frames: 3000000000 is not allowed; must be a whole number of 32 bits"},
        Mistake{"EmptyText", R"({"name": ""})", "name: \"\" is not allowed; must be text that is not empty"},
        Mistake{"FewItems", R"({"name": "x", "shapes": [{"name": "a", "geometry":
                            {"type": "height_field", "columns": 2, "rows": 2, "heights": [1]}}]})",
                "shapes[0].geometry.heights: an array of 1 is not allowed; must have at least 4 items"}),
    mistake_name);

INSTANTIATE_TEST_SUITE_P(
    Missing, SceneMistake,
    testing::Values(Mistake{"Name", "{}", "name: missing, and needed: short name of the scene"},
                    Mistake{"Region", R"({"name": "x", "volumes": [{"fluid": "water"}]})",
                            "volumes[0].region: missing, and needed: what to fill"},
                    Mistake{"Area",
                            R"({"name": "x", "probes": [{"type": "wall_pressure", "name": "a", "shape": "s",
                                    "patch": {"lower": [0, 0, 0], "upper": [1, 1, 1]}}]})",
                            "probes[0].area: missing, and needed: area of the surface inside the patch"}),
    mistake_name);

INSTANTIATE_TEST_SUITE_P(
    Together, SceneMistake,
    testing::Values(
        Mistake{"Substeps", R"({"name": "x", "world": {"min_substeps": 20}})",
                "world: min_substeps must not be above max_substeps"},
        Mistake{"Heights", R"({"name": "x", "shapes": [{"name": "a", "geometry":
                           {"type": "height_field", "columns": 2, "rows": 3, "heights": [1, 2, 3, 4]}}]})",
                "shapes[0].geometry: heights must hold columns · rows = 2 · 3 numbers, not 4"},
        Mistake{
            "Normal",
            R"({"name": "x", "shapes": [{"name": "a", "geometry": {"type": "plane", "normal": [0, 0, 0]}}]})",
            "shapes[0].geometry: normal must be of a length from 1e-6 to 1e18"},
        Mistake{"Axis", R"({"name": "x", "shapes": [{"name": "a", "geometry": {"type": "plane"},
                        "pose": {"rotation": {"axis": [0, 0, 0], "degrees": 1}}}]})",
                "shapes[0].pose.rotation: axis must be of a length from 1e-6 to 1e18"},
        Mistake{"Quaternion", R"({"name": "x", "shapes": [{"name": "a", "geometry": {"type": "plane"},
                              "pose": {"rotation": [0, 0, 0, 1e-9]}}]})",
                "shapes[0].pose.rotation: a quaternion near zero is no rotation; its length must be greater "
                "than 1e-06"},
        Mistake{"OpeningCorners", R"({"name": "x", "shapes": [{"name": "a", "geometry":
                                  {"type": "container", "openings": [{"face": "y_high", "lower": [0, 0, 0]}]}}]})",
                "shapes[0].geometry.openings[0]: lower and upper must come together"},
        Mistake{"Box",
                R"({"name": "x", "probes": [{"type": "wall_force", "name": "a", "shape": "b",
                              "patch": {"lower": [0, 2, 0], "upper": [1, 1, 1]}}]})",
                "probes[0].patch: lower must not be above upper in any component"},
        Mistake{"Region", R"({"name": "x", "volumes": [{"fluid": "water", "region":
                          {"type": "box", "lower": [0, 0, 0], "upper": [1, -1, 1]}}]})",
                "volumes[0].region: lower must not be above upper in any component"},
        Mistake{"Camera", R"({"name": "x", "camera": {"position": [1, 1, 1], "target": [1, 1, 1]}})",
                "camera: position and target must differ"}),
    mistake_name);

INSTANTIATE_TEST_SUITE_P(
    Name, SceneMistake,
    testing::Values(
        Mistake{"FluidTwice", R"({"name": "x", "fluids": [{}, {"name": "oil"}, {}]})",
                R"(fluids[2].name: "water" is the name of fluids[0] already)"},
        Mistake{"ShapeTwice", R"({"name": "x", "shapes": [{"name": "a", "geometry": {"type": "plane"}},
                              {"name": "a", "geometry": {"type": "plane"}}]})",
                R"(shapes[1].name: "a" is the name of shapes[0] already)"},
        Mistake{
            "SinkTwice",
            R"({"name": "x", "sinks": [{"name": "a", "region": {"type": "ball"}}, {"name": "a", "region": {"type": "box"}}]})",
            R"(sinks[1].name: "a" is the name of sinks[0] already)"},
        Mistake{"ProbeTwice",
                R"({"name": "x", "probes": [{"type": "point_pressure", "name": "a", "point": [0, 0, 0]},
                              {"type": "point_pressure", "name": "a", "point": [0, 1, 0]}]})",
                R"(probes[1].name: "a" is the name of probes[0] already)"},
        Mistake{"CameraTwice",
                R"({"name": "x", "cameras": [{"name": "a"}, {"name": "a", "target": [0, 1, 0]}]})",
                R"(cameras[1].name: "a" is the name of cameras[0] already)"},
        Mistake{"CameraWithoutAName", R"({"name": "x", "cameras": [{"position": [0, 1, 0]}]})",
                "cameras[0].name: missing, and needed: what --camera calls it"},
        Mistake{"NoSuchFluid",
                R"({"name": "x", "fluids": [{}], "volumes": [{"fluid": "watr", "region": {"type": "box"}}]})",
                R"(volumes[0].fluid: there is no fluid named "watr"; did you mean "water"?)"},
        Mistake{"LookTwice",
                R"({"name": "x", "fluids": [{}], "looks": [{"fluid": "water"}, {"fluid": "water"}]})",
                R"(looks[1].fluid: "water" has the look looks[0] already)"},
        Mistake{"LookOfNoFluid", R"({"name": "x", "fluids": [{}], "looks": [{"fluid": "watr"}]})",
                R"(looks[0].fluid: there is no fluid named "watr"; did you mean "water"?)"},
        Mistake{"NoSuchLiquid",
                R"({"name": "x", "fluids": [{}], "looks": [{"fluid": "water", "liquid": "beer"}]})",
                R"(looks[0].liquid: "beer" is not known; allowed: )"
                R"("clear", "sea", "pool", "milk", "honey", "oil")"},
        Mistake{"NoFluids", R"({"name": "x", "volumes": [{"fluid": "water", "region": {"type": "box"}}]})",
                R"(volumes[0].fluid: there is no fluid named "water"; allowed: none)"},
        Mistake{"NoSuchShape", R"({"name": "x", "shapes": [{"name": "floor", "geometry": {"type": "plane"}}],
                               "probes": [{"type": "wall_force", "name": "a", "shape": "ceiling"}]})",
                R"(probes[0].shape: there is no shape named "ceiling"; allowed: "floor")"}),
    mistake_name);

/// A scene of one body with the keys of `rest`.
#define BODY(rest) R"({"name": "x", "bodies": [{"name": "a", )" rest "}]}"
#define BOX R"("geometry": {"type": "box"})"

INSTANTIATE_TEST_SUITE_P(
    Body, SceneMistake,
    testing::Values(
        Mistake{
            "UnknownKey", BODY(BOX R"(, "weight": 3)"),
            R"(bodies[0].weight: unknown key; allowed: "name", "motion", "geometry", "pose", "velocity", )"
            R"("angular_velocity", "density", "mass", "friction", "restitution", "adhesion", "slip_length", )"
            R"("solid_friction", "solid_restitution", "belt_velocity", "groups", "mask", "linear_damping", )"
            R"("angular_damping", "can_sleep", "keyframes", "loop", "motion_file", "copies")"},
        Mistake{"Motion", BODY(BOX R"(, "motion": "static")"),
                R"(bodies[0].motion: "static" is not known; allowed: "dynamic", "kinematic")"},
        Mistake{"NoGeometry", R"({"name": "x", "bodies": [{"name": "a"}]})",
                "bodies[0].geometry: missing, and needed: what it is"},
        Mistake{"PlaneCannotMove", BODY(R"("geometry": {"type": "plane"})"),
                R"(bodies[0].geometry.type: "plane" is not known; allowed: "box", "sphere", "capsule", )"
                R"("cylinder", "mesh", "hull", "compound", "container")"},
        Mistake{"ContainerMustBeKinematic", BODY(R"("geometry": {"type": "container"})"),
                "bodies[0]: a container must be kinematic"},
        Mistake{"Density", BODY(BOX R"(, "density": 0)"),
                "bodies[0].density: 0 is not allowed; must be greater than 0"},
        Mistake{"Mass", BODY(BOX R"(, "mass": -1)"),
                "bodies[0].mass: -1 is not allowed; must be greater than 0"},
        Mistake{"Damping", BODY(BOX R"(, "angular_damping": 1.5)"),
                "bodies[0].angular_damping: 1.5 is not allowed; must be at least 0 and at most 1"},
        Mistake{"Adhesion", BODY(BOX R"(, "adhesion": -1)"),
                "bodies[0].adhesion: -1 is not allowed; must be at least 0"},
        Mistake{"SolidRestitution", BODY(BOX R"(, "solid_restitution": 2)"),
                "bodies[0].solid_restitution: 2 is not allowed; must be at least 0 and at most 1"},
        Mistake{"NegativeBits", BODY(BOX R"(, "groups": -1)"),
                "bodies[0].groups: -1 is not allowed; must be at least 0 and at most 4294967295"},
        Mistake{"BrokenBits", BODY(BOX R"(, "mask": 1.5)"),
                "bodies[0].mask: 1.5 is not allowed; must be a whole number"},
        Mistake{"KeyframesOfADynamicBody", BODY(BOX R"(, "keyframes": [{"time": 0}])"),
                "bodies[0]: keyframes are for kinematic bodies alone"},
        Mistake{"VelocityOfAKinematicBody", BODY(BOX R"(, "motion": "kinematic", "velocity": [0, 1, 0])"),
                "bodies[0]: velocity and angular_velocity are for dynamic bodies alone"},
        Mistake{"KeyframesOutOfOrder",
                BODY(BOX R"(, "motion": "kinematic", "keyframes": [{"time": 1}, {"time": 1}])"),
                "bodies[0]: the times of keyframes must increase"},
        Mistake{"KeyframeWithoutATime", BODY(BOX R"(, "motion": "kinematic", "keyframes": [{}])"),
                "bodies[0].keyframes[0].time: missing, and needed: when, from the start of the run"},
        Mistake{"KeyframeBeforeTheStart", BODY(BOX R"(, "motion": "kinematic", "keyframes": [{"time": -1}])"),
                "bodies[0].keyframes[0].time: -1 is not allowed; must be at least 0"},
        Mistake{"LoopOfNothing", BODY(BOX R"(, "motion": "kinematic", "loop": true)"),
                "bodies[0]: loop needs at least 2 keyframes"},
        Mistake{"FewPoints", BODY(R"("geometry": {"type": "hull", "points": [[0, 0, 0], [1, 0, 0]]})"),
                "bodies[0].geometry: a hull needs at least 4 points, not 2, or a file"},
        Mistake{
            "ScaleOfPoints",
            BODY(
                R"("geometry": {"type": "hull", "scale": 2, "points": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]})"),
            "bodies[0].geometry: scale is the file's; points are in metres"},
        Mistake{"NoParts", BODY(R"("geometry": {"type": "compound", "parts": []})"),
                "bodies[0].geometry.parts: an array of 0 is not allowed; must have at least 1 items"},
        Mistake{"PartInAPart",
                BODY(R"("geometry": {"type": "compound", "parts": [{"geometry": {"type": "compound"}}]})"),
                R"(bodies[0].geometry.parts[0].geometry.type: "compound" is not known; allowed: "box", )"
                R"("sphere", "capsule", "cylinder", "mesh", "hull")"},
        Mistake{"CopiesInAPlane", BODY(BOX R"(, "copies": {"count": [2, 3]})"),
                "bodies[0].copies.count: an array of 2 is not allowed; must have at least 3 items"},
        Mistake{"CopiesInTime", BODY(BOX R"(, "copies": {"count": [2, 3, 1, 1]})"),
                "bodies[0].copies.count: an array of 4 is not allowed; must have at most 3 items"},
        Mistake{"CopiesAtOnePlace", BODY(BOX R"(, "copies": {"count": [2, 2, 1], "step": [1, 0, 1]})"),
                "bodies[0].copies: step must not be 0 along an axis with several"},
        Mistake{"TooManyCopies", BODY(BOX R"(, "copies": {"count": [100, 100, 11]})"),
                "bodies[0].copies: there must be at most 100000 copies"},
        Mistake{"NoCopies", BODY(BOX R"(, "copies": {"count": [2, 0, 3]})"),
                "bodies[0].copies.count[1]: 0 is not allowed; must be at least 1 and at most 100000"},
        Mistake{"NameOfACopy", R"({"name": "x", "bodies": [
                    {"name": "a", "geometry": {"type": "box"}, "copies": {"count": [2, 1, 1], "step": [3, 0, 0]}},
                    {"name": "a_1", "geometry": {"type": "box"}}]})",
                R"(bodies[1].name: "a_1" is the name of bodies[0] already)"},
        Mistake{"Rigid", R"({"name": "x", "world": {"rigid": {"iterations": 0}}})",
                "world.rigid.iterations: 0 is not allowed; must be at least 1 and at most 10000"},
        Mistake{"NameOfAShape", R"({"name": "x", "shapes": [{"name": "a", "geometry": {"type": "plane"}}],
                                "bodies": [{"name": "b", "geometry": {"type": "box"}},
                                           {"name": "a", "geometry": {"type": "box"}}]})",
                R"(bodies[1].name: "a" is the name of shapes[0] already)"},
        Mistake{"FilterOfAFluid", R"({"name": "x", "fluids": [{"mask": "all"}]})",
                R"(fluids[0].mask: "all" is not allowed; must be a whole number)"}),
    mistake_name);

/// Two bodies, and a joint with the keys of `rest`.
#define JOINT(rest)                                                                  \
  R"({"name": "x", "bodies": [{"name": "wheel", )" BOX R"(}, {"name": "cart", )" BOX \
  R"(}], "joints": [{)" rest "}]}"

INSTANTIATE_TEST_SUITE_P(
    Joint, SceneMistake,
    testing::Values(
        Mistake{"Type", JOINT(R"("type": "hing", "name": "j", "a": "wheel")"),
                R"(joints[0].type: "hing" is not known; did you mean "hinge"?)"},
        Mistake{"KeyOfAnotherType", JOINT(R"("type": "ball", "name": "j", "a": "wheel", "motor_speed": 1)"),
                R"(joints[0].motor_speed: unknown key; allowed: "type", "name", "a", "b", "frame", )"
                R"("bodies_collide")"},
        Mistake{"NoBody", JOINT(R"("type": "fixed", "name": "j")"),
                "joints[0].a: missing, and needed: name of a body"},
        Mistake{"NoSuchA", JOINT(R"("type": "fixed", "name": "j", "a": "weel")"),
                R"(joints[0].a: there is no body named "weel"; did you mean "wheel"?)"},
        Mistake{"NoSuchB", JOINT(R"("type": "fixed", "name": "j", "a": "wheel", "b": "axle")"),
                R"(joints[0].b: there is no body named "axle"; allowed: "wheel", "cart")"},
        Mistake{"ToItself", JOINT(R"("type": "fixed", "name": "j", "a": "wheel", "b": "wheel")"),
                "joints[0]: a and b must differ"},
        Mistake{"OneLimit", JOINT(R"("type": "slider", "name": "j", "a": "wheel", "lower": 0)"),
                "joints[0]: lower and upper must come together"},
        Mistake{"LimitsCrossed",
                JOINT(R"("type": "hinge", "name": "j", "a": "wheel", "lower": 10, "upper": -10)"),
                "joints[0]: lower must not be above upper"},
        Mistake{"LimitBeyondHalfATurn",
                JOINT(R"("type": "hinge", "name": "j", "a": "wheel", "lower": -181, "upper": 0)"),
                "joints[0].lower: -181 is not allowed; must be at least -180 and at most 180"},
        Mistake{"Motor", JOINT(R"("type": "hinge", "name": "j", "a": "wheel", "motor_torque": -1)"),
                "joints[0].motor_torque: -1 is not allowed; must be at least 0"},
        Mistake{"Stiffness", JOINT(R"("type": "spring", "name": "j", "a": "wheel", "stiffness": [1, -1, 1])"),
                "joints[0].stiffness[1]: -1 is not allowed; must be at least 0"},
        Mistake{"Held", JOINT(R"("type": "spring", "name": "j", "a": "wheel", "held": ["height"])"),
                R"(joints[0].held[0]: "height" is not known; allowed: "x", "y", "z")"},
        Mistake{"NameTwice", R"({"name": "x", "bodies": [{"name": "a", "geometry": {"type": "box"}}],
                             "joints": [{"type": "ball", "name": "j", "a": "a"},
                                        {"type": "ball", "name": "j", "a": "a"}]})",
                R"(joints[1].name: "j" is the name of joints[0] already)"}),
    mistake_name);

}  // namespace
}  // namespace meniscus
