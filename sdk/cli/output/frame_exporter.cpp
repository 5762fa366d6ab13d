// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Writes the frames of a run as PLY, VTP, OBJ, USD, Alembic and OpenVDB files.
#include "sdk/cli/output/frame_exporter.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "pbd/host_memory.h"
#include "sdk/cli/output/rank_frames.h"
#include "sdk/io/obj.h"
#include "sdk/io/ply.h"
#include "sdk/io/vdb.h"
#include "sdk/io/vtp.h"

namespace meniscus::cli {
namespace {

bool has(const std::vector<std::string>& formats, const char* format) {
  return std::count(formats.begin(), formats.end(), format) > 0;
}

}  // namespace

FrameExporter::FrameExporter(std::filesystem::path folder, const std::vector<std::string>& formats,
                             bool surface, const Scene& scene, int ranks)
    : folder_(std::move(folder)),
      scene_(scene),
      ranks_(ranks),
      ply_(has(formats, "ply")),
      vtp_(has(formats, "vtp")),
      obj_(has(formats, "obj")),
      usd_(has(formats, "usd")),
      abc_(has(formats, "abc")),
      vdb_(has(formats, "vdb") && !scene.fluids.empty()),
      any_(!formats.empty()),
      particles_(!scene.fluids.empty() || !scene.granulars.empty() ||
                 (scene.cloths.empty() && scene.ropes.empty())),
      diffuse_(scene.world.diffuse.has_value()),
      cloth_(!scene.cloths.empty()),
      ropes_(!scene.ropes.empty()),
      surface_(surface && !scene.fluids.empty()) {
  if (!any_) return;
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

void FrameExporter::write(FrameSample& sample) {
  if (!any_) return;
  background_.wait_for_room();
  io::SceneFrame& frame = frames_[next_];
  next_ = (next_ + 1) % most_waiting;
  pbd::with_host_memory([&] {
    frame.number = sample.frame;
    frame.set_particles(sample.particles);
    frame.diffuse.assign(sample.diffuse.particles.begin(), sample.diffuse.particles.end());
    frame.bodies = sample.bodies;
    frame.cloth = sample.cloth;
    frame.ropes = sample.ropes;
    frame.liquid = std::move(sample.liquid);
    background_.add([this, &frame] { pbd::with_host_memory([&] { write_all(frame); }); });
  });
}

void FrameExporter::finish() {
  if (!any_) return;
  background_.finish();
  pbd::with_host_memory([&] {
    if (usd_recording_) usd_recording_->finish();
    if (abc_recording_) abc_recording_->finish();
  });
}

void FrameExporter::write_all(const io::SceneFrame& frame) {
  const int number = frame.number;
  if (!shapes_written_) write_shapes();
  shapes_written_ = true;
  if (particles_ && ranks_ == 0) write_files("frame", number, frame.particles(), particle_collection_);
  if (particles_ && ranks_ > 0) write_parted("frame", number, frame.particles(), particle_collection_);
  if (diffuse_ && ranks_ == 0) write_files("diffuse", number, frame.diffuse_frame(), diffuse_collection_);
  if (diffuse_ && ranks_ > 0) write_parted("diffuse", number, frame.diffuse_frame(), diffuse_collection_);
  if (bodies_) write_files("bodies", number, bodies_->at(frame.time, frame.bodies), body_collection_);
  if (cloth_) write_files("cloth", number, frame.cloth, cloth_collection_);
  if (ropes_) write_files("ropes", number, frame.ropes, rope_collection_);
  if (surface_) write_files("surface", number, frame.liquid, surface_collection_);
  if (usd_) write_usd(frame);
  if (abc_) write_abc(frame);
  if (vdb_)
    io::write_vdb(folder_ / fmt::format("frames/liquid_{:05}.vdb", number), frame.liquid, frame.particles(),
                  scene_.world.particle_spacing);
}

template <class Frame>
void FrameExporter::write_parted(const char* prefix, int frame, const Frame& contents,
                                 std::optional<io::PvdFile>& collection) const {
  const std::string name = fmt::format("frames/{}_{:05}", prefix, frame);
  if (ply_) io::write_ply(folder_ / (name + ".ply"), contents);
  if (obj_) io::write_obj(folder_ / (name + ".obj"), contents);
  if (!vtp_) return;
  std::vector<std::string> pieces;
  for (int r = 0; r < ranks_; ++r) pieces.push_back(piece_name(prefix, frame, r));
  io::write_pvtp<Frame>(folder_ / (name + ".pvtp"), pieces);
  collection->add(contents.time, name + ".pvtp");
}

void FrameExporter::write_shapes() const {
  if (!(ply_ || vtp_ || obj_)) return;
  const io::SurfaceFrame shapes = io::shape_surfaces(scene_.shapes);
  if (shapes.triangles.empty()) return;
  const std::filesystem::path name = folder_ / "frames" / "shapes";
  if (ply_) io::write_ply(name.string() + ".ply", shapes);
  if (obj_) io::write_obj(name.string() + ".obj", shapes);
  if (vtp_) io::write_vtp(name.string() + ".vtp", shapes);
}

void FrameExporter::write_usd(const io::SceneFrame& frame) {
  if (!usd_scene_) {
    usd_scene_.emplace(scene_, contents(), bodies_ ? &*bodies_ : nullptr, frame);
    usd_recording_.emplace(folder_, usd_scene_->stage());
  }
  usd_recording_->add(frame.number, usd_scene_->values(frame));
}

void FrameExporter::write_abc(const io::SceneFrame& frame) {
  if (!abc_recording_)
    abc_recording_.emplace(folder_ / "scene.abc", scene_, contents(), bodies_ ? &*bodies_ : nullptr, frame);
  abc_recording_->add(frame);
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
