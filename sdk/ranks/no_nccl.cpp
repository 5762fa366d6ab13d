// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Stands in for NCCL where it was not there at build time.
#include <meniscus/error.h>

#include <string>

#include "sdk/ranks/nccl_messages.h"

namespace meniscus {

std::unique_ptr<NcclMessages> join_nccl(pbd::Ranks&, int) {
  throw Error(ErrorCode::device,
              std::string("GPUs that share a world need NCCL, and this program has none: ") +
                  MENISCUS_NO_NCCL_REASON);
}

}  // namespace meniscus
