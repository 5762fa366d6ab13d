// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cloth, ropes and attachments of C.
#include <meniscus/c/cloth.h>

#include <span>

#include "sdk/c/handles.h"

using namespace meniscus::c;
using namespace meniscus;

MeniscusStatus meniscus_cloth_positions(const MeniscusWorld* world, MeniscusId cloth,
                                        const MeniscusVec3** positions, size_t* count) {
  return guarded(
      [&] { write_same(positions, count, world_of(world).cloth_positions(in_cpp<ClothId>(cloth))); });
}

MeniscusStatus meniscus_cloth_velocities(const MeniscusWorld* world, MeniscusId cloth,
                                         const MeniscusVec3** velocities, size_t* count) {
  return guarded(
      [&] { write_same(velocities, count, world_of(world).cloth_velocities(in_cpp<ClothId>(cloth))); });
}

MeniscusStatus meniscus_cloth_normals(const MeniscusWorld* world, MeniscusId cloth,
                                      const MeniscusVec3** normals, size_t* count) {
  return guarded([&] { write_same(normals, count, world_of(world).cloth_normals(in_cpp<ClothId>(cloth))); });
}

MeniscusStatus meniscus_cloth_triangles(const MeniscusWorld* world, MeniscusId cloth,
                                        const uint32_t** vertices, size_t* count) {
  return guarded(
      [&] { write_array(vertices, count, world_of(world).cloth_triangles(in_cpp<ClothId>(cloth))); });
}

MeniscusStatus meniscus_cloth_texture(const MeniscusWorld* world, MeniscusId cloth,
                                      const MeniscusTexturePoint** texture, size_t* count) {
  return guarded([&] { write_same(texture, count, world_of(world).cloth_texture(in_cpp<ClothId>(cloth))); });
}

MeniscusStatus meniscus_cloth_strains(const MeniscusWorld* world, MeniscusId cloth, const float** strains,
                                      size_t* count) {
  return guarded([&] { write_array(strains, count, world_of(world).cloth_strains(in_cpp<ClothId>(cloth))); });
}

MeniscusStatus meniscus_cloth_wetness(const MeniscusWorld* world, MeniscusId cloth, const float** wetness,
                                      size_t* count) {
  return guarded([&] { write_array(wetness, count, world_of(world).cloth_wetness(in_cpp<ClothId>(cloth))); });
}

MeniscusStatus meniscus_cloth_welded_vertices(const MeniscusWorld* world, MeniscusId cloth, uint32_t* count) {
  return guarded(
      [&] { required(count, "count") = world_of(world).cloth_welded_vertices(in_cpp<ClothId>(cloth)); });
}

MeniscusStatus meniscus_cloth_bending_fraction(const MeniscusWorld* world, MeniscusId cloth,
                                               float* fraction) {
  return guarded([&] {
    required(fraction, "fraction") = world_of(world).cloth_bending_fraction(in_cpp<ClothId>(cloth));
  });
}

MeniscusStatus meniscus_cloth_state(const MeniscusWorld* world, MeniscusId cloth, MeniscusClothState* state) {
  return guarded([&] {
    const ClothState s = world_of(world).cloth_state(in_cpp<ClothId>(cloth));
    write_result(state, {0, s.closed ? 1 : 0, s.mass, s.fluid_mass, s.area, s.mean_stretch, s.max_stretch,
                         s.volume, s.pressure, in_c(s.centre), in_c(s.momentum), s.kinetic_energy});
  });
}

MeniscusStatus meniscus_tear_events(MeniscusWorld* world, const MeniscusTearEvent** events, size_t* count) {
  return guarded([&] {
    std::vector<MeniscusTearEvent>& list = required(world, "world").tears;
    list.clear();
    for (const TearEvent& e : world->world.tear_events()) list.push_back({in_c(e.cloth), e.copy, e.original});
    write_array(events, count, list);
  });
}

MeniscusStatus meniscus_rope_positions(const MeniscusWorld* world, MeniscusId rope,
                                       const MeniscusVec3** positions, size_t* count) {
  return guarded([&] { write_same(positions, count, world_of(world).rope_positions(in_cpp<RopeId>(rope))); });
}

MeniscusStatus meniscus_rope_velocities(const MeniscusWorld* world, MeniscusId rope,
                                        const MeniscusVec3** velocities, size_t* count) {
  return guarded(
      [&] { write_same(velocities, count, world_of(world).rope_velocities(in_cpp<RopeId>(rope))); });
}

MeniscusStatus meniscus_rope_frames(const MeniscusWorld* world, MeniscusId rope, const MeniscusQuat** frames,
                                    size_t* count) {
  return guarded([&] { write_same(frames, count, world_of(world).rope_frames(in_cpp<RopeId>(rope))); });
}

MeniscusStatus meniscus_apply_vertex_impulses(MeniscusWorld* world, MeniscusId cloth_or_rope,
                                              const uint32_t* vertices, const MeniscusVec3* impulses,
                                              size_t count) {
  return guarded([&] {
    const std::span<const uint32_t> numbers(required_array(vertices, count, "vertices"), count);
    const std::span<const Vec3> on(same_layout<Vec3>(required_array(impulses, count, "impulses")), count);
    if (cloth_or_rope.kind == MENISCUS_ROPE)
      world_of(world).apply_impulses(in_cpp<RopeId>(cloth_or_rope), numbers, on);
    else
      world_of(world).apply_impulses(in_cpp<ClothId>(cloth_or_rope), numbers, on);
  });
}

MeniscusStatus meniscus_attachment_force(const MeniscusWorld* world, MeniscusId attachment,
                                         MeniscusVec3* force) {
  return guarded([&] {
    required(force, "force") = in_c(world_of(world).attachment_force(in_cpp<AttachmentId>(attachment)));
  });
}

MeniscusStatus meniscus_attachment_vertices(MeniscusWorld* world, MeniscusId attachment,
                                            const uint32_t** vertices, size_t* count) {
  return guarded([&] {
    MeniscusWorld& w = required(world, "world");
    w.attachment_vertices = w.world.attachment_vertices(in_cpp<AttachmentId>(attachment));
    write_array(vertices, count, w.attachment_vertices);
  });
}
