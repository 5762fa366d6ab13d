// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Writes CSV files row by row.
#include "sdk/cli/record/csv_file.h"

#include <cerrno>

#include "sdk/files/output_file.h"
#include "sdk/io/plain_text.h"

namespace meniscus::cli {

CsvFile::CsvFile(std::filesystem::path path, const std::string& header)
    : path_(std::move(path)), stream_(io::open_afresh(path_)) {
  write(header);
}

void CsvFile::write(const std::string& rows) {
  errno = 0;
  stream_ << rows << '\n' << std::flush;
  if (!stream_) io::throw_io_error("write", path_);
}

std::string csv_field(const std::string& text) {
  std::string field = io::plain_text(text);
  // Spreadsheets take what begins like this for a formula, and an apostrophe for the mark of a text.
  if (field.find_first_of("=+-@") == 0) field.insert(0, 1, '\'');
  if (field.find_first_of(",\"") == std::string::npos) return field;
  std::string quoted = "\"";
  for (const char c : field) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

}  // namespace meniscus::cli
