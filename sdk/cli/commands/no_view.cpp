// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Replaces view.cpp in builds without the window.
#include <meniscus/error.h>

#include "sdk/cli/commands/view.h"

namespace meniscus::cli {

int view_scene(const ViewOptions&) {
  throw Error(ErrorCode::device,
              "cannot open a window: this program was built without it, as " MENISCUS_NO_VIEWER_REASON);
}

}  // namespace meniscus::cli
