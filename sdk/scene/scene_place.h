// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Names a place in a scene document for messages.
#pragma once

#include <meniscus/scene.h>

#include <string>

namespace meniscus {

/// A place in a scene's document, as errors name it: `fluids[0].rest_density`.
struct ScenePlace {
  std::string source;  ///< the file
  std::string path;    ///< empty for the whole document

  ScenePlace key(const std::string& name) const { return {source, path.empty() ? name : path + "." + name}; }
  ScenePlace item(std::size_t index) const { return {source, path + "[" + std::to_string(index) + "]"}; }

  /// Throws SceneError. `fix` says what to do, or what is allowed.
  [[noreturn]] void fail(const std::string& problem, const std::string& fix = "",
                         ErrorCode code = ErrorCode::parse) const {
    const auto before = [](const std::string& part) { return part.empty() ? "" : part + ": "; };
    const std::string end = fix.empty() ? "" : "; " + fix;
    throw SceneError(code, before(source) + before(path) + problem + end, source, path, fix);
  }
};

}  // namespace meniscus
