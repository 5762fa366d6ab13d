// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace meniscus::cli {

/// A table whose rows are on disk as soon as they are written.
class CsvFile {
 public:
  /// Throws Error(io).
  CsvFile(std::filesystem::path path, const std::string& header);

  /// One row or more, with line breaks between them but not at the end. Throws Error(io).
  void write(const std::string& rows);

 private:
  std::filesystem::path path_;
  std::ofstream stream_;
};

/// As RFC 4180 has it: in quotes where a comma, a quote or a line break would be misread.
std::string csv_field(const std::string& text);

}  // namespace meniscus::cli
