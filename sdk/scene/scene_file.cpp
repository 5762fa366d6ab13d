// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads a scene file and makes a Scene of it.
#include "sdk/scene/scene_file.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>
#include <vector>

#include "pbd/host_memory.h"
#include "sdk/scene/scene_meshes.h"
#include "sdk/scene/scene_override.h"
#include "sdk/scene/scene_place.h"

namespace meniscus {
namespace {

using Json = nlohmann::json;

constexpr std::size_t most_bytes = std::size_t{256} << 20;  ///< a hundred times the largest sample, and more
constexpr int most_levels = 256;

std::string read_text(const std::string& path) {
  const ScenePlace place{path, ""};
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    place.fail("is a folder, not a scene file", ErrorCode::io);
  std::ifstream file(path, std::ios::binary);
  if (!file) place.fail("cannot be read: " + std::generic_category().message(errno), ErrorCode::io);
  // A pipe or a device need not end.
  std::string text;
  for (std::vector<char> block(std::size_t{1} << 16); file;) {
    file.read(block.data(), std::ptrdiff_t(block.size()));
    text.append(block.data(), std::size_t(file.gcount()));
    if (text.size() > most_bytes) {
      place.fail(
          "is longer than " + std::to_string(most_bytes) + " bytes, the most that a scene file may have",
          ErrorCode::io);
    }
  }
  if (file.bad()) place.fail("cannot be read to its end", ErrorCode::io);
  return text;
}

/// Refuses an object in which a key stands twice; the library would keep the last and say nothing. Refuses a
/// text with a NUL, which would end messages that name it, and nesting that overruns the stack.
class DocumentCheck {
 public:
  explicit DocumentCheck(const std::string& source) : source_(source) {}

  bool operator()(int depth, Json::parse_event_t event, const Json& parsed) {
    if (depth > most_levels)
      ScenePlace{source_, ""}.fail("is nested more than " + std::to_string(most_levels) + " levels deep");
    if (parsed.is_string() && parsed.get_ref<const std::string&>().find('\0') != std::string::npos)
      ScenePlace{source_, ""}.fail("the text " + parsed.dump() + " has a NUL character");
    if (event == Json::parse_event_t::object_start) open_.emplace_back();
    if (event == Json::parse_event_t::object_end) open_.pop_back();
    if (event == Json::parse_event_t::key && !open_.back().insert(parsed.get<std::string>()).second) {
      ScenePlace{source_, ""}.fail("the key " + parsed.dump() + " stands twice in one object");
    }
    return true;
  }

 private:
  const std::string& source_;
  std::vector<std::set<std::string>> open_;  ///< keys of the objects around
};

/// "line 3, column 5" of the last byte that the parser took, which the library counts from 1.
std::string position_of(std::size_t byte, const std::string& text) {
  const std::size_t end = std::min(byte, text.size());
  const std::size_t last = end > 0 ? end - 1 : 0;
  const auto line = 1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(last), '\n');
  const std::size_t line_break = last > 0 ? text.rfind('\n', last - 1) : std::string::npos;
  const std::size_t column = line_break == std::string::npos ? last + 1 : last - line_break;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

/// Notes at which byte the parser stops: not all of the library's errors say.
class StopFinder : public nlohmann::json_sax<Json> {
 public:
  std::size_t byte = 0;

  bool parse_error(std::size_t position, const std::string&, const Json::exception&) override {
    byte = position;
    return false;
  }

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return true; }
  bool key(string_t&) override { return true; }
  bool end_object() override { return true; }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }
};

std::size_t stop_in(const std::string& text) {
  constexpr bool to_the_end = true, comments_allowed = true;
  StopFinder finder;
  Json::sax_parse(text, &finder, Json::input_format_t::json, to_the_end, comments_allowed);
  return finder.byte;
}

/// What comes after the last of the library's own headings: "[json.exception.…] parse error at …: what is
/// wrong".
std::string plain_message(const Json::exception& error, const std::string& heading_end) {
  const std::string message = error.what();
  const std::size_t end = message.find(heading_end);
  return end == std::string::npos ? message : message.substr(end + heading_end.size());
}

Json parse_text(const std::string& text, const std::string& source) {
  constexpr bool throws = true, comments_allowed = true;
  const ScenePlace place{source, ""};
  try {
    return Json::parse(text, DocumentCheck(source), throws, comments_allowed);
  } catch (const Json::parse_error& error) {
    place.fail(position_of(error.byte, text) + ": " + plain_message(error, ": "));
  } catch (const Json::exception& error) {  // of a number that no double holds
    place.fail(position_of(stop_in(text), text) + ": " + plain_message(error, "] "));
  }
}

}  // namespace

Scene read_scene(const std::string& path, std::span<const std::string> overrides) {
  return pbd::with_host_memory([&] { return scene_of_document(read_document(path, overrides), path); });
}

Json read_document(const std::string& path, std::span<const std::string> overrides) {
  return pbd::with_host_memory([&] {
    Json document = parse_text(read_text(path), path);
    // What is no object is refused when it is read as a scene.
    if (!document.is_object()) return document;
    for (const std::string& text : overrides) apply_override(document, text);
    return document;
  });
}

Scene scene_of_document(const Json& document, const std::string& path) {
  return pbd::with_host_memory([&] {
    Scene scene = parse_scene(document, path);
    resolve_meshes(scene, document, std::filesystem::path(path).parent_path(), path);
    return scene;
  });
}

}  // namespace meniscus
