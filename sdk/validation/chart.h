// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Draws the plots of a case.
#pragma once

#include <string>
#include <vector>

#include "sdk/validation/case.h"

namespace meniscus::validation {

/// One SVG document. A plot's curves may have different x.
std::string drawing_of(const Plot& plot);

}  // namespace meniscus::validation
