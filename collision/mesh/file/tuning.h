// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The bounds of mesh files: symbol or name, unit, why this value, and the test that notices.
#pragma once

#include <cstdint>

namespace meniscus::collision::mesh_file_tuning {

/// Bytes: a mesh file, with all files that it refers to, is no larger. Below it, numbers of corners fit 32
/// bits. Test: MeshFileBounds.AFileThatIsTooLargeIsNotRead.
inline constexpr uint64_t most_file_bytes = uint64_t{1} << 31;

/// How often assimp may read each byte, and how many bytes or calls on top of that. Its readers need about
/// three. Test: MeshFileBounds.AReaderThatCirclesIsStopped.
inline constexpr uint64_t most_reads_of_a_byte = 16, most_reads = uint64_t{1} << 20;

/// Objects, groups and changes of material of an OBJ file. assimp compares each with all before it: 1.1 s at
/// this number. Test: MeshFileBounds.AnObjFileOfManyPartsIsRefused.
inline constexpr uint64_t most_parts = 16384;

/// Corners of a polygon. assimp's triangulation takes their square: 0.2 s at this number.
/// Test: MeshFileBounds.APolygonOfManyCornersIsRefused.
inline constexpr uint32_t most_corners = 4096;

/// Elements within elements. assimp's readers call themselves for each; a million overran the stack.
/// Test: MeshFileBounds.DeepNestingIsRefused.
inline constexpr int most_levels = 256;

}  // namespace meniscus::collision::mesh_file_tuning
