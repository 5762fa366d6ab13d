// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The graph of the times that the last steps took.
#pragma once

#include "sdk/viewer/stage_history.h"

namespace meniscus::viewer {

/// Draws a bar for each of the last steps, with its stages stacked, and a legend with their means.
void draw_stage_graph(const StageHistory& history);

}  // namespace meniscus::viewer
