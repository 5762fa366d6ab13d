// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Input fields for the values of a JSON document, made from its schema.
#pragma once

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace meniscus::viewer {

/// Input fields of one frame for the values of a JSON document, made from its schema. A value that the
/// document leaves out shows its default. It enters the document when it is changed.
class ParameterFields {
 public:
  using Json = nlohmann::json;
  using Schema = nlohmann::ordered_json;

  /// `at_once` returns for a path whether its value takes effect without a reset. Other values are marked.
  explicit ParameterFields(std::function<bool(const std::string&)> at_once) : at_once_(std::move(at_once)) {}

  /// Draws an object; `path` is its path, empty for the document itself.
  void draw_object(const Schema& schema, Json& object, const std::string& path);
  /// Changes in this frame, by path.
  const std::map<std::string, Json>& changes() const { return changes_; }

 private:
  void draw_property(const std::string& key, const Schema& schema, Json& parent, const std::string& path);
  void draw_list(const std::string& key, const Schema& schema, Json& list, const std::string& path);
  void draw_value(const std::string& key, const Schema& schema, Json& parent, const std::string& path);
  bool edit(const Schema& schema, Json& value) const;

  std::function<bool(const std::string&)> at_once_;
  std::map<std::string, Json> changes_;
};

}  // namespace meniscus::viewer
