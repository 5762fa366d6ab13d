// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Writes the frames of a run as PLY, VTP and OBJ files.
#include "sdk/cli/output/frame_exporter.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "pbd/host_memory.h"
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
                             bool surface, const Scene& scene)
    : folder_(std::move(folder)),
      ply_(has(formats, "ply")),
      vtp_(has(formats, "vtp")),
      obj_(has(formats, "obj")),
      particles_(!scene.fluids.empty() || !scene.granulars.empty() ||
                 (scene.cloths.empty() && scene.ropes.empty())),
      diffuse_(scene.world.diffuse.has_value()),
      cloth_(!scene.cloths.empty()),
      ropes_(!scene.ropes.empty()),
      surface_(surface && !scene.fluids.empty()) {
  if (formats.empty()) return;
  if (const std::vector<BodyDef> bodies = bodies_of(scene); !bodies.empty()) bodies_.emplace(bodies);
  make_frames_folder(folder_);
  if (!vtp_) return;
  if (particles_) particle_collection_.emplace(folder_ / "particles.pvd");
  if (diffuse_) diffuse_collection_.emplace(folder_ / "diffuse.pvd");
  if (bodies_) body_collection_.emplace(folder_ / "bodies.pvd");
  if (cloth_) cloth_collection_.emplace(folder_ / "cloth.pvd");
  if (ropes_) rope_collection_.emplace(folder_ / "ropes.pvd");
  if (surface_) surface_collection_.emplace(folder_ / "surface.pvd");
}

void FrameExporter::write(const FrameSample& sample) {
  pbd::with_host_memory([&] { write_all(sample); });
}

void FrameExporter::write_all(const FrameSample& sample) {
  const double time = sample.particles.time;
  if (particles_) write_files("frame", sample.frame, sample.particles, particle_collection_);
  if (diffuse_) write_files("diffuse", sample.frame, sample.diffuse, diffuse_collection_);
  if (bodies_) write_files("bodies", sample.frame, bodies_->at(time, sample.bodies), body_collection_);
  if (cloth_) write_files("cloth", sample.frame, sample.cloth, cloth_collection_);
  if (ropes_) write_files("ropes", sample.frame, sample.ropes, rope_collection_);
  if (surface_) write_files("surface", sample.frame, sample.liquid, surface_collection_);
}

template <class Frame>
void FrameExporter::write_files(const char* prefix, int frame, const Frame& contents,
                                std::optional<io::PvdFile>& collection) const {
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

void make_frames_folder(const std::filesystem::path& folder) {
  std::error_code unknown;
  if (std::filesystem::is_symlink(folder / "frames", unknown)) {
    throw Error(ErrorCode::io, "the folder " + (folder / "frames").string() +
                                   " is a symbolic link, through which no results are written");
  }
  make_folder(folder / "frames");
}

}  // namespace meniscus::cli
