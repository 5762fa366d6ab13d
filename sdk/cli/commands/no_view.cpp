// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// In place of view.cpp where the window is not built.
#include <meniscus/error.h>

#include "sdk/cli/commands/view.h"

namespace meniscus::cli {

int view_scene(const ViewOptions&) {
  throw Error(ErrorCode::device,
              "cannot open a window: this program was built without it, as " MENISCUS_NO_VIEWER_REASON);
}

}  // namespace meniscus::cli
