# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# cmake -DOUT=file.cpp -DFOLDER=folder -P MeniscusShaders.cmake: a C++ file that holds the text of all shaders of a
# folder, as meniscus::render::shader_files().

file(GLOB_RECURSE shaders RELATIVE ${FOLDER} ${FOLDER}/*.glsl)
set(entries "")
foreach(shader ${shaders})
  file(READ ${FOLDER}/${shader} text)
  string(APPEND entries "    {\"${shader}\", R\"shader(${text})shader\"},\n")
endforeach()
file(WRITE ${OUT} "#include \"sdk/render/gl/shader_text.h\"

namespace meniscus::render {

std::span<const ShaderFile> shader_files() {
  static constexpr ShaderFile files[] = {
${entries}  };
  return files;
}

}  // namespace meniscus::render
")
