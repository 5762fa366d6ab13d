// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Numbers that tell living worlds apart.
#pragma once

#include <cstdint>

namespace meniscus {

/// The generations of one place in a table of one world. Those of a world begin with its number.
inline constexpr uint32_t generations_of_a_world = uint32_t{1} << 16;

/// A number that no other living world of this process has, however many were made. It is never 0.
class WorldNumber {
 public:
  /// Throws Error(capacity) if 65,535 worlds are alive.
  WorldNumber();
  ~WorldNumber();
  WorldNumber(const WorldNumber&) = delete;
  WorldNumber& operator=(const WorldNumber&) = delete;

  /// The first of the generations that are this world's alone.
  uint32_t first_generation() const { return number_ * generations_of_a_world; }

 private:
  uint32_t number_;
};

}  // namespace meniscus
