// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Pages of Markdown with files beside them.
#include "sdk/io/report.h"

#include <gtest/gtest.h>
#include <meniscus/error.h>

#include <fstream>

namespace meniscus::io {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(ReportTest, WritesAPageAndItsFiles) {
  const fs::path folder = fs::temp_directory_path() / "meniscus_report_test";
  fs::remove_all(folder);
  fs::create_directories(folder);
  Report report("Waves");
  report.heading("Height");
  report.table({"a", "b"}, {{"1", "x|y\nz"}});
  report.chart("height", {"Height", "time (s)", {0, 1}, {{"m", {{"h", "#000000", {0, 1}}}}}});
  report.picture("wave", "A wave", {1, 1, {1, 2, 3}});
  report.figures["h"] = 2;
  report.write(folder / "waves.md");
  EXPECT_EQ(content(folder / "waves.md"),
            "# Waves\n\n## Height\n\n| a | b |\n|---|---|\n| 1 | x/y z |\n\n"
            "![Height](waves/height.svg)\n\n![A wave](waves/wave.png)\n");
  EXPECT_EQ(content(folder / "waves/figures.json"), "{\n \"h\": 2\n}\n");
  EXPECT_NE(content(folder / "waves/height.svg").find("<svg"), std::string::npos);
  EXPECT_TRUE(fs::exists(folder / "waves/wave.png"));
  std::ofstream(folder / "other") << "a file";
  EXPECT_THROW(report.write(folder / "other.md"), Error) << "its folder would be that file";
  fs::remove_all(folder);
}

}  // namespace
}  // namespace meniscus::io
