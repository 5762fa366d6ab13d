// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Stands for the writer of OpenVDB files where OpenVDB was not found.
#include <meniscus/error.h>

#include "sdk/io/vdb.h"

namespace meniscus::io {

void require_vdb() {
  throw Error(ErrorCode::invalid_argument, "OpenVDB files cannot be written: " MENISCUS_NO_OPENVDB_REASON);
}

void write_vdb(const std::filesystem::path&, const LiquidFrame&, const ParticleFrame&, float) {
  require_vdb();
}

}  // namespace meniscus::io
