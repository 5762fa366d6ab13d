// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// World's output for renderers on its device.
#include <meniscus/graphics.h>
#include <meniscus/world.h>

#include <algorithm>
#include <span>

#include "sdk/world/check/check.h"
#include "sdk/world/world_calls.h"

namespace meniscus {

struct GlParticles::Impl {
  std::unique_ptr<pbd::GlBuffers> buffers;
};

GlParticles::GlParticles(uint32_t ellipsoids, uint32_t fluids, uint32_t velocities) {
  const uint32_t names[] = {ellipsoids, fluids, velocities};
  impl_ = std::make_unique<Impl>(Impl{pbd::share_gl_buffers(std::span(names).first(velocities ? 3 : 2))});
}

GlParticles::~GlParticles() = default;
GlParticles::GlParticles(GlParticles&&) noexcept = default;
GlParticles& GlParticles::operator=(GlParticles&&) noexcept = default;

void World::Calls::write_particles(const ParticleArrays& arrays) const {
  if (!arrays.ellipsoids) check::refuse("ParticleArrays::ellipsoids", "null", "an array on the device");
  if (!arrays.fluids) check::refuse("ParticleArrays::fluids", "null", "an array on the device");
  impl_->with_all().write_particles(arrays);
  impl_->engine->device().wait();
}

void World::Calls::write_particles(GlParticles& particles) const {
  pbd::Device& device = impl_->engine->device();
  if (device.kind() != pbd::DeviceKind::cuda)
    check::refuse("World::device", device.name(),
                  "a device of CUDA, which buffers of OpenGL can be shared with");
  pbd::GlBuffers& buffers = *particles.impl_->buffers;
  const std::vector<pbd::LentMemory> lent = buffers.lend(device);
  const auto give_back = [&](pbd::GlBuffers* lender) { lender->give_back(device); };
  const std::unique_ptr<pbd::GlBuffers, decltype(give_back)> in_the_end(&buffers, give_back);
  const bool with_velocities = lent.size() > 2;
  size_t room = std::min(lent[0].bytes / sizeof(Ellipsoid), lent[1].bytes / sizeof(uint32_t));
  if (with_velocities) room = std::min(room, lent[2].bytes / sizeof(Vec3));
  if (room < particle_count()) {
    check::refuse("GlParticles", "buffers for " + std::to_string(room) + " particles",
                  "room for all " + std::to_string(particle_count()));
  }
  impl_->with_all().write_particles({static_cast<Ellipsoid*>(lent[0].data),
                                     static_cast<uint32_t*>(lent[1].data),
                                     with_velocities ? static_cast<Vec3*>(lent[2].data) : nullptr});
  device.send_off();  // reports failures here, not when the buffers are released
}

}  // namespace meniscus
