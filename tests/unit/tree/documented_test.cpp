// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Each type and function of the public headers, for C++ and for C, has a comment of its documentation.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// The lines of a file, between two empty ones.
std::vector<std::string> lines_of(const fs::path& file) {
  std::vector<std::string> lines{""};
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  lines.emplace_back();
  return lines;
}

/// Whether a line begins the declaration of a type, an alias or a function. Members are deeper than members
/// of a class, or have no parenthesis; forward declarations are none.
bool declares(const std::string& line) {
  static const std::regex type(R"((struct|class|enum class|typedef struct|typedef enum) \w+.*\{.*)");
  static const std::regex alias(R"(using \w+ =.*)");
  static const std::regex handle(R"(typedef struct (\w+) \1;)");
  static const std::regex function(
      R"( {0,2}(?!return|throw|friend|static_assert|using)[A-Za-z_][\w:<>,&* ]* [&*]?\w+\(.*)");
  return std::regex_match(line, type) || std::regex_match(line, alias) || std::regex_match(line, handle) ||
         std::regex_match(line, function);
}

bool is_whole(const std::string& line) {
  return line.find_first_of(";{") != std::string::npos;
}

/// Whether the declaration in a line has a comment, before it or at its end.
bool is_documented(const std::vector<std::string>& lines, std::size_t i) {
  std::size_t before = i - 1;
  if (std::regex_match(lines[before], std::regex(" *template <.*"))) --before;
  if (lines[before].find("///") != std::string::npos && lines[before].find("///<") == std::string::npos)
    return true;
  std::size_t end = i;
  while (!is_whole(lines[end]) && end + 1 < lines.size()) ++end;
  return lines[end].find("///<") != std::string::npos;
}

/// The part of a class behind `private:` is not public.
std::vector<std::string> undocumented(const fs::path& file) {
  std::vector<std::string> found;
  const std::vector<std::string> lines = lines_of(file);
  bool is_private = false;
  for (std::size_t i = 1; i + 1 < lines.size(); ++i) {
    if (lines[i] == " private:") is_private = true;
    if (lines[i] == "};") is_private = false;
    if (!is_private && declares(lines[i]) && !is_documented(lines, i))
      found.push_back(file.filename().string() + ":" + std::to_string(i) + ": " + lines[i]);
  }
  return found;
}

TEST(PublicHeaders, DocumentEachSymbol) {
  std::size_t declarations = 0;
  for (const auto& entry :
       fs::recursive_directory_iterator(fs::path(MENISCUS_SOURCE_DIR) / "sdk/include/meniscus")) {
    if (entry.path().extension() != ".h") continue;
    for (const std::string& line : lines_of(entry.path())) declarations += declares(line);
    for (const std::string& line : undocumented(entry.path())) ADD_FAILURE() << line;
  }
  EXPECT_GT(declarations, 300u) << "the test does not see what it tests";
}

}  // namespace
