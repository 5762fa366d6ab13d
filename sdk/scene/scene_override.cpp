// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds values of a scene document by their paths, and writes overrides of the form path=value.
#include "sdk/scene/scene_override.h"

#include <meniscus/error.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <variant>

#include "sdk/scene/scene_document.h"
#include "sdk/scene/scene_meshes.h"
#include "sdk/scene/scene_values.h"

namespace meniscus {
namespace {

using Json = nlohmann::json;

using Step = std::variant<std::string, std::size_t>;  ///< into an object by key, or into an array by index

/// `option`: as the user wrote it, such as --set path=value.
[[noreturn]] void fail(const std::string& option, const std::string& message) {
  throw Error(ErrorCode::invalid_argument, option + ": " + message);
}

/// Takes the index off the front of `rest`, which begins after the bracket; false if it is none.
bool take_index(std::string_view& rest, std::vector<Step>& steps) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), index);
  if (error != std::errc{} || end == rest.data() + rest.size() || *end != ']') return false;
  rest.remove_prefix(end - rest.data() + 1);
  steps.push_back(index);
  return true;
}

bool take_key(std::string_view& rest, std::vector<Step>& steps) {
  const std::size_t end = std::min(rest.find_first_of(".["), rest.size());
  if (end == 0) return false;
  steps.push_back(std::string(rest.substr(0, end)));
  rest.remove_prefix(end);
  return true;
}

/// `volumes[1].region` as its steps; empty if it does not read so.
std::vector<Step> split_path(std::string_view path) {
  std::vector<Step> steps;
  bool ok = take_key(path, steps);
  while (ok && !path.empty()) {
    const char mark = path.front();
    path.remove_prefix(1);
    ok = mark == '[' ? take_index(path, steps) : mark == '.' && take_key(path, steps);
  }
  return ok ? steps : std::vector<Step>();
}

Json parse_value(const std::string& option, const std::string& text, const Step& last) {
  const auto expect_flat = [&](int depth, Json::parse_event_t, const Json&) {
    if (depth > static_cast<int>(most_levels))
      fail(option, "is nested more than " + std::to_string(most_levels) + " levels deep");
    return true;
  };
  const Json value = Json::parse(text, expect_flat, false);
  if (!value.is_discarded() && !value.is_string()) return value;
  const std::string word = value.is_string() ? value.get<std::string>() : text;
  const bool is_file = last == Step("file") && !word.empty() && !is_mesh_alias(word);
  return is_file ? std::filesystem::absolute(word).string() : word;
}

/// Follows the steps through the document. `so_far` is the path as the user would write it, for messages.
struct Walk {
  const std::string& option;
  std::string so_far = "";

  Json& follow(Json& parent, const std::string& key) {
    if (!parent.is_object()) {
      fail(option, quoted() + " is " + shown(parent) + ", which has no key \"" + key + "\"");
    }
    so_far += (so_far.empty() ? "" : ".") + key;
    return parent[key];
  }

  Json& follow(Json& parent, std::size_t index) {
    if (!parent.is_array()) fail(option, quoted() + " is not an array, and has no items");
    if (index >= parent.size()) {
      fail(option, quoted() + " has " + std::to_string(parent.size()) + " items, counted from 0");
    }
    so_far.append("[").append(std::to_string(index)).append("]");
    return parent[index];
  }

  std::string quoted() const { return so_far.empty() ? "the scene" : "\"" + so_far + "\""; }
};

}  // namespace

Json& value_at(Json& document, std::string_view path, const std::string& option) {
  const auto steps = split_path(path);
  if (steps.empty() || steps.size() > most_levels)
    fail(option, "the path must read like fluids[0].dynamic_viscosity");
  Json* target = &document;
  Walk walk{option};
  for (const Step& step : steps) {
    const bool absent = target->is_null() && std::holds_alternative<std::string>(step);
    if (absent) *target = Json::object();
    target = &std::visit([&](const auto& way) -> Json& { return walk.follow(*target, way); }, step);
  }
  return *target;
}

void apply_override(Json& document, const std::string& override_text) {
  const std::string option = "--set " + override_text;
  const std::size_t equals = override_text.find('=');
  if (equals == std::string::npos) fail(option, "must read path=value, as in world.iterations=4");
  const std::string path = override_text.substr(0, equals);
  Json& target = value_at(document, path, option);
  target = parse_value(option, override_text.substr(equals + 1), split_path(path).back());
  if (target.is_string() && target.get_ref<const std::string&>().find('\0') != std::string::npos)
    fail(option, "the text has a NUL character");
}

}  // namespace meniscus
