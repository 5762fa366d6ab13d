// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Runs `meniscus run` on a small coupled scene in a process of its own, where something is made to fail.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "sdk/cli/commands/exit_code.h"
#include "sdk/cli/program.h"

namespace meniscus::tests {

namespace fs = std::filesystem;

inline constexpr const char* coupled = R"({
  "name": "coupled", "frames": 1, "frame_time": 0.01,
  "world": { "particle_spacing": 0.2, "substeps": 1, "iterations": 2, "threads": 1, "device": "cpu",
             "diffuse": { "capacity": 100 } },
  "fluids": [{ "name": "water" }],
  "shapes": [{ "name": "tank", "geometry": { "type": "container", "half_extents": [1, 1, 1] } }],
  "bodies": [{ "name": "crate", "geometry": { "type": "box", "half_extents": [0.2, 0.2, 0.2] },
               "pose": { "position": [0.5, 0, 0] } }],
  "cloths": [{ "name": "sheet", "geometry": { "type": "sheet", "width": 0.8, "depth": 0.8, "columns": 4, "rows": 4 } }],
  "ropes": [{ "name": "line", "points": [[0.5, 0.5, 0], [0.8, 0.5, 0]], "segments": 3 }],
  "attachments": [{ "name": "corner", "cloth": "sheet", "vertices": [0] }],
  "volumes": [{ "fluid": "water", "region": { "type": "box", "lower": [-1, -1, -1], "upper": [0, -0.6, 0] } }]
})";

inline std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class ProgramRuns : public testing::Test {
 protected:
  ProgramRuns() {
    std::string name = (fs::temp_directory_path() / "meniscus_faults_XXXXXX").string();
    if (mkdtemp(name.data())) folder_ = name;
    std::ofstream(folder_ / "coupled.json") << coupled;
  }
  ~ProgramRuns() override { fs::remove_all(folder_); }

  fs::path out() const { return folder_ / "out"; }
  std::string said() const { return bytes_of(folder_ / "said.txt"); }

  std::map<std::string, std::string> files() const {
    std::map<std::string, std::string> all;
    if (!fs::exists(out())) return all;
    for (const auto& entry : fs::recursive_directory_iterator(out())) {
      if (entry.is_regular_file())
        all[entry.path().lexically_relative(out()).string()] = bytes_of(entry.path());
    }
    return all;
  }

  /// Frames are there as in a good run or not at all. Of USD, a good run keeps no layers of frames, and
  /// such layers must end where they should.
  void expect_no_half_file(const std::map<std::string, std::string>& good, bool parts_may_be_there) const {
    for (const auto& [name, bytes] : files()) {
      const bool is_part = name.ends_with(".part");
      EXPECT_TRUE(!is_part || parts_may_be_there) << name;
      if (name.ends_with(".usda")) {
        EXPECT_TRUE(bytes.starts_with("#usda 1.0\n") && bytes.ends_with("\n}\n")) << name;
      } else if (name.starts_with("frames/") && !is_part) {
        const auto same = good.find(name);
        EXPECT_TRUE(same != good.end() && bytes == same->second) << name;
      }
    }
  }

  /// The exit code of a run, or minus the signal that ended it. Before it `prepare` is called in its process,
  /// and after it `code_after(code)`. Its messages go to a file.
  template <class Prepare, class CodeAfter>
  int end_of_run(const Prepare& prepare, const CodeAfter& code_after) const {
    std::fflush(stdout);  // else each child writes it again
    const pid_t child = fork();
    if (child == 0) {
      std::vector<std::string> words{"meniscus", "run",          (folder_ / "coupled.json").string(),
                                     "--out",    out().string(), "--export=ply,vtp,obj,usd",
                                     "--quiet",  "--surface",    "--size=64x36"};
      std::vector<char*> argv;
      for (std::string& word : words) argv.push_back(word.data());
      if (!freopen((folder_ / "said.txt").c_str(), "w", stderr)) std::_Exit(99);
      prepare();
      try {
        const int code = cli::run_program(static_cast<int>(argv.size()), argv.data());
        std::fflush(stderr);
        std::_Exit(code_after(code));
      } catch (...) {
        std::_Exit(99);
      }
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

  int end_of_good_run() const {
    return end_of_run([] {}, [](int code) { return code; });
  }

  fs::path folder_;
};

}  // namespace meniscus::tests
