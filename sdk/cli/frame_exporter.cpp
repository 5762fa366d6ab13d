// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/cli/frame_exporter.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "sdk/io/ply.h"

namespace meniscus::cli {

FrameExporter::FrameExporter(std::filesystem::path folder, const std::vector<std::string>& formats)
    : folder_(std::move(folder)),
      ply_(std::count(formats.begin(), formats.end(), "ply") > 0),
      vtp_(std::count(formats.begin(), formats.end(), "vtp") > 0) {
  if (ply_ || vtp_) make_folder(folder_ / "frames");
  if (vtp_) collection_.emplace(folder_ / "particles.pvd");
}

void FrameExporter::write(int frame, const io::ParticleFrame& particles) {
  const std::filesystem::path name = fmt::format("frames/frame_{:05}", frame);
  if (ply_) io::write_ply((folder_ / name).replace_extension(".ply"), particles);
  if (!vtp_) return;
  const std::filesystem::path file = name.string() + ".vtp";
  io::write_vtp(folder_ / file, particles);
  collection_->add(particles.time, file);
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed)
    throw Error(ErrorCode::io, "cannot make the folder " + folder.string() + ": " + failed.message());
}

}  // namespace meniscus::cli
