// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Builds a page of Markdown, and writes it with its files.
#include "sdk/io/report.h"

#include <meniscus/error.h>

#include <algorithm>

#include "sdk/files/output_file.h"

namespace meniscus::io {
namespace {

/// Begins a link to the folder. It contains a control character, which no text has.
constexpr std::string_view folder_mark = "](\x01/";

}  // namespace

std::string table_row(const Report::Cells& cells) {
  std::string row = "|";
  for (std::string cell : cells) {
    std::replace(cell.begin(), cell.end(), '\n', ' ');
    std::replace(cell.begin(), cell.end(), '|', '/');
    row += " " + cell + " |";
  }
  return row + "\n";
}

std::string table_head(const Report::Cells& columns) {
  std::string rule = "|";
  for (std::size_t i = 0; i < columns.size(); ++i) rule += "---|";
  return table_row(columns) + rule + "\n";
}

void Report::table(const Cells& columns, const std::vector<Cells>& rows) {
  if (rows.empty()) return paragraph("Nothing was measured.");
  body_ += table_head(columns);
  for (const Cells& row : rows) body_ += table_row(row);
  body_ += "\n";
}

void Report::chart(const std::string& name, const LineChart& chart) {
  charts_[name + ".svg"] = to_svg(chart);
  link(chart.title, name + ".svg");
}

void Report::picture(const std::string& name, const std::string& caption, Image image) {
  pictures_[name + ".png"] = std::move(image);
  link(caption, name + ".png");
}

void Report::link(const std::string& caption, const std::string& file) {
  body_ += "![" + caption + std::string(folder_mark) + file + ")\n\n";
}

std::string Report::text(const std::string& folder) const {
  std::string text = body_;
  const std::string link = "](" + folder + "/";
  for (std::size_t at = 0; (at = text.find(folder_mark, at)) != std::string::npos; at += link.size())
    text.replace(at, folder_mark.size(), link);
  while (text.ends_with("\n\n")) text.pop_back();
  return text;
}

void Report::write(const std::filesystem::path& page) const {
  const std::filesystem::path folder = page.parent_path() / page.stem();
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed)
    throw Error(ErrorCode::io, "cannot make the folder " + folder.string() + ": " + failed.message());
  for (const auto& [name, svg] : charts_) write_text(folder / name, svg);
  for (const auto& [name, image] : pictures_) write_png(folder / name, image);
  write_text(folder / "figures.json", figures.dump(1) + "\n");
  write_text(page, text(page.stem().string()));
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace meniscus::io
