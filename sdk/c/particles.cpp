// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Read-outs of particles of C.
#include <meniscus/c/particles.h>

#include <memory>

#include "sdk/c/handles.h"

using namespace meniscus::c;
using namespace meniscus;

MeniscusStatus meniscus_particle_count(const MeniscusWorld* world, size_t* count) {
  return guarded([&] { required(count, "count") = world_of(world).particle_count(); });
}

MeniscusStatus meniscus_ids(const MeniscusWorld* world, const uint64_t** ids, size_t* count) {
  return guarded([&] { write_array(ids, count, world_of(world).ids()); });
}

MeniscusStatus meniscus_positions(const MeniscusWorld* world, const MeniscusVec3** positions, size_t* count) {
  return guarded([&] { write_same(positions, count, world_of(world).positions()); });
}

MeniscusStatus meniscus_velocities(const MeniscusWorld* world, const MeniscusVec3** velocities,
                                   size_t* count) {
  return guarded([&] { write_same(velocities, count, world_of(world).velocities()); });
}

MeniscusStatus meniscus_fluids(const MeniscusWorld* world, const uint32_t** fluids, size_t* count) {
  return guarded([&] { write_array(fluids, count, world_of(world).fluids()); });
}

MeniscusStatus meniscus_density_errors(const MeniscusWorld* world, const float** errors, size_t* count) {
  return guarded([&] { write_array(errors, count, world_of(world).density_errors()); });
}

MeniscusStatus meniscus_pressures(const MeniscusWorld* world, const float** pressures, size_t* count) {
  return guarded([&] { write_array(pressures, count, world_of(world).pressures()); });
}

MeniscusStatus meniscus_ellipsoids(const MeniscusWorld* world, const MeniscusEllipsoid** ellipsoids,
                                   size_t* count) {
  return guarded([&] { write_same(ellipsoids, count, world_of(world).ellipsoids()); });
}

MeniscusStatus meniscus_write_particles(const MeniscusWorld* world, MeniscusEllipsoid* ellipsoids,
                                        uint32_t* fluids, MeniscusVec3* velocities) {
  return guarded([&] {
    static_assert(sizeof(MeniscusEllipsoid) == sizeof(Ellipsoid) && sizeof(MeniscusVec3) == sizeof(Vec3));
    world_of(world).write_particles(
        ParticleArrays{reinterpret_cast<Ellipsoid*>(&required(ellipsoids, "ellipsoids")), fluids,
                       reinterpret_cast<Vec3*>(velocities)});
  });
}

MeniscusStatus meniscus_dlpack(const MeniscusWorld* world, MeniscusDeviceArray array,
                               struct DLManagedTensor** tensor, void** stream) {
  return guarded([&] {
    DLManagedTensor*& out = required(tensor, "tensor");
    constexpr DeviceArray DeviceArrays::*members[] = {&DeviceArrays::ids, &DeviceArrays::positions,
                                                      &DeviceArrays::velocities, &DeviceArrays::phases};
    if (array < MENISCUS_DEVICE_IDS || array > MENISCUS_DEVICE_PHASES)
      throw Error(ErrorCode::invalid_argument, "array is " + std::to_string(static_cast<int>(array)));
    const DeviceArrays all = world_of(world).device_arrays();
    out = to_dlpack(all.*members[array]);
    if (stream) *stream = (all.*members[array]).stream;
  });
}

MeniscusStatus meniscus_diffuse(const MeniscusWorld* world, const MeniscusDiffuseParticle** particles,
                                size_t* count) {
  return guarded([&] { write_same(particles, count, world_of(world).diffuse()); });
}

MeniscusStatus meniscus_surface_mesh(MeniscusWorld* world, const MeniscusDef* def,
                                     MeniscusSurfaceMesh* mesh) {
  return guarded([&] {
    check_size(required(mesh, "mesh"));
    SurfaceMesh& made = required(world, "world").surface;
    made = world->world.surface_mesh(def ? def_of<SurfaceMeshDef>(def) : SurfaceMeshDef{});
    write_result(mesh, {0, same_layout<MeniscusVec3>(made.vertices.data()),
                        same_layout<MeniscusVec3>(made.normals.data()), made.vertices.size(),
                        made.triangles.empty() ? nullptr : made.triangles.data()->data(),
                        made.triangles.size(), same_layout<MeniscusVec3>(made.velocities.data())});
  });
}

MeniscusStatus meniscus_gl_particles_create(uint32_t ellipsoids, uint32_t fluids, uint32_t velocities,
                                            MeniscusGlParticles** buffers) {
  return guarded([&] {
    MeniscusGlParticles*& out = required(buffers, "buffers");
    out = std::make_unique<MeniscusGlParticles>(
              MeniscusGlParticles{GlParticles(ellipsoids, fluids, velocities)})
              .release();
  });
}

void meniscus_gl_particles_destroy(MeniscusGlParticles* buffers) {
  delete buffers;
}

MeniscusStatus meniscus_write_gl_particles(const MeniscusWorld* world, MeniscusGlParticles* buffers) {
  return guarded([&] { world_of(world).write_particles(required(buffers, "buffers").buffers); });
}
