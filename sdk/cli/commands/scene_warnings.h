// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sdk/scene/scene.h"

namespace meniscus::cli {

/// Warns of what a scene hardly means: a volume without particles, or nothing that could move.
void warn_of_oddities(const BuiltScene& built);

}  // namespace meniscus::cli
