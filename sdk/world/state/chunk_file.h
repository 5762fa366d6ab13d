// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The container of snapshots: a header that names the chunks, and the chunks.
#pragma once

#include <functional>
#include <istream>
#include <span>
#include <string>
#include <vector>

#include "pbd/state/saved_state.h"

namespace meniscus {

/// What a file says of itself, besides its chunks.
struct ChunkFileHeader {
  std::string program;      ///< the version that wrote it
  std::string device;       ///< "cpu" or "cuda"
  double time = 0;          ///< s, of the world
  std::string definitions;  ///< JSON
};

/// How the ranks of a shared world write their parts of the chunks with an element for each particle.
struct SharedChunks {
  std::vector<uint32_t> counts;  ///< particles, by rank
  std::function<bool(const std::string&chunk)> is_shared, is_count;
  /// Writes all parts of the chunks, which begin at these offsets of the file, those of rank 0 first. Returns
  /// their hashes, by chunk and then by rank.
  std::function<std::vector<uint64_t>(const std::string& file, std::span<const uint64_t> offsets)> write;
};

/// The format (docs/snapshots.md), of which there is one so far:
///
///   8 bytes   "MENISNAP"
///   u32       the format's version
///   u32       length of the header, bytes
///   u64       xxh3 of the header
///   header    JSON: program, device, time, definitions, and the chunks: name, form, element bytes, count,
///             version, whether it is required, and xxh3; or of version 2 its parts, each with count and xxh3
///   chunks    one after the other
///
/// Integers are little-endian. Spaces may follow the JSON. `visit` visits all chunks: once for their names
/// and sizes, and once for their contents, which go to the file piece by piece. Throws Error(io); PATH is
/// then as before. `shared`: of a shared world.
void write_chunk_file(const std::string& path, const ChunkFileHeader& header, pbd::Device& device,
                      const std::function<void(pbd::StateVisitor&)>& visit,
                      const SharedChunks* shared = nullptr);

/// All chunks, on the host. Throws Error(io) that names what is wrong, if a byte is not as it was written.
pbd::SavedState read_chunk_file(const std::string& path, ChunkFileHeader& header);
/// The header alone, whatever the chunks are. Throws Error(io).
ChunkFileHeader read_chunk_file_header(const std::string& path);
/// The same of a stream of so many bytes; `path` names it in errors.
pbd::SavedState read_chunks(std::istream& stream, uint64_t bytes, const std::string& path,
                            ChunkFileHeader& header);

}  // namespace meniscus
