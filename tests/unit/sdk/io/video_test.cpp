// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Videos, with programs in place of ffmpeg that record their input, and with ffmpeg itself where it is
// installed.
#include "sdk/io/video.h"

#include <fstream>

#include "tests/expect_error.h"

namespace meniscus::tests {
namespace {

namespace fs = std::filesystem;

class VideoTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / (std::string("meniscus_video_") +
                                           testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_ / "bin");
    old_path_ = std::getenv("PATH");
  }
  void TearDown() override {
    setenv("PATH", old_path_.c_str(), 1);
    fs::remove_all(folder_);
  }

  /// The body of a shell script that stands in for ffmpeg.
  void put_in_place_of_ffmpeg(const std::string& script) const {
    std::ofstream(folder_ / "bin/ffmpeg") << "#!/bin/sh\n" << script;
    fs::permissions(folder_ / "bin/ffmpeg", fs::perms::all);
    setenv("PATH", ((folder_ / "bin").string() + ":" + old_path_).c_str(), 1);
  }
  static std::string contents(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  fs::path file() const { return folder_ / "a run.mp4"; }
  /// Nothing but the folder of programs is there.
  bool nothing_left() const { return std::distance(fs::directory_iterator(folder_), {}) == 1; }

  fs::path folder_;

 private:
  std::string old_path_;
};

io::Image frame(uint8_t value) {
  io::Image image{64, 48, {}};
  for (int i = 0; i < 3 * 64 * 48; ++i) image.rgb.push_back(static_cast<uint8_t>(value + i));
  return image;
}

TEST_F(VideoTest, FfmpegGetsEveryPixelAndTheRateAndMakesTheFile) {
  // The last word is file:PATH.
  put_in_place_of_ffmpeg("for last; do :; done; cat > \"${last#file:}\"; echo \"$*\" > " +
                         (folder_ / "words").string());
  io::VideoFile video(file(), 64, 48, 62.5);
  video.add(frame(0));
  video.add(frame(9));
  EXPECT_FALSE(fs::exists(file())) << "before it is whole";
  video.commit();
  std::string expected;
  for (const io::Image& image : {frame(0), frame(9)}) expected.append(image.rgb.begin(), image.rgb.end());
  EXPECT_EQ(contents(file()), expected);
  EXPECT_NE(contents(folder_ / "words").find("-video_size 64x48 -framerate 62.5 "), std::string::npos);
}

TEST_F(VideoTest, WithoutFfmpegTheErrorSaysSoAndNothingIsLeft) {
  setenv("PATH", "/nonexistent", 1);
  expect_error(ErrorCode::io, "Debian's package ffmpeg", [&] { io::VideoFile(file(), 64, 48, 60); });
  EXPECT_TRUE(nothing_left());
}

TEST_F(VideoTest, WhatFfmpegComplainsAboutIsPassedOn) {
  put_in_place_of_ffmpeg("echo 'no room for pixels' >&2; exit 1");
  io::VideoFile video(file(), 64, 48, 60);
  expect_error(ErrorCode::io, "no room for pixels", [&] {
    for (int i = 0; i < 1000; ++i) video.add(frame(0));  // more than any buffer holds
  });
  expect_error(ErrorCode::io, "no room for pixels", [&] { video.commit(); });
  EXPECT_FALSE(fs::exists(file()));
  expect_error(ErrorCode::io, "no room for pixels", [&] {
    io::VideoFile empty(file(), 64, 48, 60);
    empty.commit();
  });
}

TEST_F(VideoTest, WithoutACommitNothingStays) {
  put_in_place_of_ffmpeg("for last; do :; done; cat > \"${last#file:}\"");
  {
    io::VideoFile video(file(), 64, 48, 60);
    video.add(frame(0));
  }
  EXPECT_TRUE(nothing_left());
}

TEST_F(VideoTest, BadNamesAreRefused) {
  expect_error(ErrorCode::invalid_argument, "run.avi",
               [&] { io::VideoFile(folder_ / "run.avi", 64, 48, 60); });
  expect_error(ErrorCode::io, "nowhere", [&] { io::VideoFile(folder_ / "nowhere/run.mp4", 64, 48, 60); });
  EXPECT_TRUE(nothing_left());
}

TEST_F(VideoTest, FfmpegItselfMakesAVideo) {
  if (std::system("ffmpeg -version > /dev/null 2>&1") != 0) GTEST_SKIP() << "there is no ffmpeg";
  io::VideoFile video(file(), 63, 47, 60);  // odd sizes too
  io::Image image = frame(0);
  image.width = 63;
  image.height = 47;
  image.rgb.resize(3 * 63 * 47);
  for (int i = 0; i < 5; ++i) video.add(image);
  video.commit();
  EXPECT_EQ(contents(file()).substr(4, 4), "ftyp");  // as MP4 files begin
}

}  // namespace
}  // namespace meniscus::tests
