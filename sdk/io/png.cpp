// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Writes PNG files.
#include "sdk/io/png.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <meniscus/error.h>
#include <stb/stb_image_write.h>

#include "sdk/files/output_file.h"

namespace meniscus::io {

void write_png(const std::filesystem::path& path, const Image& image) {
  std::string bytes;
  const auto append = [](void* to, void* data, int size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
  };
  if (!stbi_write_png_to_func(append, &bytes, image.width, image.height, 3, image.rgb.data(),
                              3 * image.width)) {
    throw Error(ErrorCode::io, "cannot encode " + path.string() + " as PNG: " + std::to_string(image.width) +
                                   " x " + std::to_string(image.height) + " pixels");
  }
  OutputFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace meniscus::io
