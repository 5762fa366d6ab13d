// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sdk/viewer/stage_history.h"

namespace meniscus::viewer {

/// A bar for each of the last steps, of its stages one on top of the other, and a legend with their means.
void draw_stage_graph(const StageHistory& history);

}  // namespace meniscus::viewer
