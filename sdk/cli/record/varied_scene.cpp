// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads variations, and writes random numbers into a scene's document.
#include "sdk/cli/record/varied_scene.h"

#include <meniscus/error.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "pbd/math/hash.h"
#include "sdk/scene/scene_file.h"
#include "sdk/scene/scene_override.h"

namespace meniscus::cli {
namespace {

[[noreturn]] void fail(const std::string& text, const std::string& message) {
  throw Error(ErrorCode::invalid_argument, "--vary " + text + ": " + message);
}

/// A list of a scene, or an object of it, and the keys that worlds of a batch may have of their own. A key
/// stands for all that it holds.
struct Allowed {
  const char* owner;
  std::vector<const char*> keys;
};

const std::vector<Allowed>& allowed() {
  static const std::vector<Allowed> all{{"world", {"gravity"}},
                                        {"volumes", {"velocity", "region", "pose"}},
                                        {"cloths", {"pose", "velocity"}},
                                        {"bodies", {"pose", "velocity", "angular_velocity"}}};
  return all;
}

/// `key` or `key[3]`, followed by a dot, a bracket or the end. Returns what follows, or nothing.
bool take(std::string_view& path, std::string_view key) {
  if (!path.starts_with(key)) return false;
  const std::string_view rest = path.substr(key.size());
  if (!rest.empty() && rest.front() != '.' && rest.front() != '[') return false;
  path = rest;
  return true;
}

bool may_differ(std::string_view path) {
  for (const Allowed& one : allowed()) {
    std::string_view rest = path;
    if (!take(rest, one.owner)) continue;
    const std::size_t dot = rest.find('.');
    if (dot == std::string_view::npos) return false;
    rest.remove_prefix(dot + 1);
    return std::ranges::any_of(one.keys, [&](const char* key) { return take(rest, key); });
  }
  return false;
}

std::string list_of_allowed() {
  std::string list;
  for (const Allowed& one : allowed())
    for (const char* key : one.keys)
      list += (list.empty() ? "" : ", ") + std::string(one.owner) +
              (std::string_view(one.owner) == "world" ? "." : "[…].") + key;
  return list;
}

bool read(std::string_view text, double& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
}

/// Vectors that a scene leaves out have their default, so that one component may be varied.
void fill_in_vector(nlohmann::json& document, const std::string& path, const std::string& option) {
  const std::size_t bracket = path.rfind('[');
  if (bracket == std::string::npos || path.back() != ']') return;
  const std::string vector = path.substr(0, bracket);
  if (vector == "volumes" || vector == "cloths" || vector == "bodies") return;
  nlohmann::json& value = value_at(document, vector, option);
  if (!value.is_null()) return;
  const Vec3 gravity = WorldDef().gravity;
  if (vector == "world.gravity") {
    value = {gravity.x, gravity.y, gravity.z};
  } else if (vector.ends_with("velocity") || vector.ends_with("position")) {
    value = {0, 0, 0};
  }
}

}  // namespace

Variation parse_variation(const std::string& text) {
  const std::size_t equals = text.find('='), colon = text.find(':', std::min(equals, text.size()));
  if (equals == std::string::npos || colon == std::string::npos)
    fail(text, "must read path=low:high, as in world.gravity[0]=-1:1");
  Variation made{text.substr(0, equals), 0, 0};
  const std::string_view whole(text);
  if (!read(whole.substr(equals + 1, colon - equals - 1), made.low) ||
      !read(whole.substr(colon + 1), made.high))
    fail(text, "low and high must be numbers");
  if (made.low > made.high) fail(text, "low must not be above high");
  if (!may_differ(made.path))
    fail(text, "this is the same in all worlds of a batch; what may differ is in " + list_of_allowed());
  return made;
}

VariedScene::VariedScene(nlohmann::json document, std::string path, std::vector<Variation> variations,
                         uint64_t seed)
    : document_(std::move(document)),
      path_(std::move(path)),
      variations_(std::move(variations)),
      seed_(seed) {
  for (const Variation& v : variations_) {
    fill_in_vector(document_, v.path, "--vary " + v.path);
    if (!value_at(document_, v.path, "--vary " + v.path).is_number())
      fail(v.path, "the scene has no number there");
  }
}

bool VariedScene::varies_gravity_alone() const {
  return std::ranges::all_of(variations_,
                             [](const Variation& v) { return v.path.starts_with("world.gravity"); });
}

double VariedScene::value(uint32_t world, std::size_t k) const {
  const uint64_t bits = pbd::mixed(pbd::mixed(pbd::mixed(seed_) + world) + k);
  const double part = std::ldexp(static_cast<double>(bits >> 11), -53);  // 0 to below 1
  const double value = variations_[k].low + part * (variations_[k].high - variations_[k].low);
  return double{static_cast<float>(value)};  // as a scene has it, so that tables show it whole
}

Scene VariedScene::scene(uint32_t world) const {
  nlohmann::json own = document_;
  for (std::size_t k = 0; k < variations_.size(); ++k)
    value_at(own, variations_[k].path, "--vary") = value(world, k);
  return scene_of_document(own, path_);
}

}  // namespace meniscus::cli
