// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Applies the picture options to a scene.
#include "sdk/cli/output/picture_options.h"

#include <algorithm>
#include <charconv>

#include "sdk/scene/closest_name.h"

namespace meniscus::cli {
namespace {

constexpr int most_pixels = 16384;

/// The whole text as a number of pixels, or 0 if it is none.
int pixels_of(std::string_view text) {
  int value = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool good = failed == std::errc() && end == text.data() + text.size() && value <= most_pixels;
  return good ? std::max(value, 0) : 0;
}

void set_size(io::PreviewScene& picture, const std::string& size) {
  const std::size_t cross = std::min(size.find('x'), size.size());
  picture.width = pixels_of(std::string_view(size).substr(0, cross));
  picture.height = cross < size.size() ? pixels_of(std::string_view(size).substr(cross + 1)) : 0;
  if (picture.width && picture.height) return;
  throw Error(ErrorCode::invalid_argument, "--size is '" + size +
                                               "', but must be WIDTHxHEIGHT in pixels, each from 1 to " +
                                               std::to_string(most_pixels) + ", as in 1280x720");
}

}  // namespace

SceneCamera camera_named(const std::string& name, const Scene& scene) {
  std::vector<std::string> names;
  for (const SceneNamedCamera& camera : scene.cameras) {
    if (camera.name == name) return camera.view;
    names.push_back(camera.name);
  }
  throw Error(ErrorCode::invalid_argument,
              "--camera is '" + name + "', but the scene has " +
                  (names.empty() ? "no named cameras" : "no camera of that name; " + name_hint(name, names)));
}

io::PreviewScene picture_scene(const Scene& scene, const PictureOptions& options) {
  const bool is_still =
      options.samples > 1 || options.aperture > 0 || options.shutter > 0 || options.caustics;
  if (!options.any() &&
      (!options.filter.empty() || !options.anisotropic || !options.views.empty() || is_still)) {
    throw Error(
        ErrorCode::invalid_argument,
        "--filter, --no-anisotropy, --view, --samples, --aperture, --shutter and --caustics are for what "
        "OpenGL draws: they need --render or --video");
  }
  if (options.samples == 1 && (options.aperture > 0 || options.shutter > 0)) {
    throw Error(
        ErrorCode::invalid_argument,
        "--aperture and --shutter blur by the mean of several pictures: they need --samples, such as 32");
  }
  io::PreviewScene picture = io::preview_of(scene);
  if (!options.size.empty()) set_size(picture, options.size);
  if (!options.camera.empty()) picture.camera = camera_named(options.camera, scene);
  return picture;
}

}  // namespace meniscus::cli
