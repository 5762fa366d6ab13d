// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the command line program, each in a process of its own.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <nlohmann/json.hpp>

#include <meniscus/world.h>
#include "sdk/cli/stop/interrupt.h"
#include "tests/unit/sdk/cli/program_fixture.h"

namespace meniscus::cli {
namespace {

TEST_F(ProgramTest, ARunLeavesItsFiles) {
  EXPECT_EXIT(run({"run", "drop", "--device", "cpu", "--out", out(), "--export", "ply,vtp", "--quiet"}),
              testing::ExitedWithCode(success), "^$");
  for (const char* name :
       {"frames.csv", "summary.json", "density.svg", "preview.png", "particles.pvd", "frames/frame_00000.ply",
        "frames/frame_00000.vtp", "frames/frame_00001.ply", "frames/frame_00002.vtp"}) {
    EXPECT_TRUE(fs::exists(fs::path(out()) / name)) << name;
  }
  const auto figures = nlohmann::json::parse(std::ifstream(fs::path(out()) / "summary.json"));
  EXPECT_EQ(figures["particles"], 64);
  EXPECT_EQ(figures["frames"], 2);
  EXPECT_EQ(figures["device"]["kind"], "cpu");
}

TEST_F(ProgramTest, CompareRunsEachSolverAtEachError) {
  const std::string table = printed(
      {"compare", "drop", "--device", "cpu", "--seconds", "0.05", "--errors", "1,0.1", "--out", out()});
  EXPECT_TRUE(fs::exists(fs::path(out()) / "compare.svg"));
  const auto figures = nlohmann::json::parse(std::ifstream(fs::path(out()) / "compare.json"));
  ASSERT_EQ(figures["results"].size(), 12);
  for (const auto& result : figures["results"]) {
    EXPECT_FALSE(result.contains("failure")) << result;
    EXPECT_GT(result["ms_per_second"], 0) << result;
    // The tolerance of a substep bounds the mean; WCSPH, which has none, may exceed it while it settles.
    if (result["solver"] != "wcsph") {
      EXPECT_LE(result["error_percent"], 1.2 * double(result["error_asked_percent"]));
    }
    EXPECT_NE(table.find("| " + std::string(result["solver"])), std::string::npos);
  }
  EXPECT_EXIT(run({"compare", "flag"}), testing::ExitedWithCode(bad_input), "flag");
}

TEST_F(ProgramTest, ValidateWritesAPageOnTheCasesThatAreNamed) {
  EXPECT_NE(printed({"validate", "--list"}).find("sloshing"), std::string::npos);
  const fs::path page = fs::path(out()) / "docs.md";
  const std::string told = printed({"validate", "chain", "--device", "cpu", "--resolution", "quick",
                                    "--output", out(), "--page", page.string(), "--commit", "abc1234"});
  EXPECT_NE(told.find("period over that of theory"), std::string::npos);
  for (const char* file : {"accuracy.md", "accuracy/chain.svg", "accuracy/figures.json", "docs/chain.svg"})
    EXPECT_TRUE(fs::exists(fs::path(out()) / file)) << file;
  EXPECT_NE(bytes(page).find("abc1234"), std::string::npos);
  EXPECT_EXIT(run({"validate", "chian"}), testing::ExitedWithCode(bad_input), "chain");
}

TEST_F(ProgramTest, ARunTakesTheFilesOfTheOneBeforeAway) {
  printed({"run", "raft", "--device", "cpu", "--frames", "2", "--export", "ply,vtp,usd", "--quiet", "--out",
           out()});
  EXPECT_TRUE(fs::exists(folder_ / "out/scene.usda"));
  EXPECT_TRUE(fs::exists(folder_ / "out/bodies.csv"));
  EXPECT_TRUE(fs::exists(folder_ / "out/frames/frame_00002.ply"));
  std::ofstream(folder_ / "out/frames/notes.ply") << "mine";
  std::ofstream(folder_ / "out/notes.csv") << "mine";
  printed({"run", "drop", "--device", "cpu", "--frames", "1", "--export", "ply", "--quiet", "--out", out()});
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / "out")) {
    if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), folder_ / "out").string());
  }
  std::sort(files.begin(), files.end());
  EXPECT_EQ(files, (std::vector<std::string>{"density.svg", "frames.csv", "frames/frame_00000.ply",
                                             "frames/frame_00001.ply", "frames/notes.ply", "notes.csv",
                                             "preview.png", "summary.json"}));
}

TEST_F(ProgramTest, SurfacesAreWrittenWhereTheyAreAskedFor) {
  EXPECT_EXIT(
      run({"run", "drop", "--device", "cpu", "--out", out(), "--export", "obj,vtp", "--surface", "--quiet"}),
      testing::ExitedWithCode(success), "^$");
  for (const char* name :
       {"surface.pvd", "frames/surface_00000.obj", "frames/surface_00001.obj", "frames/surface_00002.vtp"})
    EXPECT_TRUE(fs::exists(fs::path(out()) / name)) << name;
  EXPECT_NE(bytes(fs::path(out()) / "frames/surface_00002.obj").find("\nf "), std::string::npos);
  EXPECT_EXIT(run({"run", "drop", "--surface"}), testing::ExitedWithCode(bad_input),
              "--surface[^\n]*--export");
}

TEST_F(ProgramTest, PicturesHaveTheSizeAndTheCameraThatAreAskedFor) {
  EXPECT_EXIT(run({"run", "drop", "--device", "cpu", "--out", out(), "--quiet", "--size", "64x48"}),
              testing::ExitedWithCode(success), "^$");
  const std::string usual = bytes(fs::path(out()) / "preview.png");
  EXPECT_EQ(pixels(usual), "64x48");
  EXPECT_EXIT(run({"run", "drop", "--device", "cpu", "--out", out(), "--quiet", "--size", "64x48", "--camera",
                   "above"}),
              testing::ExitedWithCode(success), "^$");
  EXPECT_NE(bytes(fs::path(out()) / "preview.png"), usual);
}

TEST_F(ProgramTest, BadPictureOptionsAreNamed) {
  for (const char* size : {"64", "x", "64x", "0x48", "64x48x2", "64x99999", "-64x48"}) {
    EXPECT_EXIT(run({"run", "drop", "--size=" + std::string(size)}), testing::ExitedWithCode(bad_input),
                "^meniscus: --size is '" + std::string(size) + "'[^\n]*1280x720\n$");
  }
  EXPECT_EXIT(run({"run", "drop", "--camera", "clos"}), testing::ExitedWithCode(bad_input),
              "^meniscus: --camera is 'clos'[^\n]*\"close\"[^\n]*\n$");
  EXPECT_EXIT(run({"run", "flag", "--camera", "close"}), testing::ExitedWithCode(bad_input),
              "^meniscus: --camera is 'close', but the scene has no named cameras\n$");
  EXPECT_EXIT(run({"run", "drop", "--filter=none"}), testing::ExitedWithCode(bad_input),
              "^meniscus: --filter[^\n]*need --render or --video\n$");
  EXPECT_EXIT(run({"run", "drop", "--render", "--filter=blur"}), testing::ExitedWithCode(bad_input),
              "^meniscus: --filter: blur");
  EXPECT_EXIT(run({"run", "drop", "--view", "speed"}), testing::ExitedWithCode(bad_input),
              "^meniscus: --filter, --no-anisotropy, --view, --samples, --aperture, --shutter and --caustics "
              "are for what OpenGL draws");
  EXPECT_EXIT(run({"run", "drop", "--render=all"}), testing::ExitedWithCode(bad_input),
              "^meniscus: --render: all");
}

TEST_F(ProgramTest, EveryFrameIsRenderedWhereThereIsARenderer) {
  const std::vector<std::string> line{"run", "drop",    "--device", "cpu",   "--out",
                                      out(), "--quiet", "--size",   "64x48", "--render"};
  // Where there is none, the message says what is missing.
  EXPECT_EXIT(
      run(line),
      [](int status) {
        return testing::ExitedWithCode(success)(status) || testing::ExitedWithCode(run_failed)(status);
      },
      "^$|^meniscus: cannot render: [^\n]*\n$");
  if (!fs::exists(fs::path(out()) / "frames")) GTEST_SKIP() << "no renderer here";
  EXPECT_EQ(pixels(bytes(fs::path(out()) / "contact_sheet.png")), "132x48");
  for (const char* name : {"frames/render_00001.png", "frames/render_00002.png", "preview.png"})
    EXPECT_EQ(pixels(bytes(fs::path(out()) / name)), "64x48") << name;
  EXPECT_EQ(bytes(fs::path(out()) / "preview.png"), bytes(fs::path(out()) / "frames/render_00002.png"));
}

TEST_F(ProgramTest, WithoutFfmpegAVideoIsAnErrorBeforeTheRun) {
  const auto without_ffmpeg = [&] {
    setenv("PATH", "/nonexistent", 1);
    run({"run", "drop", "--device", "cpu", "--out", out(), "--size", "64x48", "--video",
         (folder_ / "drop.mp4").string()});
  };
  EXPECT_EXIT(
      without_ffmpeg(),
      [](int status) {
        return testing::ExitedWithCode(bad_input)(status) || testing::ExitedWithCode(run_failed)(status);
      },
      "^meniscus: cannot (write the video|render)[^\n]*\n$");
  EXPECT_FALSE(fs::exists(out()));
  EXPECT_FALSE(fs::exists(folder_ / "drop.mp4"));
}

TEST_F(ProgramTest, WithoutAScreenThereIsNoWindow) {
  const auto without_screen = [&] {
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    run({"view", "drop", "--device", "cpu"});
  };
  EXPECT_EXIT(without_screen(), testing::ExitedWithCode(run_failed),
              "^meniscus: cannot open a window: [^\n]*\n$");
}

TEST_F(ProgramTest, WithoutADeviceRenderingIsAnErrorAndAutoIsNot) {
  const auto without_device = [&](const char* render) {
    setenv("__EGL_VENDOR_LIBRARY_DIRS", "/nonexistent", 1);
    run({"run", "drop", "--device", "cpu", "--out", out(), "--quiet", "--size", "64x48", render});
  };
  EXPECT_EXIT(without_device("--render=last"), testing::ExitedWithCode(run_failed),
              "^meniscus: cannot render: ");
  EXPECT_FALSE(fs::exists(out())) << "a run that did not start leaves no folder";
  EXPECT_EXIT(without_device("--render=auto"), testing::ExitedWithCode(success), "^$");
  EXPECT_TRUE(fs::exists(fs::path(out()) / "preview.png"));
}

TEST_F(ProgramTest, ClothIsMovedMeasuredAndExported) {
  EXPECT_EXIT(run({"run", "flag", "--device", "cpu", "--out", out(), "--export", "ply,vtp,obj", "--quiet"}),
              testing::ExitedWithCode(success), "^$");
  for (const char* name :
       {"cloths.csv", "attachments.csv", "cloth.pvd", "ropes.pvd", "frames/cloth_00001.ply",
        "frames/cloth_00002.obj", "frames/cloth_00002.vtp", "frames/ropes_00001.vtp"}) {
    EXPECT_TRUE(fs::exists(fs::path(out()) / name)) << name;
  }
  EXPECT_FALSE(fs::exists(fs::path(out()) / "particles.pvd")) << "there is no fluid";
  EXPECT_FALSE(fs::exists(fs::path(out()) / "density.svg")) << "there is no fluid";
  const auto figures = nlohmann::json::parse(std::ifstream(fs::path(out()) / "summary.json"));
  const auto& sheet = figures["cloths"].at(0);
  EXPECT_EQ(sheet["vertices"], 20);
  EXPECT_NEAR(sheet["mass_kg"].get<double>(), 0.2, 1e-6);
  EXPECT_LT(sheet["momentum_kg_m_s"][1].get<double>(), 0) << "it falls";
  EXPECT_NEAR(figures["ropes"].at(0)["length_m"].get<double>(), 1, 1e-4);
  EXPECT_EQ(figures["attachments"].at(0)["name"], "corner");
  EXPECT_TRUE(figures["density_error"].is_null());
}

TEST_F(ProgramTest, FrameZeroIsTheStateBeforeTheFirstStep) {
  printed({"run", "drop", "--device", "cpu", "--out", out(), "--export", "obj,vtp", "--quiet"});
  std::istringstream start(bytes(fs::path(out()) / "frames/frame_00000.obj"));
  float lowest = 1;
  for (std::string line; std::getline(start, line);) {
    float x = 0, y = 0, z = 0;
    if (std::sscanf(line.c_str(), "v %f %f %f", &x, &y, &z) == 3) lowest = std::min(lowest, y);
  }
  EXPECT_NEAR(lowest, 0.05, 1e-6) << "half a spacing above the floor, where the volume was filled";
  const std::string collection = bytes(fs::path(out()) / "particles.pvd");
  const std::size_t first = collection.find("timestep=\"0\"");
  ASSERT_NE(first, std::string::npos) << collection;
  EXPECT_LT(first, collection.find("frame_00001.vtp"));
  EXPECT_NE(collection.find("frame_00000.vtp"), std::string::npos);
}

TEST_F(ProgramTest, CheckCountsCloth) {
  const std::string text = printed({"check", "flag"});
  EXPECT_NE(text.find("cloths 1 of 20 vertices and 24 triangles, ropes 1 of 11 vertices, attachments 1"),
            std::string::npos)
      << text;
}

TEST_F(ProgramTest, CheckReportsMeshes) {
  write("cube.obj",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
        "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 1 5 8 4\n");
  write("cube.json", R"({ "name": "cube", "world": { "particle_spacing": 0.1 }, "bodies": [
    { "name": "it", "geometry": { "type": "mesh", "file": "cube.obj", "repair": true } }] })");
  const std::string text = printed({"check", "cube"});
  EXPECT_NE(text.find("1 × 1 × 1 m from (0, 0, 0)"), std::string::npos) << text;
  EXPECT_NE(text.find("unit guess metres"), std::string::npos) << text;
  EXPECT_NE(
      text.find(
          "triangles 10, dropped 0, vertices welded 0, holes 1 of 4 open edges, odd edges 0, crossings 0"),
      std::string::npos)
      << text;
  EXPECT_EXIT(run({"check", "cube"}), testing::ExitedWithCode(success),
              testing::ContainsRegex("cube.obj was repaired within"));
  EXPECT_EXIT(run({"check", "cube", "--set", "world.particle_spacing=0.6"}), testing::ExitedWithCode(success),
              testing::ContainsRegex("cube.obj is tiny"));
}

TEST_F(ProgramTest, DevicesSayWhatMemoryASceneTakes) {
  const std::string water = printed({"devices", "--memory", "drop", "--device", "cpu"}),
                    cloth = printed({"devices", "--memory", "flag", "--set", "world.device=cpu"});
  EXPECT_NE(water.find("drop on cpu"), std::string::npos) << water;
  EXPECT_NE(water.find("64 particles, 0 vertices"), std::string::npos) << water;
  EXPECT_NE(water.find("neighbour lists"), std::string::npos) << water;
  EXPECT_NE(cloth.find("0 particles, 31 vertices"), std::string::npos) << cloth;
  EXPECT_NE(cloth.find("cloth edges"), std::string::npos) << cloth;
  EXPECT_EXIT(run({"devices", "--memory", "sea"}), testing::ExitedWithCode(bad_input), "called 'sea'");
  EXPECT_EXIT(run({"devices", "--memory", ""}), testing::ExitedWithCode(bad_input), "called ''");
  EXPECT_EXIT(run({"devices", "--device", "cpu"}), testing::ExitedWithCode(bad_input), "--memory");
}

TEST_F(ProgramTest, BodiesAreMovedMeasuredAndExported) {
  EXPECT_EXIT(run({"run", "raft", "--device", "cpu", "--out", out(), "--export", "ply,vtp,obj", "--quiet"}),
              testing::ExitedWithCode(success), "^$");
  for (const char* name : {"bodies.csv", "bodies.pvd", "frames/bodies_00001.ply", "frames/bodies_00001.obj",
                           "frames/bodies_00002.vtp", "frames/frame_00002.obj"}) {
    EXPECT_TRUE(fs::exists(fs::path(out()) / name)) << name;
  }
  const auto figures = nlohmann::json::parse(std::ifstream(fs::path(out()) / "summary.json"));
  const auto& bodies = figures["bodies"];
  ASSERT_EQ(bodies.size(), 3u);
  EXPECT_EQ(bodies[0]["name"], "crate");
  EXPECT_NEAR(bodies[0]["mass_kg"].get<double>(), 500 * 0.2 * 0.4 * 0.6, 1e-3);
  EXPECT_NEAR(bodies[0]["velocity_m_s"][1].get<double>(), -9.81 * 0.02, 1e-3) << "it falls";
  EXPECT_LT(bodies[1]["angular_velocity_rad_s"][2].get<double>(), 0) << "it turns about its end";
  EXPECT_EQ(bodies[2]["mass_kg"], 0);
  EXPECT_NEAR(bodies[2]["position_m"][1].get<double>(), 0.2, 1e-4) << "where its keyframes are at 0.02 s";
}

TEST_F(ProgramTest, CheckCountsBodiesAndJoints) {
  testing::internal::CaptureStdout();
  std::vector<std::string> arguments{"meniscus", "check", "raft"};
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  EXPECT_EQ(run_program(static_cast<int>(argv.size()), argv.data()), success);
  EXPECT_NE(testing::internal::GetCapturedStdout().find("shapes 1, bodies 3, joints 1,"), std::string::npos);
}

TEST_F(ProgramTest, OptionsChangeTheScene) {
  EXPECT_EXIT(run({"run", (folder_ / "drop.json").string(), "--set", "world.iterations=5", "--frames", "3",
                   "--device", "cpu", "--out", out(), "--quiet"}),
              testing::ExitedWithCode(success), "^$");
  const auto figures = nlohmann::json::parse(std::ifstream(fs::path(out()) / "summary.json"));
  EXPECT_EQ(figures["iterations"], 5);
  EXPECT_EQ(figures["frames"], 3);
}

TEST_F(ProgramTest, ACheckThatDoesNotHoldIsCodeThree) {
  const auto with_limit = [&](const char* high) {
    auto document = nlohmann::json::parse(scene);
    document["checks"] = {{{"name", "at rest"},
                           {"type", "share_inside"},
                           {"high", std::stof(high)},
                           {"region", {{"lower", {0, 0, 0}}, {"upper", {1, 1, 1}}}}}};
    std::ofstream(folder_ / "checked.json") << document;
    run({"run", "checked", "--device", "cpu", "--out", out(), "--quiet"});
  };
  EXPECT_EXIT(with_limit("1"), testing::ExitedWithCode(success), "^$");
  EXPECT_EXIT(
      with_limit("0.5"), testing::ExitedWithCode(check_broken),
      "^meniscus: the check \"at rest\" broken at 0.01 s: share_inside was 1, allowed is at most 0.5\n$");
  const auto figures = nlohmann::json::parse(std::ifstream(fs::path(out()) / "summary.json"));
  EXPECT_EQ(figures["checks"].at(0)["state"], "broken");
  EXPECT_TRUE(figures["error"].is_null()) << "the run itself is done";
}

TEST_F(ProgramTest, BadInputIsOneLineAndCodeTwo) {
  EXPECT_EXIT(run({}), testing::ExitedWithCode(bad_input), "^meniscus: a command is required[^\n]*\n$");
  EXPECT_EXIT(run({"dance"}), testing::ExitedWithCode(bad_input), "^meniscus: [^\n]*dance[^\n]*\n$");
  EXPECT_EXIT(run({"run"}), testing::ExitedWithCode(bad_input), "^meniscus: scene is required[^\n]*\n$");
  EXPECT_EXIT(run({"run", "flood"}), testing::ExitedWithCode(bad_input),
              "^meniscus: [^\n]*'flood'; samples: drop, flag, raft\n$");
  EXPECT_EXIT(run({"run", std::string(300, 'x')}), testing::ExitedWithCode(bad_input),
              "^meniscus: no scene file [^\n]*\n$");
  EXPECT_EXIT(run({"run", "drop", "--device", "gpu"}), testing::ExitedWithCode(bad_input),
              "^meniscus: --device: gpu");
  EXPECT_EXIT(run({"check", "drop", "--set", "frames=none"}), testing::ExitedWithCode(bad_input),
              "^meniscus: [^\n]*frames[^\n]*\n$");
}

TEST_F(ProgramTest, WhatIsNoSceneIsCalledByItsName) {
  EXPECT_EXIT(run({"run", folder_.string()}), testing::ExitedWithCode(bad_input),
              "^meniscus: '[^\n]*' is a folder, not a scene file\n$");
  write("list.json", "[1, 2]");
  EXPECT_EXIT(run({"run", (folder_ / "list.json").string(), "--device", "cpu"}),
              testing::ExitedWithCode(bad_input),
              "^meniscus: [^\n]*list.json: an array of 2 is not allowed; must be an object[^\n]*\n$");
}

TEST_F(ProgramTest, ResultsThatCannotBeWrittenAreAnError) {
  const auto print_to_a_full_disk = [&] {
    if (std::freopen("/dev/full", "w", stdout)) run({"devices"});
  };
  EXPECT_EXIT(print_to_a_full_disk(), testing::ExitedWithCode(run_failed),
              "^meniscus: cannot write to standard output\n$");
}

TEST_F(ProgramTest, WhatTheWorldRefusesIsNamedByItsPlaceInTheScene) {
  write("torn.json", R"({ "name": "torn", "cloths": [
    { "name": "sheet", "geometry": { "type": "sheet" } },
    { "name": "c", "geometry": { "type": "triangles", "vertices": [[0, 0, 0], [1, 0, 0], [0, 0, 1], [1, 0, 1]],
                                 "triangles": [0, 2, 9] } }] })");
  for (const char* command : {"run", "check"}) {
    EXPECT_EXIT(run({command, "torn"}), testing::ExitedWithCode(bad_input),
                "^meniscus: cloths\\[1\\] \\(\"c\"\\): triangle 0 [^\n]*\n$");
  }
}

TEST_F(ProgramTest, AFrameTimeInMillisecondsIsAWarning) {
  EXPECT_EXIT(run({"check", "drop", "--set", "frame_time=16"}), testing::ExitedWithCode(success),
              testing::ContainsRegex("meniscus: a substep has .* frame_time is in seconds\n"));
}

TEST_F(ProgramTest, AVolumeWithoutParticlesIsAWarning) {
  write("dry.json", R"({ "name": "dry", "frames": 1, "fluids": [{ "name": "water" }], "volumes": [
    { "fluid": "water", "region": { "type": "box", "lower": [0, 0, 0], "upper": [0.4, 0.4, 0.4] } },
    { "fluid": "water", "region": { "type": "box", "lower": [1, 0, 0], "upper": [1.4, 0.001, 0.4] } }] })");
  const auto warning = testing::ContainsRegex("meniscus: volumes\\[1\\] makes no particles\n");
  EXPECT_EXIT(run({"check", "dry"}), testing::ExitedWithCode(success), warning);
  EXPECT_EXIT(run({"run", "dry", "--device", "cpu", "--out", out()}), testing::ExitedWithCode(success),
              warning);
}

TEST_F(ProgramTest, TheVolumeOfOpenClothIsNoCheck) {
  write("open.json", R"({ "name": "open", "cloths": [{ "name": "sheet", "geometry": { "type": "sheet" } }],
    "checks": [{ "type": "outside", "name": "dry" },
               { "type": "cloth_volume", "name": "full", "cloth": "sheet", "low": 0.9 }] })");
  for (const char* command : {"run", "check"}) {
    EXPECT_EXIT(run({command, "open"}), testing::ExitedWithCode(bad_input),
                "^meniscus: checks\\[1\\] \\(\"full\"\\): cloth_volume [^\n]*\"sheet\" has a border\n$");
  }
}

TEST_F(ProgramTest, ARunThatCannotStartLeavesItsFolderAsItWas) {
  fs::create_directories(out());
  std::ofstream(fs::path(out()) / "frames") << "in the way of the folder";
  std::ofstream(fs::path(out()) / "frames.csv") << "of the run before";
  EXPECT_EXIT(run({"run", "drop", "--device", "cpu", "--out", out(), "--export", "ply"}),
              testing::ExitedWithCode(bad_input), "cannot make the folder");
  EXPECT_EQ(bytes(fs::path(out()) / "frames.csv"), "of the run before");
}

TEST_F(ProgramTest, AFolderThatCannotBeUsedStopsTheRunAtOnce) {
  const std::string file = (folder_ / "drop.json").string();
  EXPECT_EXIT(run({"run", "drop", "--device", "cpu", "--out", file}), testing::ExitedWithCode(bad_input),
              "^meniscus: cannot make the folder [^\n]*drop.json[^\n]*\n$");
}

TEST_F(ProgramTest, FailureInTheMiddleKeepsWhatWasDone) {
  // The second frame's file cannot take its place: a folder has its name, with something in it.
  fs::create_directories(fs::path(out()) / "frames" / "frame_00002.ply" / "in_the_way");
  EXPECT_EXIT(run({"run", "drop", "--device", "cpu", "--out", out(), "--export", "ply", "--quiet"}),
              testing::ExitedWithCode(run_failed), "^meniscus: cannot write [^\n]*frame_00002.ply[^\n]*\n$");
  const auto figures = nlohmann::json::parse(std::ifstream(fs::path(out()) / "summary.json"));
  EXPECT_NE(figures["error"].get<std::string>().find("frame_00002.ply"), std::string::npos);
  EXPECT_TRUE(fs::exists(fs::path(out()) / "preview.png"));
  EXPECT_TRUE(fs::exists(fs::path(out()) / "frames" / "frame_00001.ply"));
}

TEST(InterruptTest, ASignalRaisesTheFlagAndNothingElse) {
  for (const int signal : {SIGINT, SIGTERM}) {
    World world{WorldDef{}};
    const Interrupt interrupt(world);
    EXPECT_FALSE(interrupt.raised());
    std::raise(signal);
    EXPECT_TRUE(interrupt.raised());
  }
}

TEST(InterruptTest, TheSecondSignalEnds) {
  EXPECT_EXIT(
      {
        World world{WorldDef{}};
        const Interrupt interrupt(world);
        std::raise(SIGINT);
        std::raise(SIGINT);
      },
      testing::KilledBySignal(SIGINT), "");
}

}  // namespace
}  // namespace meniscus::cli
