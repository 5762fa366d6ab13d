# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# cmake -DOUT=file.cpp -DFOLDER=folder -P MeniscusShaders.cmake: a C++ file that holds the text of all shaders of a
# folder, as meniscus::render::shader_files().

file(GLOB shaders ${FOLDER}/*.glsl)
set(entries "")
foreach(shader ${shaders})
  get_filename_component(name ${shader} NAME)
  file(READ ${shader} text)
  string(APPEND entries "    {\"${name}\", R\"shader(${text})shader\"},\n")
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
