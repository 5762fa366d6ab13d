// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Writes files under a temporary name and renames them.
#include "sdk/files/output_file.h"

#include <fcntl.h>
#include <meniscus/error.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <random>

namespace meniscus::io {

namespace {

void remove_quietly(const std::filesystem::path& file) {
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
}

/// A rename would put a file in the place of a device or a pipe.
void expect_replaceable(const std::filesystem::path& path) {
  if (path.native().find('\0') != std::string::npos)
    throw Error(ErrorCode::invalid_argument, "the path of a file has a NUL character: " +
                                                 path.native().substr(0, path.native().find('\0')));
  std::error_code unknown;  // then the system refuses to write there
  const std::filesystem::file_status there = std::filesystem::status(path, unknown);
  if (std::filesystem::exists(there) && !std::filesystem::is_regular_file(there))
    throw Error(ErrorCode::io, "cannot write " + path.string() + ": it is there, and is not a regular file");
}

/// Opens what make_part has made for `path`, or removes it.
std::ofstream open_part(const std::filesystem::path& part, const std::filesystem::path& path) {
  try {
    errno = 0;
    std::ofstream stream(part, std::ios::binary | std::ios::trunc);
    if (!stream) throw_io_error("write", path);
    return stream;
  } catch (...) {
    remove_quietly(part);
    throw;
  }
}

}  // namespace

OutputFile::OutputFile(std::filesystem::path path)
    : path_(std::move(path)), part_(make_part(path_)), stream_(open_part(part_, path_)) {}

OutputFile::~OutputFile() {
  remove_quietly(part_);
}

void OutputFile::write_bytes(const void* data, std::size_t bytes) {
  errno = 0;
  if (!stream_.write(static_cast<const char*>(data), static_cast<std::streamsize>(bytes))) {
    throw_io_error("write", path_);
  }
}

void OutputFile::back_to_start() {
  errno = 0;
  if (!stream_.seekp(0)) throw_io_error("write", path_);
}

void OutputFile::skip(std::size_t bytes) {
  errno = 0;
  if (!stream_.seekp(static_cast<std::streamoff>(bytes), std::ios::cur)) throw_io_error("write", path_);
}

void OutputFile::commit() {
  errno = 0;
  stream_.close();
  if (!stream_ || std::rename(part_.c_str(), path_.c_str()) != 0) throw_io_error("write", path_);
}

std::filesystem::path make_part(const std::filesystem::path& path) {
  expect_replaceable(path);
  std::random_device random;
  for (;;) {
    // A path at once: once the file is there, nothing may fail before its name is known.
    std::array<char, 16> ending{};
    std::snprintf(ending.data(), ending.size(), ".%08x.part", random());
    std::filesystem::path part = path.string() + ending.data();
    const int file = open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (file < 0 && errno == EEXIST) continue;
    if (file < 0) throw_io_error("write", path);
    close(file);
    return part;
  }
}

std::ofstream open_afresh(const std::filesystem::path& path) {
  const std::filesystem::path part = make_part(path);
  std::ofstream stream = open_part(part, path);
  if (std::rename(part.c_str(), path.c_str()) == 0) return stream;
  const int reason = errno;
  remove_quietly(part);
  errno = reason;
  throw_io_error("write", path);
}

void throw_io_error(const std::string& what, const std::filesystem::path& path) {
  const std::string reason = errno ? std::strerror(errno) : "the system gives no reason";
  throw Error(ErrorCode::io, "cannot " + what + " " + path.string() + ": " + reason);
}

}  // namespace meniscus::io
