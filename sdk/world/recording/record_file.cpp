// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads and writes the container of recordings.
#include "sdk/world/recording/record_file.h"

#include <meniscus/error.h>
#include <meniscus/version.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "sdk/files/output_file.h"
#include "sdk/world/state/chunk_format.h"

namespace meniscus {

using chunk_format::Json;
using chunk_format::Prefix;

namespace {

constexpr char magic[8] = {'M', 'E', 'N', 'I', 'S', 'R', 'E', 'C'};
constexpr uint32_t version = 1;

struct RecordHead {
  uint32_t kind, zero;
  uint64_t bytes, hash;
};
static_assert(sizeof(RecordHead) == 24);

[[noreturn]] void refuse_recording(const std::string& path, const std::string& why) {
  throw Error(ErrorCode::io, path + " is no usable recording: " + why);
}

template <class T>
void put(std::ofstream& stream, const T& value) {
  stream.write(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class T>
void get(std::ifstream& stream, T& value) {
  stream.read(reinterpret_cast<char*>(&value), sizeof value);
}

}  // namespace

RecordWriter::RecordWriter(const std::string& path, const RecordingHeader& header)
    : path_(path), stream_(io::open_afresh(path)) {
  const std::string text = Json{{"program", header.program}, {"device", header.device}}.dump();
  Prefix prefix{{}, version, static_cast<uint32_t>(text.size()), XXH3_64bits(text.data(), text.size())};
  std::memcpy(prefix.magic, magic, sizeof magic);
  put(stream_, prefix);
  stream_ << text << std::flush;
  if (!stream_) io::throw_io_error("write", path_);
}

void RecordWriter::write(RecordKind kind, std::span<const uint8_t> bytes) {
  errno = 0;
  put(stream_,
      RecordHead{static_cast<uint32_t>(kind), 0, bytes.size(), XXH3_64bits(bytes.data(), bytes.size())});
  stream_.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  stream_.flush();
  if (!stream_) io::throw_io_error("write", path_);
}

RecordReader::RecordReader(const std::string& path) : path_(path), stream_(path, std::ios::binary) {
  std::error_code no_size;
  bytes_left_ = std::filesystem::file_size(path, no_size);
  if (!stream_ || no_size) io::throw_io_error("read", path);
  Prefix prefix{};
  if (bytes_left_ < sizeof prefix) refuse_recording(path, "it ends within its first bytes");
  get(stream_, prefix);
  bytes_left_ -= sizeof prefix;
  if (std::memcmp(prefix.magic, magic, sizeof magic) != 0)
    refuse_recording(path, "it does not begin with MENISREC");
  if (prefix.version != version) {
    refuse_recording(path, "its format is version " + std::to_string(prefix.version) +
                               ", and this program (" + MENISCUS_VERSION_STRING + ") knows version " +
                               std::to_string(version));
  }
  if (prefix.header_bytes > bytes_left_) refuse_recording(path, "it ends within its header");
  std::string text(prefix.header_bytes, '\0');
  stream_.read(text.data(), static_cast<std::streamsize>(text.size()));
  bytes_left_ -= text.size();
  if (!stream_ || XXH3_64bits(text.data(), text.size()) != prefix.header_hash)
    refuse_recording(path, "its header is damaged");
  const Json json = Json::parse(text, nullptr, false);
  try {
    header_ = {json.at("program").get<std::string>(), json.at("device").get<std::string>()};
  } catch (const Json::exception& wrong) {
    refuse_recording(path, std::string("its header is not as it should be: ") + wrong.what());
  }
}

std::optional<Record> RecordReader::next() {
  RecordHead head{};
  if (bytes_left_ < sizeof head) return std::nullopt;
  get(stream_, head);
  bytes_left_ -= sizeof head;
  if (head.bytes > bytes_left_) return std::nullopt;
  bytes_left_ -= head.bytes;
  Record record{static_cast<RecordKind>(head.kind), std::vector<uint8_t>(head.bytes)};
  stream_.read(reinterpret_cast<char*>(record.bytes.data()), static_cast<std::streamsize>(head.bytes));
  if (!stream_) io::throw_io_error("read", path_);
  const bool is_known = head.kind >= 1 && head.kind <= 3 && head.zero == 0;
  if (!is_known || XXH3_64bits(record.bytes.data(), record.bytes.size()) != head.hash)
    refuse_recording(path_, "a record of it is damaged");
  return record;
}

}  // namespace meniscus
