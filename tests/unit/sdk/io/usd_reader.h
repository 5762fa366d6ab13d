// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A small reader of USD text, independent of the writer: the numbers of attributes, by time code.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace meniscus::io {

/// All numbers of a value, in their order, without brackets.
inline std::vector<double> usd_numbers(const std::string& text) {
  std::vector<double> numbers;
  for (const char* at = text.c_str(); *at;) {
    char* end = nullptr;
    const bool starts = *at == '-' || (*at >= '0' && *at <= '9');
    const double value = starts ? std::strtod(at, &end) : 0;
    if (starts) numbers.push_back(value);
    at = starts ? end : at + 1;
  }
  return numbers;
}

/// The attributes of a layer by "/prim/child.attribute".
class UsdFile {
 public:
  explicit UsdFile(const std::filesystem::path& path) {
    std::ifstream stream(path);
    std::string line, next;
    bool in_metadata = false;
    while (std::getline(stream, line)) {
      line.erase(0, line.find_first_not_of(' '));
      if (in_metadata) {
        metadata_ += line + '\n';
        in_metadata = line != ")";
      } else if (line.starts_with("def ") || line.starts_with("over ")) {
        const std::size_t quote = line.find('"');
        next = line.substr(quote + 1, line.find('"', quote + 1) - quote - 1);
        in_metadata = line.ends_with('(');
      } else if (line == "{") {
        path_.push_back(next);
      } else if (line == "}") {
        path_.pop_back();
      } else if (line == "(") {
        in_metadata = true;
      } else {
        read_attribute(line);
      }
    }
    closed_ = path_.empty() && !in_metadata;
  }

  bool closed() const { return closed_; }  ///< whether each bracket is closed
  const std::string& metadata() const { return metadata_; }
  bool has(const std::string& attribute) const { return texts_.contains(attribute); }
  /// The text of a value that holds for all times.
  std::string text(const std::string& attribute) const {
    const auto found = texts_.find(attribute);
    return found == texts_.end() ? "" : found->second;
  }
  std::vector<double> numbers(const std::string& attribute) const { return usd_numbers(text(attribute)); }
  std::map<int, std::vector<double>> samples(const std::string& attribute) const {
    std::map<int, std::vector<double>> samples;
    std::string text = this->text(attribute + ".timeSamples");
    for (std::size_t at = 0; (at = text.find(':', at)) != std::string::npos; ++at) {
      const std::size_t before = text.find_last_of(" {", at) + 1, next = text.find(':', at + 1);
      const std::size_t end = next == std::string::npos ? text.size() : text.find_last_of(' ', next) + 1;
      samples[std::stoi(text.substr(before, at - before))] = usd_numbers(text.substr(at + 1, end - at - 1));
    }
    return samples;
  }

 private:
  void read_attribute(const std::string& line) {
    const std::size_t equals = line.find(" = ");
    const std::size_t name = line.rfind(' ', equals == std::string::npos ? equals : equals - 1) + 1;
    if (line.empty() || path_.empty()) return;
    std::string path;
    for (const std::string& prim : path_) path += '/' + prim;
    const bool has_value = equals != std::string::npos;
    texts_[path + '.' + line.substr(name, has_value ? equals - name : std::string::npos)] =
        has_value ? line.substr(equals + 3) : "";
  }

  std::vector<std::string> path_;
  std::map<std::string, std::string> texts_;
  std::string metadata_;
  bool closed_ = false;
};

}  // namespace meniscus::io
