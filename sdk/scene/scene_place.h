// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Names a place in a scene document for messages.
#pragma once

#include <meniscus/error.h>

#include <string>

namespace meniscus {

/// A place in a scene's document, as errors name it: `fluids[0].rest_density`.
struct ScenePlace {
  std::string source;  ///< the file
  std::string path;    ///< empty for the whole document

  ScenePlace key(const std::string& name) const { return {source, path.empty() ? name : path + "." + name}; }
  ScenePlace item(std::size_t index) const { return {source, path + "[" + std::to_string(index) + "]"}; }

  [[noreturn]] void fail(const std::string& message, ErrorCode code = ErrorCode::parse) const {
    throw Error(code, source + ": " + (path.empty() ? "" : path + ": ") + message);
  }
};

}  // namespace meniscus
