// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The container of recordings: a header, and records one after the other.
#pragma once

#include <cstdint>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace meniscus {

enum class RecordKind : uint32_t {
  call = 1,   ///< CBOR: call_text.h
  state = 2,  ///< a snapshot file
  end = 3,    ///< nothing
};

struct Record {
  RecordKind kind;
  std::vector<uint8_t> bytes;
};

/// What a recording says of itself.
struct RecordingHeader {
  std::string program;  ///< the version that wrote it
  std::string device;   ///< "cpu" or "cuda"
};

/// Writes records. The format (docs/snapshots.md), of which there is one so far:
///
///   8 bytes   "MENISREC"
///   u32       the format's version
///   u32       length of the header, bytes
///   u64       xxh3 of the header
///   header    JSON: program, device
///   records   u32 kind, u32 zero, u64 length in bytes, u64 xxh3 of these bytes, the bytes
class RecordWriter {
 public:
  /// Throws Error(io) if the file cannot be made.
  RecordWriter(const std::string& path, const RecordingHeader& header);
  /// Hands the record to the system, so that it outlives a crash of the program. Throws Error(io).
  void write(RecordKind kind, std::span<const uint8_t> bytes);

 private:
  std::string path_;
  std::ofstream stream_;
};

/// Reads them. Its calls throw Error(io) with the reason if a byte is not as it was written.
class RecordReader {
 public:
  explicit RecordReader(const std::string& path);
  const RecordingHeader& header() const { return header_; }
  const std::string& path() const { return path_; }
  /// The next record. Nothing at the end of the file, or where it ends within a record.
  std::optional<Record> next();

 private:
  std::string path_;
  std::ifstream stream_;
  uint64_t bytes_left_ = 0;
  RecordingHeader header_;
};

}  // namespace meniscus
