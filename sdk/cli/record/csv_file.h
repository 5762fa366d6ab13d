// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// CSV files that are written row by row.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace meniscus::cli {

/// A table whose rows reach the disk as soon as they are written.
class CsvFile {
 public:
  /// Throws Error(io).
  CsvFile(std::filesystem::path path, const std::string& header);

  /// Writes one row or more, with line breaks between them but not at the end. Throws Error(io).
  void write(const std::string& rows);

 private:
  std::filesystem::path path_;
  std::ofstream stream_;
};

/// A field of plain text after RFC 4180: in quotes if a comma or a quote would be misread. An apostrophe
/// stands before what a spreadsheet would take for a formula.
std::string csv_field(const std::string& text);

}  // namespace meniscus::cli
