// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The input is a recording. It is replayed as it is, and then with the hashes of its header and records put
// right, so that changed calls are read as well. Four steps are repeated. Only Error may be thrown.
#include <meniscus/meniscus.h>

#include <cstring>
#include <vector>

#include "tests/fuzz/bytes.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace meniscus::fuzz {
namespace {

void replay(std::span<const std::uint8_t> bytes) {
  const MemoryFile file(bytes);
  try {
    Replay replay(file.path());
    World world = replay.start({.device = DeviceChoice::cpu, .threads = 1});
    for (int k = 0; k < 4 && replay.next(world); ++k) {
    }
  } catch (const Error&) {
  }
}

/// Puts the hash at `hash_at` right. It is that of the bytes that follow it, as many as the number at
/// `length_at` says. Returns where they end, or the file's end if it comes before.
template <class Length>
std::size_t repair(std::vector<std::uint8_t>& file, std::size_t length_at, std::size_t hash_at) {
  const std::size_t begin = hash_at + sizeof(std::uint64_t);
  if (file.size() < begin) return file.size();
  Length length = 0;
  std::memcpy(&length, file.data() + length_at, sizeof length);
  if (length > file.size() - begin) return file.size();
  const std::uint64_t hash = XXH3_64bits(file.data() + begin, length);
  std::memcpy(file.data() + hash_at, &hash, sizeof hash);
  return begin + length;
}

std::vector<std::uint8_t> with_true_hashes(std::span<const std::uint8_t> bytes) {
  std::vector<std::uint8_t> file(bytes.begin(), bytes.end());
  std::size_t at = repair<std::uint32_t>(file, 12, 16);
  while (at < file.size()) at = repair<std::uint64_t>(file, at + 8, at + 16);
  return file;
}

}  // namespace
}  // namespace meniscus::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace meniscus::fuzz;
  replay({data, size});
  replay(with_true_hashes({data, size}));
  return 0;
}
