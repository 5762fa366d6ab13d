// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Files of C, by the writers of the program.
#include <meniscus/c/export.h>

#include <filesystem>

#include "sdk/c/handles.h"
#include "sdk/io/cloth_frame.h"
#include "sdk/io/liquid_frame.h"
#include "sdk/io/obj.h"
#include "sdk/io/particle_frame.h"
#include "sdk/io/ply.h"
#include "sdk/io/vtp.h"

namespace meniscus::c {
namespace {

/// Refuses a path with an ending that is no format.
std::filesystem::path checked_path(const char* path) {
  std::filesystem::path file(&required(path, "path"));
  const std::filesystem::path ending = file.extension();
  if (ending == ".ply" || ending == ".vtp" || ending == ".obj") return file;
  throw Error(ErrorCode::invalid_argument,
              "path is " + file.string() + "; it must end in .ply, .vtp or .obj");
}

template <class Frame>
void write(const std::filesystem::path& file, const Frame& frame) {
  if (file.extension() == ".ply") return io::write_ply(file, frame);
  if (file.extension() == ".vtp") return io::write_vtp(file, frame);
  io::write_obj(file, frame);
}

template <class IdType>
std::vector<IdType> ids_of(const MeniscusId* ids, std::size_t count) {
  required_array(ids, count, "ids");
  std::vector<IdType> list;
  for (std::size_t i = 0; i < count; ++i) list.push_back(in_cpp<IdType>(ids[i]));
  return list;
}

/// Definitions that give each object a name by its number, as in cloth_0.
template <class Def>
std::vector<Def> numbered(const char* word, std::size_t count) {
  std::vector<Def> defs(count);
  for (std::size_t i = 0; i < count; ++i) defs[i].name = word + std::to_string(i);
  return defs;
}

}  // namespace
}  // namespace meniscus::c

using namespace meniscus::c;
using namespace meniscus;

MeniscusStatus meniscus_export_particles(const MeniscusWorld* world, const char* path) {
  return guarded([&] { write(checked_path(path), io::frame_of(world_of(world))); });
}

MeniscusStatus meniscus_export_diffuse(const MeniscusWorld* world, const char* path) {
  return guarded([&] {
    const World& w = world_of(world);
    write(checked_path(path), io::DiffuseFrame{w.time(), w.diffuse()});
  });
}

MeniscusStatus meniscus_export_surface(const MeniscusWorld* world, const MeniscusId* fluids, size_t count,
                                       const char* path) {
  return guarded([&] {
    const std::filesystem::path file = checked_path(path);
    write(file, io::liquid_frame_of(world_of(world), ids_of<FluidId>(fluids, count),
                                    numbered<FluidDef>("fluid_", count)));
  });
}

MeniscusStatus meniscus_export_cloth(const MeniscusWorld* world, const MeniscusId* cloths, size_t count,
                                     const char* path) {
  return guarded([&] {
    const std::filesystem::path file = checked_path(path);
    const std::vector<ClothId> ids = ids_of<ClothId>(cloths, count);
    io::ClothFrame frame = io::cloth_frame_of(world_of(world), ids, numbered<ClothDef>("cloth_", count));
    io::add_texture(frame, world_of(world), ids);
    write(file, frame);
  });
}
