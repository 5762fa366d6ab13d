// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Memory that runs out while output is written is an error, and leaves no half file.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>

#include "sdk/cli/commands/exit_code.h"
#include "sdk/cli/program.h"
#include "tests/faults/failing_memory.h"

namespace meniscus::tests {
namespace {

namespace fs = std::filesystem;

constexpr const char* coupled = R"({
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

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class OutputFaults : public testing::Test {
 protected:
  OutputFaults() {
    std::string name = (fs::temp_directory_path() / "meniscus_faults_XXXXXX").string();
    if (mkdtemp(name.data())) folder_ = name;
    std::ofstream(folder_ / "coupled.json") << coupled;
  }
  ~OutputFaults() override { fs::remove_all(folder_); }

  /// Makes every stride-th allocation of a run fail, alone or with all that follow.
  void expect_no_half_file(uint64_t stride) {
    ASSERT_EQ(end_of_run({never, false}), 0);
    const auto good = files();
    ASSERT_GT(good.size(), 10u);
    for (const bool and_all_after : {false, true}) {
      std::map<int, int> ends;
      for (uint64_t number = 1;; number += stride) {
        SCOPED_TRACE("allocation " + std::to_string(number));
        fs::remove_all(out());
        const int end = end_of_run({number, and_all_after});
        if (end == without_failure || HasFailure()) break;
        ++ends[end];
        EXPECT_TRUE(end == 0 || end == cli::run_failed || end == no_memory_to_destroy) << end;
        for (const auto& [name, bytes] : files()) {
          const bool is_part = name.ends_with(".part");
          EXPECT_TRUE(!is_part || end == no_memory_to_destroy) << name;
          if (name.starts_with("frames/") && !is_part) {
            EXPECT_TRUE(bytes == good.at(name)) << name;
          }
        }
      }
      for (const auto& [end, times] : ends) std::printf("exit code %d: %d times\n", end, times);
      EXPECT_GT(ends[cli::run_failed], 3);
    }
  }

  /// The exit code of a run.
  int end_of_run(const FailureChoice& choice) const {
    std::fflush(stdout);  // else each child writes it again
    const pid_t child = fork();
    if (child == 0) {
      std::vector<std::string> words{"meniscus", "run",          (folder_ / "coupled.json").string(),
                                     "--out",    out().string(), "--export=ply,vtp,obj",
                                     "--quiet",  "--surface",    "--size=64x36"};
      std::vector<char*> argv;
      for (std::string& word : words) argv.push_back(word.data());
      std::set_terminate([] { std::_Exit(no_memory_to_destroy); });
      if (!freopen("/dev/null", "w", stderr)) std::_Exit(99);
      const FailingMemory failing(choice);
      try {
        const int code = cli::run_program(static_cast<int>(argv.size()), argv.data());
        std::_Exit(choice.number != never && !failing.has_failed() ? without_failure : code);
      } catch (...) {
        std::_Exit(99);
      }
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

  static constexpr uint64_t never = ~uint64_t{0};
  static constexpr int without_failure = 77, no_memory_to_destroy = 78;

  fs::path out() const { return folder_ / "out"; }

  std::map<std::string, std::string> files() const {
    std::map<std::string, std::string> all;
    if (!fs::exists(out())) return all;
    for (const auto& entry : fs::recursive_directory_iterator(out())) {
      if (entry.is_regular_file())
        all[entry.path().lexically_relative(out()).string()] = bytes_of(entry.path());
    }
    return all;
  }

  fs::path folder_;
};

/// Each failure in a process of its own: the JSON library ends it where its destructors lack memory.
TEST_F(OutputFaults, ARunThatLosesMemoryLeavesNoHalfFile) {
  expect_no_half_file(1499);
}

TEST_F(OutputFaults, ARunThatLosesMemoryAnywhereLeavesNoHalfFileLong) {
  expect_no_half_file(97);
}

}  // namespace
}  // namespace meniscus::tests
