// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Checks that the names in a scene are unique and exist.
#pragma once

#include <string>

#include <meniscus/scene.h>

namespace meniscus {

/// Throws Error(parse) where two things of a kind share a name, or where a name refers to nothing.
void check_names(const Scene& scene, const std::string& source);

}  // namespace meniscus
