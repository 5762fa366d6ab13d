// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Writes the container of snapshots. The header stands before the chunks, whose hashes it has. So its place
// is left free, and it is written last.
#include <meniscus/error.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <vector>

#include "pbd/device/device.h"
#include "sdk/files/output_file.h"
#include "sdk/world/state/chunk_file.h"
#include "sdk/world/state/chunk_format.h"

namespace meniscus {

using namespace chunk_format;

namespace {

/// A chunk as the header has it.
struct Chunk {
  std::string name, form;
  uint32_t element_bytes;
  std::size_t count;
  uint64_t hash;
};

/// Lists all chunks.
class ChunkList final : public pbd::StateVisitor {
 public:
  bool restores() const override { return false; }

  std::vector<Chunk> chunks;

 private:
  void visit_host(const std::string& path, const pbd::ElementForm& form, void*, std::size_t count) override {
    // The longest number, so that the header becomes no longer.
    chunks.push_back({path, form.word, form.bytes, count, std::numeric_limits<uint64_t>::max()});
  }
  void visit_device(const std::string& path, const pbd::ElementForm& form, void* data, std::size_t,
                    std::size_t count) override {
    visit_host(path, form, data, count);
  }
  std::size_t count_of(const std::string&) override { return 0; }
  bool has(const std::string&) const override { return false; }
};

/// Writes the contents of chunks that are listed, and notes their hashes. A piece is hashed and written while
/// it is in the processor's cache.
class ChunkWriter final : public pbd::StateVisitor {
 public:
  ChunkWriter(pbd::Device& device, io::OutputFile& file, std::vector<Chunk>& chunks)
      : device_(device), file_(file), chunks_(chunks), piece_(piece_bytes) {}
  bool restores() const override { return false; }

 private:
  static constexpr std::size_t piece_bytes = std::size_t{1} << 18;

  void visit_host(const std::string& path, const pbd::ElementForm& form, void* data,
                  std::size_t count) override {
    write(path, form.bytes * count,
          [&](std::size_t at, std::size_t) { return static_cast<const std::byte*>(data) + at; });
  }
  void visit_device(const std::string& path, const pbd::ElementForm& form, void* data, std::size_t,
                    std::size_t count) override {
    if (device_.kind() == pbd::DeviceKind::cpu) return visit_host(path, form, data, count);
    write(path, form.bytes * count, [&](std::size_t at, std::size_t bytes) {
      device_.copy_out(piece_.data(), static_cast<const std::byte*>(data) + at, bytes);
      return piece_.data();
    });
  }
  std::size_t count_of(const std::string&) override { return 0; }
  bool has(const std::string&) const override { return false; }

  template <class Fetch>
  void write(const std::string& path, std::size_t bytes, const Fetch& fetch) {
    if (next_ == chunks_.size() || chunks_[next_].name != path ||
        bytes != chunks_[next_].count * chunks_[next_].element_bytes)
      throw std::logic_error("the chunk " + path + " differs between two visits");
    XXH3_state_t hash;
    XXH3_64bits_reset(&hash);
    for (std::size_t at = 0; at < bytes; at += piece_bytes) {
      const std::size_t size = std::min(piece_bytes, bytes - at);
      const std::span<const std::byte> piece(fetch(at, size), size);
      XXH3_64bits_update(&hash, piece.data(), size);
      file_.write(piece);
    }
    chunks_[next_++].hash = XXH3_64bits_digest(&hash);
  }

  pbd::Device& device_;
  io::OutputFile& file_;
  std::vector<Chunk>& chunks_;
  std::vector<std::byte> piece_;
  std::size_t next_ = 0;
};

std::string header_text(const ChunkFileHeader& header, const std::vector<Chunk>& chunks) {
  Json json{{"program", header.program},
            {"device", header.device},
            {"time", header.time},
            {"definitions", header.definitions},
            {"chunks", Json::array()}};
  for (const Chunk& chunk : chunks) {
    json["chunks"].push_back({{"name", chunk.name},
                              {"form", chunk.form},
                              {"element_bytes", chunk.element_bytes},
                              {"count", chunk.count},
                              {"version", chunk_version},
                              {"required", true},
                              {"xxh3", chunk.hash}});
  }
  return json.dump();
}

void write_header(io::OutputFile& file, const std::string& text) {
  Prefix prefix{{}, format_version, header_length(text.size()), XXH3_64bits(text.data(), text.size())};
  std::memcpy(prefix.magic, magic, sizeof magic);
  file.write(std::span<const Prefix>(&prefix, 1));
  file.write(text);
}

}  // namespace

void write_chunk_file(const std::string& path, const ChunkFileHeader& header, pbd::Device& device,
                      const std::function<void(pbd::StateVisitor&)>& visit) {
  ChunkList list;
  visit(list);
  const std::size_t room = header_text(header, list.chunks).size();
  header_length(room);  // before anything is written
  io::OutputFile file(path);
  write_header(file, std::string(room, ' '));
  ChunkWriter writer(device, file, list.chunks);
  visit(writer);
  std::string text = header_text(header, list.chunks);
  text.resize(room, ' ');
  file.back_to_start();
  write_header(file, text);
  file.commit();
}

}  // namespace meniscus
