// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The input is a snapshot file. It is loaded as it is, and then with the hash of its header put right, so
// that changed definitions, names and counts are read as well. What loads makes two steps. Only Error may be
// thrown.
#include <meniscus/meniscus.h>

#include <cstring>
#include <vector>

#include "tests/fuzz/bytes.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace meniscus::fuzz {
namespace {

void load(std::span<const std::uint8_t> bytes) {
  const MemoryFile file(bytes);
  World world = World::load(file.path(), {.device = DeviceChoice::cpu, .threads = 1});
  for (int k = 0; k < 2; ++k) world.step(0.01f);
}

/// Empty where the file has no whole header.
std::vector<std::uint8_t> with_true_hash(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t length_at = 12, hash_at = 16, header_at = 24;
  std::uint32_t length = 0;
  if (bytes.size() < header_at) return {};
  std::memcpy(&length, bytes.data() + length_at, sizeof length);
  if (length > bytes.size() - header_at) return {};
  std::vector<std::uint8_t> repaired(bytes.begin(), bytes.end());
  const std::uint64_t hash = XXH3_64bits(repaired.data() + header_at, length);
  std::memcpy(repaired.data() + hash_at, &hash, sizeof hash);
  return repaired;
}

template <class Call>
void only_errors(const Call& call) {
  try {
    call();
  } catch (const Error&) {
  }
}

}  // namespace
}  // namespace meniscus::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace meniscus::fuzz;
  only_errors([&] { load({data, size}); });
  only_errors([&] { load(with_true_hash({data, size})); });
  return 0;
}
