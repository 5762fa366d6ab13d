// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Computes the hash of a mesh.
#include "collision/mesh/hash.h"

#include <bit>

namespace meniscus::collision {

namespace {

// FNV-1a (Fowler, Noll, Vo) and the mixing of splitmix64 (Steele et al. 2014), a 32-bit word at a time.
void add(MeshHash& hash, uint32_t word) {
  hash.first = (hash.first ^ word) * 0x100000001b3;
  uint64_t z = hash.second + 0x9e3779b97f4a7c15 + word;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
  z = (z ^ z >> 27) * 0x94d049bb133111eb;
  hash.second = z ^ z >> 31;
}

}  // namespace

MeshHash hash_of(const TriangleMesh& mesh) {
  MeshHash hash{mesh.vertices.size(), mesh.triangles.size(), 0xcbf29ce484222325, 0};
  for (Vec3 v : mesh.vertices) {
    for (float x : {v.x, v.y, v.z}) add(hash, std::bit_cast<uint32_t>(x));
  }
  for (const auto& t : mesh.triangles) {
    for (uint32_t v : t) add(hash, v);
  }
  return hash;
}

}  // namespace meniscus::collision
