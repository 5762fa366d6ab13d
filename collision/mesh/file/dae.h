// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Checks Collada files before assimp reads them.
#pragma once

#include <string_view>

namespace meniscus::collision {

/// Throws FileDefect if a Collada file with these bytes has tags that do not match, a list of numbers with
/// something else in it or of another length than it says, or an accessor of more than its list has.
void check_dae(std::string_view bytes);

}  // namespace meniscus::collision
