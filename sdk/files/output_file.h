// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Output files that appear under their names only when they are complete.
#pragma once

#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>

namespace meniscus::io {

/// A file that appears complete or not at all: it is written under a name of make_part, and commit() gives it
/// its own. What stands at PATH is replaced and never written through, even if it is a symbolic link.
class OutputFile {
 public:
  /// Throws Error(io) if the file cannot be made.
  explicit OutputFile(std::filesystem::path path);
  /// Without a commit, no file remains.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view text) { write_bytes(text.data(), text.size()); }
  template <class T, std::size_t N>
  void write(std::span<const T, N> values) {
    write_bytes(values.data(), values.size_bytes());
  }

  /// For libraries that write to a stream. commit() reports what failed there.
  std::ostream& stream() { return stream_; }

  /// What is written next replaces the first bytes.
  void back_to_start();
  /// Leaves bytes out, which others write into part().
  void skip(std::size_t bytes);
  /// The name under which the file is until commit().
  const std::filesystem::path& part() const { return part_; }

  /// Throws Error(io) if not all bytes could be written; a file of that name is then unchanged.
  void commit();

 private:
  void write_bytes(const void* data, std::size_t bytes);

  std::filesystem::path path_, part_;
  std::ofstream stream_;
};

/// Makes an empty file PATH.XXXXXXXX.part, with hexadecimal digits that no other file there has, and returns
/// its path. Throws Error(io).
std::filesystem::path make_part(const std::filesystem::path& path);

/// A new file at PATH, open for writing. It replaces what stands there, as OutputFile does. Throws Error(io).
std::ofstream open_afresh(const std::filesystem::path& path);

/// Throws Error(io): "cannot WHAT PATH: REASON", the reason from errno.
[[noreturn]] void throw_io_error(const std::string& what, const std::filesystem::path& path);

}  // namespace meniscus::io
