// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds the name that a mistyped one is closest to.
#pragma once

#include <string>
#include <vector>

namespace meniscus {

/// The advice for a name that is not known: `did you mean "rest_density"?`. If none of the known names is
/// near, it is `allowed: …` with all of them.
std::string name_hint(const std::string& unknown, const std::vector<std::string>& known);

}  // namespace meniscus
