// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Starts ffmpeg and sends it pictures.
#include "sdk/io/video.h"

#include <meniscus/error.h>
#include <spawn.h>
#include <spdlog/fmt/fmt.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string>
#include <vector>

#include "sdk/files/output_file.h"

extern char** environ;

namespace meniscus::io {
namespace {

/// Starts a process whose input is `in`, and whose output and errors are `out`. It has a group of its own, so
/// that Ctrl-C does not end it; we do.
int spawn(pid_t& process, std::vector<std::string> words, int in, int out) {
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, in, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, out, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, out, STDERR_FILENO);
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  const int failure = posix_spawnp(&process, argv[0], &files, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return failure;
}

}  // namespace

VideoFile::VideoFile(std::filesystem::path path, int width, int height, double rate)
    : path_(std::move(path)) {
  if (path_.extension() != ".mp4") {
    throw Error(ErrorCode::invalid_argument,
                "the video is to be '" + path_.string() + "', but its name must end in .mp4");
  }
  part_ = make_part(path_);
  try {
    start(width, height, rate);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(part_, ignored);
    if (words_) std::fclose(words_);
    throw;
  }
}

void VideoFile::start(int width, int height, double rate) {
  // A socket rather than a pipe: a failed write to it raises no signal.
  std::array<int, 2> ends;
  words_ = std::tmpfile();
  if (!words_ || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw_io_error("write", path_);
  const int failure =
      spawn(process_,
            {"ffmpeg", "-loglevel", "error", "-y", "-f", "rawvideo", "-pixel_format", "rgb24", "-video_size",
             fmt::format("{}x{}", width, height), "-framerate", fmt::format("{:.9g}", rate), "-i", "pipe:0",
             // Players support this format of colours best, and it needs even sizes.
             "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f",
             "mp4", "file:" + part_.string()},
            ends[0], fileno(words_));
  close(ends[0]);
  to_ffmpeg_ = ends[1];
  if (failure == 0) return;
  close(to_ffmpeg_);
  process_ = -1;
  throw Error(ErrorCode::io, "cannot write the video " + path_.string() + ": ffmpeg does not start (" +
                                 std::strerror(failure) + "); Debian's package ffmpeg brings it");
}

VideoFile::~VideoFile() {
  finish();
  std::fclose(words_);
  std::error_code ignored;
  std::filesystem::remove(part_, ignored);
}

void VideoFile::add(const Image& image) {
  const uint8_t* from = image.rgb.data();
  for (std::size_t left = image.rgb.size(); left > 0;) {
    const ssize_t sent = send(to_ffmpeg_, from, left, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) fail();
    from += sent;
    left -= static_cast<std::size_t>(sent);
  }
}

void VideoFile::commit() {
  if (failed_ || finish() != 0) fail();
  errno = 0;
  if (std::rename(part_.c_str(), path_.c_str()) != 0) throw_io_error("write", path_);
}

int VideoFile::finish() {
  if (process_ < 0) return 0;
  close(to_ffmpeg_);
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
  process_ = -1;
  return status;
}

void VideoFile::fail() {
  finish();
  failed_ = true;
  std::string said(1000, '\0');
  std::rewind(words_);
  said.resize(std::fread(said.data(), 1, said.size(), words_));
  while (!said.empty() && said.back() == '\n') said.pop_back();
  std::replace(said.begin(), said.end(), '\n', ' ');
  throw Error(ErrorCode::io, "ffmpeg cannot write the video " + path_.string() + ": " +
                                 (said.empty() ? "it gives no reason" : said));
}

}  // namespace meniscus::io
