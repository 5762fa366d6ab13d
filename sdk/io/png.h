// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Images in memory, and PNG files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace meniscus::io {

/// Eight bits a channel, sRGB, rows from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<uint8_t> rgb;  ///< 3 · width · height
};

/// Throws Error(io).
void write_png(const std::filesystem::path& path, const Image& image);

}  // namespace meniscus::io
