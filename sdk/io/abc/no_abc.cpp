// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Stands for the writer of Alembic files where Alembic was not found.
#include <meniscus/error.h>

#include "sdk/io/abc/abc_recording.h"

namespace meniscus::io {

struct AbcRecording::Archive {};

void require_abc() {
  throw Error(ErrorCode::invalid_argument, "Alembic files cannot be written: " MENISCUS_NO_ALEMBIC_REASON);
}

AbcRecording::AbcRecording(const std::filesystem::path&, const Scene&, const ExportContents&,
                           const BodySurfaces*, const SceneFrame&) {
  require_abc();
}
AbcRecording::~AbcRecording() = default;
void AbcRecording::add(const SceneFrame&) {}
void AbcRecording::finish() {}

}  // namespace meniscus::io
