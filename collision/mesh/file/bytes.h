// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads whole files, up to a bound.
#pragma once

#include <cstdint>
#include <string>

namespace meniscus::collision {

/// All bytes of a regular file. `left` is what may still be read for one mesh, in bytes, and is reduced.
/// Never waits for a pipe or a device. Throws Error(io) if there is no such file or it cannot be read, and
/// FileDefect if it is larger than `left`.
std::string read_bytes(const std::string& path, uint64_t& left);

}  // namespace meniscus::collision
