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

/// A part of a chunk, which a rank has written.
struct Part {
  std::size_t count;
  uint64_t hash;
};

/// A chunk as the header has it.
struct Chunk {
  std::string name, form;
  uint32_t element_bytes;
  std::size_t count;
  uint64_t hash;
  std::vector<Part> parts{};  ///< none: it is written in one piece

  std::size_t bytes() const { return count * element_bytes; }
};

/// The longest number, so that the header becomes no longer.
constexpr uint64_t any_hash = std::numeric_limits<uint64_t>::max();

/// Lists all chunks.
class ChunkList final : public pbd::StateVisitor {
 public:
  explicit ChunkList(const SharedChunks* shared) : shared_(shared) {}
  bool restores() const override { return false; }

  std::vector<Chunk> chunks;

 private:
  void visit_host(const std::string& path, const pbd::ElementForm& form, void*, std::size_t count) override {
    chunks.push_back({path, form.word, form.bytes, count, any_hash});
  }
  void visit_device(const std::string& path, const pbd::ElementForm& form, void* data, std::size_t,
                    std::size_t count) override {
    visit_host(path, form, data, count);
    if (!shared_ || !shared_->is_shared(path)) return;
    Chunk& chunk = chunks.back();
    chunk.count = 0;
    for (const uint32_t of_rank : shared_->counts) {
      chunk.parts.push_back({of_rank, any_hash});
      chunk.count += of_rank;
    }
  }
  std::size_t count_of(const std::string&) override { return 0; }
  bool has(const std::string&) const override { return false; }

  const SharedChunks* shared_;
};

/// Writes the contents of chunks that are listed, and notes their hashes. A piece is hashed and written while
/// it is in the processor's cache.
class ChunkWriter final : public pbd::StateVisitor {
 public:
  ChunkWriter(pbd::Device& device, io::OutputFile& file, std::vector<Chunk>& chunks,
              const SharedChunks* shared)
      : device_(device), file_(file), chunks_(chunks), shared_(shared), piece_(piece_bytes) {}
  bool restores() const override { return false; }

 private:
  static constexpr std::size_t piece_bytes = std::size_t{1} << 18;

  void visit_host(const std::string& path, const pbd::ElementForm& form, void* data,
                  std::size_t count) override {
    uint32_t in_world = 0;
    if (shared_ && shared_->is_count(path)) {
      for (const uint32_t of_rank : shared_->counts) in_world += of_rank;
      data = &in_world;
    }
    write(path, form.bytes * count,
          [&](std::size_t at, std::size_t) { return static_cast<const std::byte*>(data) + at; });
  }
  void visit_device(const std::string& path, const pbd::ElementForm& form, void* data, std::size_t,
                    std::size_t count) override {
    if (shared_ && shared_->is_shared(path)) return file_.skip(chunks_[next_++].bytes());
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
  const SharedChunks* shared_;
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
    const bool is_parted = !chunk.parts.empty();
    Json entry{{"name", chunk.name},
               {"form", chunk.form},
               {"element_bytes", chunk.element_bytes},
               {"count", chunk.count},
               {"version", is_parted ? parted_version : chunk_version},
               {"required", true}};
    if (!is_parted) entry["xxh3"] = chunk.hash;
    for (const Part& part : chunk.parts)
      entry["parts"].push_back({{"count", part.count}, {"xxh3", part.hash}});
    json["chunks"].push_back(std::move(entry));
  }
  return json.dump();
}

void write_header(io::OutputFile& file, const std::string& text) {
  Prefix prefix{{}, format_version, header_length(text.size()), XXH3_64bits(text.data(), text.size())};
  std::memcpy(prefix.magic, magic, sizeof magic);
  file.write(std::span<const Prefix>(&prefix, 1));
  file.write(text);
}

/// Lets all ranks write their parts, and notes the hashes. The first chunk begins at `start`.
void write_parts(const SharedChunks& shared, const io::OutputFile& file, uint64_t start,
                 std::vector<Chunk>& chunks) {
  std::vector<uint64_t> offsets;
  std::vector<Part*> parts;
  for (Chunk& chunk : chunks) {
    if (!chunk.parts.empty()) offsets.push_back(start);
    for (Part& part : chunk.parts) parts.push_back(&part);
    start += chunk.bytes();
  }
  const std::vector<uint64_t> hashes = shared.write(file.part().string(), offsets);
  for (std::size_t k = 0; k < parts.size(); ++k) parts[k]->hash = hashes.at(k);
}

}  // namespace

void write_chunk_file(const std::string& path, const ChunkFileHeader& header, pbd::Device& device,
                      const std::function<void(pbd::StateVisitor&)>& visit, const SharedChunks* shared) {
  ChunkList list(shared);
  visit(list);
  const std::size_t room = header_text(header, list.chunks).size();
  header_length(room);  // before anything is written
  io::OutputFile file(path);
  if (shared) write_parts(*shared, file, sizeof(Prefix) + room, list.chunks);
  write_header(file, std::string(room, ' '));
  ChunkWriter writer(device, file, list.chunks, shared);
  visit(writer);
  std::string text = header_text(header, list.chunks);
  text.resize(room, ' ');
  file.back_to_start();
  write_header(file, text);
  file.commit();
}

}  // namespace meniscus
