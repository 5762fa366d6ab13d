// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The command `meniscus samples`.
#pragma once

namespace meniscus::cli {

/// Prints the names of the samples, one a line; or, as JSON, their files and descriptions too. Throws
/// Error(io) and Error(parse) if one of them cannot be read for its description.
int list_samples(bool json);

}  // namespace meniscus::cli
