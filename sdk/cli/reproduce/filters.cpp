// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Filters of the surface in pictures: bilateral, curvature flow and narrow range, side by side.
#include <meniscus/error.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "sdk/cli/evidence/streaks.h"
#include "sdk/cli/output/frame_renderer.h"
#include "sdk/cli/reproduce/parts.h"

namespace meniscus::cli::pbf {
namespace {

constexpr const char* filters[] = {"bilateral", "curvature-flow", "narrow-range"};
constexpr int width = 640, height = 480;

/// Frame of the bunny drop at which the bunny is in the pool and the splash rises.
constexpr double moment = 0.9;  // s

struct Drawn {
  std::string filter;
  io::Image picture, normals;
  Roughness roughness;
};

/// Pictures of one size from left to right.
io::Image side_by_side(const std::vector<const io::Image*>& images) {
  const int columns = static_cast<int>(images.size());
  io::Image row{columns * width, height, {}};
  row.rgb.resize(std::size_t{3} * row.width * height);
  for (int k = 0; k < columns; ++k) {
    for (int y = 0; y < height; ++y) {
      const auto from = images[k]->rgb.begin() + std::ptrdiff_t{3} * y * width;
      std::copy(
          from, from + std::ptrdiff_t{3} * width,
          row.rgb.begin() + std::ptrdiff_t{3} * (std::ptrdiff_t{y} * row.width + std::ptrdiff_t{k} * width));
    }
  }
  return row;
}

Drawn drawn_by(const std::string& filter, const Scene& scene, const World& world) {
  io::PreviewScene picture = io::preview_of(scene);
  picture.width = width;
  picture.height = height;
  picture.camera = camera_named("close", scene);
  const FrameSample sample{};
  PictureOptions options;
  options.render = "last";
  options.filter = filter;
  Drawn drawn{filter, {}, {}, {}};
  {
    FrameRenderer renderer(picture, options, world, sample);
    drawn.picture = renderer.draw(world, sample);
    drawn.roughness =
        roughness_of({width, height, renderer.fluid_normals()}, 3 * scene.world.particle_spacing);
  }
  options.views = {"normals"};
  drawn.normals = FrameRenderer(picture, options, world, sample).draw(world, sample);
  return drawn;
}

/// Throws Stopped, and Error(device) without OpenGL.
std::vector<Drawn> draw_all(const Context& context, const Scene& scene) {
  std::vector<Drawn> drawn;
  const double seconds = std::min(moment, context.options.seconds);
  const int last = frames_of(scene, seconds);
  run_figures({.name = "",
               .scene = scene,
               .seconds = seconds,
               .measured = false,
               .after =
                   [&](const World& world, int frame) {
                     if (frame != last) return;
                     for (const char* filter : filters) drawn.push_back(drawn_by(filter, scene, world));
                   }},
              context.budget);
  return drawn;
}

void report_drawn(io::Report& report, const std::vector<Drawn>& drawn) {
  std::vector<const io::Image*> pictures, normals;
  for (const Drawn& d : drawn) {
    pictures.push_back(&d.picture);
    normals.push_back(&d.normals);
  }
  report.picture("filters", "Bilateral filter, curvature flow and narrow range, from left to right",
                 side_by_side(pictures));
  report.picture("normals", "The normals of the three", side_by_side(normals));
  std::vector<io::Report::Cells> rows;
  for (const Drawn& d : drawn) {
    rows.push_back({d.filter, fmt::format("{:.2f}", d.roughness.axes),
                    fmt::format("{:.2f}", d.roughness.between), fmt::format("{:.3f}", d.roughness.ratio())});
    report.figures["filters"].push_back({{"filter", d.filter},
                                         {"roughness_axes_degrees", d.roughness.axes},
                                         {"roughness_between_degrees", d.roughness.between},
                                         {"places", d.roughness.places}});
  }
  report.table({"filter", "along rows and columns, °", "between them, °", "ratio"}, rows);
}

}  // namespace

bool add_filters(const Context& context) {
  const PaperScene found = context.scene("bunny_drop");
  io::Report& report = context.report;
  report.heading("Filters of the surface");
  report.paragraph(
      "One moment of the bunny drop, drawn by OpenGL with ellipsoids. The table says how fast normals "
      "turn back and forth over 5 pixels, as root mean square: along rows and columns, and 3 pixels one way "
      "and "
      "4 the "
      "other. A filter that works along rows and columns leaves streaks there. The ratio is near 1 without "
      "streaks, "
      "and 0.7 for nothing but streaks.");
  if (!found.stand_in.empty()) report.paragraph(found.stand_in);
  try {
    report_drawn(report, draw_all(context, found.scene));
  } catch (const Stopped&) {
    return false;
  } catch (const Error& error) {
    if (error.code() != ErrorCode::device) throw;
    report.paragraph(fmt::format("Not reproduced here: {}.", error.what()));
    report.figures["filters"] = nullptr;
  }
  return true;
}

}  // namespace meniscus::cli::pbf
