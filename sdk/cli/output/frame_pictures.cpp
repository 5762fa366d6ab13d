// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Writes the pictures and the video of a run.
#include "sdk/cli/output/frame_pictures.h"

#include <spdlog/spdlog.h>

#include "sdk/cli/output/frame_exporter.h"

namespace meniscus::cli {

FramePictures::FramePictures(const PictureOptions& options, std::filesystem::path folder,
                             const io::PreviewScene& picture, const Scene& scene, const World& world,
                             const FrameSample& first)
    : folder_(std::move(folder)), picture_(picture), each_frame_(options.render == "frames") {
  if (!options.any()) return;
  try {
    renderer_.emplace(picture, options, world, first);
  } catch (const Error& error) {
    if (options.render != "auto" || !options.video.empty() || error.code() != ErrorCode::device) throw;
    spdlog::warn("{}; the preview comes from the CPU", error.what());
    return;
  }
  if (options.render != "last") sheet_.emplace(scene.frames);
  if (options.video.empty()) return;
  // The run's own folder is made when all else is ready, but a video in it needs it now.
  const std::filesystem::path parent = std::filesystem::path(options.video).parent_path();
  if ((parent / "").lexically_normal() == (folder_ / "").lexically_normal()) make_folder(folder_);
  video_.emplace(options.video, picture.width, picture.height, 1 / double{scene.frame_time});
}

void FramePictures::add(const World& world, const FrameSample& sample) {
  const bool in_sheet = sheet_ && sheet_->wants(sample.frame);
  if (!each_frame_ && !video_ && !in_sheet) return;
  const io::Image image = renderer_->draw(world, sample);
  if (each_frame_) {
    make_frames_folder(folder_);
    io::write_png(folder_ / fmt::format("frames/render_{:05}.png", sample.frame), image);
  }
  if (video_) video_->add(image);
  if (in_sheet) sheet_->add(image);
}

void FramePictures::finish(const World& world, const FrameSample& last) {
  io::write_png(folder_ / "preview.png", renderer_ ? renderer_->draw(world, last)
                                                   : io::render_preview(last.particles, picture_, last.bodies,
                                                                        last.cloth, last.ropes));
  if (sheet_ && !sheet_->empty()) io::write_png(folder_ / "contact_sheet.png", sheet_->image());
  if (video_) video_->commit();
}

std::vector<std::string> FramePictures::files() const {
  std::vector<std::string> files;
  if (sheet_ && !sheet_->empty()) files.push_back("contact_sheet.png");
  if (each_frame_) files.push_back("frames/render_*.png");
  if (video_) files.push_back(video_->path().string());
  return files;
}

}  // namespace meniscus::cli
