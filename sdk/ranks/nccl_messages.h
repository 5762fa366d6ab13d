// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Messages between the GPUs of ranks, over NCCL.
#pragma once

#include <memory>
#include <span>

#include "pbd/ranks/ranks.h"

namespace meniscus {

class NcclMessages {
 public:
  virtual ~NcclMessages() = default;

  /// See pbd::Ranks::exchange_on_gpu. Throws Error(lost) if NCCL fails.
  virtual void exchange(std::span<const pbd::Sent> sent, std::span<const pbd::Received> received,
                        void* stream) = 0;
};

/// Joins the GPUs of all ranks, which call it together. `ordinal`: of this rank's GPU. Throws Error(device)
/// on all ranks if two have the same GPU, if NCCL fails, or if this build has no NCCL.
std::unique_ptr<NcclMessages> join_nccl(pbd::Ranks& ranks, int ordinal);

}  // namespace meniscus
