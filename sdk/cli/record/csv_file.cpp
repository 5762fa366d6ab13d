// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Writes CSV files row by row.
#include "sdk/cli/record/csv_file.h"

#include <cerrno>

#include "sdk/io/output_file.h"

namespace meniscus::cli {

CsvFile::CsvFile(std::filesystem::path path, const std::string& header) : path_(std::move(path)) {
  errno = 0;
  stream_.open(path_, std::ios::trunc);
  if (!stream_) io::throw_io_error("write", path_);
  write(header);
}

void CsvFile::write(const std::string& rows) {
  errno = 0;
  stream_ << rows << '\n' << std::flush;
  if (!stream_) io::throw_io_error("write", path_);
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

}  // namespace meniscus::cli
