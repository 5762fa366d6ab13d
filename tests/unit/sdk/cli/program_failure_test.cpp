// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The command line program where the system refuses what it asks for, or where names and files are hostile.

#include <sys/stat.h>

#include "sdk/cli/commands/scene_lookup.h"
#include "sdk/cli/output/folder_lock.h"
#include "tests/no_threads.h"
#include "tests/unit/sdk/cli/program_fixture.h"

namespace meniscus::cli {
namespace {

constexpr const char* coupled = R"({
  "name": "coupled", "frames": 2,
  "world": { "particle_spacing": 0.2, "substeps": 2, "iterations": 4, "threads": 1 },
  "fluids": [{ "name": "water" }],
  "shapes": [{ "name": "tank", "geometry": { "type": "container", "half_extents": [1, 1, 1] } }],
  "bodies": [{ "name": "crate", "geometry": { "type": "box", "half_extents": [0.2, 0.2, 0.2] }, "pose": { "position": [0.5, 0, 0] } }],
  "cloths": [{ "name": "sheet", "geometry": { "type": "sheet", "width": 0.8, "depth": 0.8, "columns": 5, "rows": 5 } }],
  "volumes": [{ "fluid": "water", "region": { "type": "box", "lower": [-1, -1, -1], "upper": [0, 0, 1] } }]
})";

TEST_F(ProgramTest, ARunWhoseThreadCannotStartEndsWithAnError) {
  write("coupled.json", coupled);
  const auto run_without_threads = [this] {
    const tests::NoThreads none;
    run({"run", "coupled", "--device", "cpu", "--out", out(), "--export", "ply", "--quiet"});
  };
  EXPECT_EXIT(run_without_threads(), testing::ExitedWithCode(run_failed),
              "^meniscus: the side thread of a step could not be started: [^\n]*\n$");
  EXPECT_TRUE(fs::exists(out() + "/frames/frame_00000.ply")) << "written by the thread of the run";
}

constexpr const char* hostile = R"({
  "name": "a\u001b[2Jb\n/..", "frames": 1, "world": { "particle_spacing": 0.1, "substeps": 1, "iterations": 1 },
  "fluids": [{ "name": "water" }],
  "bodies": [{ "name": "=1+1\u0007", "geometry": { "type": "box" } }],
  "volumes": [{ "fluid": "water", "region": { "type": "box", "lower": [2, 0, 0], "upper": [2.4, 0.4, 0.4] } }],
  "checks": [{ "name": "red\u001b[31m", "type": "share_inside", "high": 0.5,
               "region": { "lower": [-9, -9, -9], "upper": [9, 9, 9] } }]
})";

TEST_F(ProgramTest, NamesAreShownAsPlainText) {
  write("hostile.json", hostile);
  const std::string said = printed({"check", "hostile"});
  EXPECT_NE(said.find("a\\x1b[2Jb\\x0a/.."), std::string::npos) << said;
  EXPECT_EXIT(run({"run", "hostile", "--device", "cpu", "--quiet", "--out", out()}),
              testing::ExitedWithCode(check_broken), "red.x1b.31m[^\n]*\n$");
  const std::string bodies = bytes(fs::path(out()) / "bodies.csv");
  EXPECT_NE(bodies.find(",'=1+1\\x07,"), std::string::npos) << bodies;
  const std::string chart = bytes(fs::path(out()) / "density.svg");
  EXPECT_EQ(chart.find('\x1b'), std::string::npos);
  EXPECT_NE(chart.find("a\\x1b[2Jb"), std::string::npos);
  EXPECT_EXIT(run({"run", "no\x1b[2J\xff"}), testing::ExitedWithCode(bad_input), "called 'no.x1b.2J.xff'");
}

TEST_F(ProgramTest, AFolderIsNamedInPlainText) {
  Scene named;
  named.name = std::string("a/\n\0b\xff", 6);
  EXPECT_EQ(default_folder(named), "out/a_\\x0a\\x00b\\xff");
}

TEST_F(ProgramTest, SymbolicLinksInTheFolderAreReplacedAndNotFollowed) {
  fs::create_directories(out());
  const std::vector<std::string> names{"frames.csv", "summary.json", "density.svg", "preview.png",
                                       "particles.pvd"};
  for (const std::string& name : names) {
    write(name.c_str(), "mine");
    fs::create_symlink(folder_ / name, fs::path(out()) / name);
    fs::create_symlink(folder_ / name, fs::path(out()) / (name + ".part"));
  }
  printed({"run", "drop", "--device", "cpu", "--frames", "1", "--export", "vtp", "--quiet", "--out", out()});
  for (const std::string& name : names) {
    EXPECT_EQ(bytes(folder_ / name), "mine") << name;
    EXPECT_FALSE(fs::is_symlink(fs::path(out()) / name)) << name;
  }
}

TEST_F(ProgramTest, ARecordingReplacesNoPipe) {
  const std::string pipe = (folder_ / "pipe").string();
  mkfifo(pipe.c_str(), 0600);
  EXPECT_EXIT(
      run({"run", "drop", "--device", "cpu", "--frames", "1", "--quiet", "--out", out(), "--record", pipe}),
      testing::ExitedWithCode(bad_input), "pipe: it is there, and is not a regular file");
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST_F(ProgramTest, ARunDoesNotReplaceItsInputs) {
  fs::create_directories(out());
  fs::copy_file(folder_ / "drop.json", fs::path(out()) / "summary.json",
                fs::copy_options::overwrite_existing);
  const std::string scene = (fs::path(out()) / "summary.json").string(), before = bytes(scene);
  const auto is_refused = [&](std::vector<std::string> more, const char* why) {
    std::vector<std::string> words{"run", scene, "--device", "cpu", "--frames", "1", "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EXIT(run(words), testing::ExitedWithCode(bad_input), why);
    EXPECT_EQ(bytes(scene), before);
  };
  is_refused({"--out", out()}, "would replace the scene, .*--out names another folder");
  is_refused({"--out", out(), "--worlds", "2"}, "would replace the scene, .*--out names another folder");
  const std::string elsewhere = (folder_ / "elsewhere").string(), file = (folder_ / "both").string();
  is_refused({"--out", elsewhere, "--record", scene}, "--record .* would replace the scene");
  is_refused({"--out", elsewhere, "--record", file, "--video", file},
             "--video .*both would replace --record");
}

TEST_F(ProgramTest, AFolderOfFramesThatIsALinkIsRefused) {
  fs::create_directories(out());
  fs::create_directories(folder_ / "elsewhere");
  write("elsewhere/frame_00001.ply", "mine");
  std::error_code again;  // in the child of the death test
  fs::create_directory_symlink(folder_ / "elsewhere", fs::path(out()) / "frames", again);
  EXPECT_EXIT(run({"run", "drop", "--device", "cpu", "--export", "ply", "--quiet", "--out", out()}),
              testing::ExitedWithCode(bad_input), "out/frames is a symbolic link");
  printed({"run", "drop", "--device", "cpu", "--frames", "1", "--quiet", "--out", out()});
  EXPECT_EQ(bytes(folder_ / "elsewhere/frame_00001.ply"), "mine");
}

TEST_F(ProgramTest, TwoRunsInOneFolderAreRefused) {
  fs::create_directories(out());
  const auto run_in_a_held_folder = [this] {
    const FolderLock held(out());
    run({"run", "drop", "--device", "cpu", "--quiet", "--out", out()});
  };
  EXPECT_EXIT(run_in_a_held_folder(), testing::ExitedWithCode(bad_input),
              "^meniscus: another run writes to the folder [^\n]*out; choose another by --out\n$");
  EXPECT_TRUE(fs::is_empty(out()));
  printed({"run", "drop", "--device", "cpu", "--frames", "1", "--quiet", "--out", out()});
}

TEST_F(ProgramTest, PartsOfARunThatWasKilledAreTakenAway) {
  fs::create_directories(out() + "/frames");
  write("out/summary.json.0123abcd.part", "half");
  write("out/frames/frame_00007.ply.0123abcd.part", "half");
  write("out/mine.json.0123abcd.part", "mine");
  printed({"run", "drop", "--device", "cpu", "--frames", "1", "--quiet", "--out", out()});
  EXPECT_FALSE(fs::exists(out() + "/summary.json.0123abcd.part"));
  EXPECT_FALSE(fs::exists(out() + "/frames"));
  EXPECT_TRUE(fs::exists(out() + "/mine.json.0123abcd.part"));
}

TEST_F(ProgramTest, ASceneFileWithoutAnEndIsRefused) {
  EXPECT_EXIT(run({"check", "/dev/zero"}), testing::ExitedWithCode(bad_input),
              "^meniscus: /dev/zero: is longer than 268435456 bytes");
}

}  // namespace
}  // namespace meniscus::cli
