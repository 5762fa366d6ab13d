// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The text of the shaders, which is built into the program.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace meniscus::render {

struct ShaderFile {
  std::string_view name, text;
};

/// All files of sdk/render/shaders by their paths there, as of when the program was built.
std::span<const ShaderFile> shader_files();

/// The text of one file, with each line `#include "file"` replaced by that file. Throws Error(not_found).
std::string shader_text(std::string_view name);

}  // namespace meniscus::render
