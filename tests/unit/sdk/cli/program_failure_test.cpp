// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The command line program where the system refuses what it asks for.
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
    run({"run", "coupled", "--device", "cpu", "--out", out(), "--quiet"});
  };
  EXPECT_EXIT(run_without_threads(), testing::ExitedWithCode(run_failed),
              "^meniscus: the side thread of a step could not be started: [^\n]*\n$");
}

}  // namespace
}  // namespace meniscus::cli
