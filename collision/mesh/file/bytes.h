// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads whole files, up to a bound.
#pragma once

#include <meniscus/defs.h>

#include <cstdint>
#include <optional>
#include <string>

namespace meniscus::collision {

/// Where mesh files are read: by a reader of the program, or else in the file system.
class FileSource {
 public:
  explicit FileSource(const FileReader& reader) : reader_(reader) {}

  /// What a reader returns is kept for the read() that follows.
  bool has(const std::string& name) const;
  /// All bytes of a file. `left` is what may still be read for one mesh, in bytes, and is reduced. In the
  /// file system it must be a regular file: a pipe or a device is never waited for. Throws Error(io) if there
  /// is no such file or it cannot be read, and FileDefect if it is larger than `left`.
  std::string read(const std::string& name, uint64_t& left) const;

 private:
  FileReader reader_;
  mutable std::string found_name_;
  mutable std::optional<std::string> found_;
};

}  // namespace meniscus::collision
