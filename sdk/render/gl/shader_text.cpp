// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Resolves the includes of shader files.
#include "sdk/render/gl/shader_text.h"

#include <meniscus/error.h>

#include <algorithm>

namespace meniscus::render {

std::string shader_text(std::string_view name) {
  const std::span<const ShaderFile> files = shader_files();
  const auto file =
      std::find_if(files.begin(), files.end(), [&](const ShaderFile& f) { return f.name == name; });
  if (file == files.end())
    throw Error(ErrorCode::not_found, "there is no shader called " + std::string(name));
  constexpr std::string_view include = "#include \"";
  std::string text(file->text);
  for (std::size_t at; (at = text.find(include)) != std::string::npos;) {
    const std::size_t from = at + include.size(), to = text.find('"', from);
    const std::string included = shader_text(text.substr(from, to - from));
    text.replace(at, to + 1 - at, included);
  }
  return text;
}

}  // namespace meniscus::render
