// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A page of Markdown with charts, pictures and figures in a folder beside it.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sdk/io/line_chart.h"
#include "sdk/io/png.h"

namespace meniscus::io {

/// Text, tables, charts and pictures in the order of the calls. Nothing is written before write().
class Report {
 public:
  using Cells = std::vector<std::string>;

  explicit Report(std::string title) : body_("# " + title + "\n\n") {}

  void heading(const std::string& text) { body_ += "## " + text + "\n\n"; }
  void paragraph(const std::string& text) { body_ += text + "\n\n"; }
  /// Without rows it says that nothing was measured.
  void table(const Cells& columns, const std::vector<Cells>& rows);
  /// `name`: of the file, without its extension.
  void chart(const std::string& name, const LineChart& chart);
  void picture(const std::string& name, const std::string& caption, Image image);

  /// What figures.json contains.
  nlohmann::ordered_json figures = nlohmann::ordered_json::object();

  /// The page with links to files in `folder`.
  std::string text(const std::string& folder) const;
  /// Writes the page, and the other files into the folder beside it that has its name. Throws Error(io).
  void write(const std::filesystem::path& page) const;

 private:
  void link(const std::string& caption, const std::string& file);

  std::string body_;  // a mark stands for the folder of links until that is known
  std::map<std::string, std::string> charts_;
  std::map<std::string, Image> pictures_;
};

/// A line of a table in Markdown.
std::string table_row(const Report::Cells& cells);
/// The lines above the rows of a table.
std::string table_head(const Report::Cells& columns);

/// Writes a whole file, or leaves the old one. Throws Error(io).
void write_text(const std::filesystem::path& path, const std::string& text);

}  // namespace meniscus::io
