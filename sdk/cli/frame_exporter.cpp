// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/cli/frame_exporter.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "sdk/io/obj.h"
#include "sdk/io/ply.h"
#include "sdk/io/vtp.h"

namespace meniscus::cli {
namespace {

bool has(const std::vector<std::string>& formats, const char* format) {
  return std::count(formats.begin(), formats.end(), format) > 0;
}

}  // namespace

FrameExporter::FrameExporter(std::filesystem::path folder, const std::vector<std::string>& formats,
                             const std::vector<BodyDef>& bodies)
    : folder_(std::move(folder)),
      ply_(has(formats, "ply")),
      vtp_(has(formats, "vtp")),
      obj_(has(formats, "obj")) {
  if (formats.empty()) return;
  make_folder(folder_ / "frames");
  if (!bodies.empty()) bodies_.emplace(bodies);
  if (!vtp_) return;
  particle_collection_.emplace(folder_ / "particles.pvd");
  if (bodies_) body_collection_.emplace(folder_ / "bodies.pvd");
}

void FrameExporter::write(int frame, const io::ParticleFrame& particles, std::span<const BodyState> states) {
  write_files("frame", frame, particles, particle_collection_);
  if (bodies_) write_files("bodies", frame, bodies_->at(particles.time, states), body_collection_);
}

template <class Frame>
void FrameExporter::write_files(const char* prefix, int frame, const Frame& contents,
                                std::optional<io::PvdFile>& collection) {
  const std::string name = fmt::format("frames/{}_{:05}", prefix, frame);
  if (ply_) io::write_ply(folder_ / (name + ".ply"), contents);
  if (obj_) io::write_obj(folder_ / (name + ".obj"), contents);
  if (!vtp_) return;
  io::write_vtp(folder_ / (name + ".vtp"), contents);
  collection->add(contents.time, name + ".vtp");
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed)
    throw Error(ErrorCode::io, "cannot make the folder " + folder.string() + ": " + failed.message());
}

}  // namespace meniscus::cli
