// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads the container of snapshots.
#include "sdk/world/state/chunk_file.h"

#include <meniscus/error.h>
#include <meniscus/version.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "sdk/files/output_file.h"
#include "sdk/world/state/chunk_format.h"
#include "sdk/world/state/whole_number.h"

namespace meniscus {

using namespace chunk_format;

namespace {

[[noreturn]] void refuse_snapshot(const std::string& path, const std::string& why) {
  throw Error(ErrorCode::io, path + " is no usable snapshot: " + why);
}

Json parsed_header(const std::string& path, const std::string& text) {
  Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) refuse_snapshot(path, "its header is no JSON");
  return json;
}

template <class T>
T whole_member(const std::string& path, const Json& chunk, const char* name) {
  if (const auto value = whole_number<T>(chunk.at(name))) return *value;
  refuse_snapshot(path, std::string("its header is not as it should be: \"") + name +
                            "\" of a chunk is no whole number in range");
}

/// Whether the bytes of a chunk are as they were written.
bool is_intact(const std::string& path, const Json& chunk, const pbd::StateItem& item) {
  if (!chunk.contains("parts"))
    return XXH3_64bits(item.host.data(), item.host.size()) == whole_member<uint64_t>(path, chunk, "xxh3");
  std::size_t at = 0;
  for (const Json& part : chunk.at("parts")) {
    const auto count = whole_member<std::size_t>(path, part, "count");
    if (count > item.count || count * item.element_bytes > item.host.size() - at) return false;
    const std::size_t bytes = count * item.element_bytes;
    if (XXH3_64bits(item.host.data() + at, bytes) != whole_member<uint64_t>(path, part, "xxh3")) return false;
    at += bytes;
  }
  return at == item.host.size();
}

/// Reads one chunk, which is in the file to its end.
pbd::StateItem read_chunk(const std::string& path, const Json& chunk, std::istream& stream,
                          uint64_t& bytes_left) {
  const auto name = chunk.at("name").get<std::string>();
  if (whole_member<uint32_t>(path, chunk, "version") > parted_version)
    refuse_snapshot(path, "its chunk \"" + name + "\" is of a later version");
  pbd::StateItem item{.form = chunk.at("form").get<std::string>(),
                      .element_bytes = whole_member<uint32_t>(path, chunk, "element_bytes"),
                      .count = whole_member<std::size_t>(path, chunk, "count"),
                      .required = chunk.at("required").get<bool>()};
  if (item.element_bytes == 0 || item.count > bytes_left / item.element_bytes)
    refuse_snapshot(path, "it ends within the chunk \"" + name + "\"");
  bytes_left -= item.bytes();
  item.host.resize(item.bytes());
  stream.read(reinterpret_cast<char*>(item.host.data()), static_cast<std::streamsize>(item.bytes()));
  if (!stream) io::throw_io_error("read", path);
  if (!is_intact(path, chunk, item)) refuse_snapshot(path, "its chunk \"" + name + "\" is damaged");
  return item;
}

/// The JSON of a file's header. The stream is then behind it.
Json read_header(const std::string& path, std::istream& stream, uint64_t& bytes_left) {
  Prefix prefix{};
  if (bytes_left < sizeof prefix) refuse_snapshot(path, "it ends within its first bytes");
  stream.read(reinterpret_cast<char*>(&prefix), sizeof prefix);
  bytes_left -= sizeof prefix;
  if (std::memcmp(prefix.magic, magic, sizeof magic) != 0)
    refuse_snapshot(path, "it does not begin with MENISNAP");
  if (prefix.version != format_version) {
    refuse_snapshot(path, "its format is version " + std::to_string(prefix.version) + ", and this program (" +
                              MENISCUS_VERSION_STRING + ") knows version " + std::to_string(format_version));
  }
  if (prefix.header_bytes > bytes_left) refuse_snapshot(path, "it ends within its header");
  std::string text(prefix.header_bytes, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!stream) io::throw_io_error("read", path);
  bytes_left -= text.size();
  if (XXH3_64bits(text.data(), text.size()) != prefix.header_hash)
    refuse_snapshot(path, "its header is damaged");
  return parsed_header(path, text);
}

/// Calls use(), which takes members of the header.
template <class Use>
auto with_members(const std::string& path, const Use& use) {
  try {
    return use();
  } catch (const Json::exception& wrong) {
    refuse_snapshot(path, std::string("its header is not as it should be: ") + wrong.what());
  }
}

ChunkFileHeader header_of(const std::string& path, const Json& json) {
  return with_members(path, [&]() -> ChunkFileHeader {
    return {json.at("program").get<std::string>(), json.at("device").get<std::string>(),
            json.at("time").get<double>(), json.at("definitions").get<std::string>()};
  });
}

struct OpenFile {
  std::ifstream stream;
  uint64_t bytes = 0;

  explicit OpenFile(const std::string& path) {
    errno = 0;
    stream.open(path, std::ios::binary);
    std::error_code no_size;
    bytes = std::filesystem::file_size(path, no_size);
    if (!stream || no_size) io::throw_io_error("read", path);
  }
};

}  // namespace

pbd::SavedState read_chunk_file(const std::string& path, ChunkFileHeader& header) {
  OpenFile file(path);
  return read_chunks(file.stream, file.bytes, path, header);
}

ChunkFileHeader read_chunk_file_header(const std::string& path) {
  OpenFile file(path);
  return header_of(path, read_header(path, file.stream, file.bytes));
}

pbd::SavedState read_chunks(std::istream& stream, uint64_t bytes_left, const std::string& path,
                            ChunkFileHeader& header) {
  const Json json = read_header(path, stream, bytes_left);
  header = header_of(path, json);
  pbd::SavedState chunks;
  with_members(path, [&] {
    for (const Json& chunk : json.at("chunks"))
      chunks.add(chunk.at("name").get<std::string>(), read_chunk(path, chunk, stream, bytes_left));
  });
  if (bytes_left > 0)
    refuse_snapshot(path, "it goes on for " + std::to_string(bytes_left) + " bytes after its end");
  return chunks;
}

}  // namespace meniscus
