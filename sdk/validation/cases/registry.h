// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The list of all cases.
#pragma once

#include <string>
#include <vector>

#include "sdk/validation/case.h"

namespace meniscus::validation {

/// In the order of the page.
const std::vector<Case>& all_cases();

/// What there is no case for yet, and why: one sentence each.
const std::vector<std::string>& missing_cases();

/// Those with these names, in the order of the page; all of them if there are no names. Throws
/// Error(invalid_argument) for a name that is not known, with the nearest one.
std::vector<Case> chosen_cases(const std::vector<std::string>& names);

}  // namespace meniscus::validation
