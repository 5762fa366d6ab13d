// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// DeviceEngine's calls about cloth and ropes.
#pragma once

#include "pbd/repeated.h"
#include "sdk/engine/engine.inl"

namespace meniscus {

/// Sets the cloth of `worlds` worlds (pbd/worlds.h), each with this one.
template <class D>
void DeviceEngine<D>::set_cloth(const EngineCloth& cloth, uint32_t worlds) {
  const auto of_world = static_cast<uint32_t>(cloth.position.size()), vertices = worlds * of_world;
  if (vertices > vertex_capacity_) reserve(fluid_capacity_, vertices);
  fetch_contacts();
  cloth_.set_model(cloth.model, worlds);
  effective_mass_.set_vertices(vertices);
  stick_anchors_.set_vertices(vertices);
  rods_.set_model(cloth.rods);
  rods_.set_states(0, cloth.segments);
  ropes_.set_model(cloth.ropes);
  contacts_.set_pieces(pbd::repeated(std::span(cloth.touches), worlds));
  driven_.set(cloth.driven);
  attachments_.set_attachments(
      pbd::repeated(std::span(cloth.attachments), worlds, [&](collision::BodyAttachment& a, uint32_t world) {
        a.vertex += world * of_world;
        a.body += world * bodies_.worlds().each();
      }));
  contacts_.set_attached_bodies(attachments_.attached_bodies());
  const std::span<const pbd::SurfaceTriangle> triangles = cloth.model.triangles;
  face_points_.set_surface(cloth_.surface(), worlds);
  body_zones_.set_surface(cloth_.surface(), triangles, cloth.model.rest, cloth.touches.size(), worlds);
  float heaviest = 0;
  for (const pbd::Vec4& x : cloth.position) {
    if (x.w > 0) heaviest = std::max(heaviest, 1 / x.w);
  }
  self_contacts_.set_surface(triangles, cloth.model.rest, cloth_.surface().rest, cloth.contact_pieces,
                             heaviest, worlds);
  set_cloth_with_fluid(cloth, worlds, heaviest);
  const auto pieces = static_cast<uint32_t>(cloth.touches.size());
  particles_.set_vertices(pbd::repeated(std::span(cloth.position), worlds),
                          pbd::repeated(std::span(cloth.velocity), worlds),
                          pbd::repeated(std::span(cloth.phase), worlds,
                                        [&](pbd::Phase& phase, uint32_t world) { phase += world * pieces; }));
  if (worlds > 1) number_vertices(vertices / worlds);
  any_overlapping_ = true;
  solver_.particles_changed(particles_.sorted(), 0);
}

/// The vertices of each world of a batch have the same numbers.
template <class D>
void DeviceEngine<D>::number_vertices(uint32_t each) {
  std::vector<uint32_t> numbers(particles_.vertices());
  for (uint32_t v = 0; v < numbers.size(); ++v) numbers[v] = pbd::vertex_slot + v % each;
  particles_.number.current.write(numbers, particles_.sorted());
}

/// The part of it that meets fluid.
template <class D>
void DeviceEngine<D>::set_cloth_with_fluid(const EngineCloth& cloth, uint32_t worlds, float heaviest) {
  const std::vector<cloth::Piece>& pieces = cloth.model.pieces;
  const bool carries_fluid =
      std::any_of(pieces.begin(), pieces.end(), [](const cloth::Piece& p) { return p.carries_fluid; });
  const std::span<const pbd::SurfaceTriangle> triangles = cloth.model.triangles, none{};
  fluid_cloth_contacts_.set_surface(carries_fluid ? triangles : none, cloth.model.rest, cloth.sheets, worlds);
  std::vector<float> slip;
  for (const collision::FluidClothPiece& sheet : cloth.sheets) slip.push_back(sheet.slip_length);
  viscosity_.set_cloth(pbd::repeated(std::span<const float>(slip), worlds));
  std::vector<float> inverse_masses;
  if (carries_fluid) {
    for (const pbd::Vec4& x : cloth.position) inverse_masses.push_back(x.w);
  }
  const float s = def_.particle_spacing, water = 1000.0f * s * s * s;
  fluid_cloth_.set_vertices(pbd::repeated(std::span<const float>(inverse_masses), worlds),
                            std::max(heaviest, water));
}

template <class D>
void DeviceEngine<D>::weigh_vertices(uint32_t first, std::span<const float> inverse_masses,
                                     std::span<const Vec3> velocities) {
  const uint32_t at = particles_.sorted() + first;
  std::vector<pbd::Vec4> position(inverse_masses.size()), velocity(inverse_masses.size());
  particles_.position.current.read(std::span(position), at);
  particles_.velocity.current.read(std::span(velocity), at);
  std::vector<float> weights(inverse_masses.size());
  for (size_t v = 0; v < weights.size(); ++v) {
    if (position[v].w == 0) continue;
    weights[v] = position[v].w = inverse_masses[v];
    velocity[v] = pbd::with_w(velocities[v], velocity[v].w);
  }
  particles_.position.current.write(position, at);
  particles_.velocity.current.write(velocity, at);
  fluid_cloth_.weigh(first, weights);
  solver_.particles_changed(particles_.sorted(), 0);
}

template <class D>
void DeviceEngine<D>::read_vertices(std::span<Vec3> positions, std::span<Vec3> velocities) {
  const auto read = [&](const pbd::Buffer<pbd::Vec4>& from, std::span<Vec3> out) {
    std::vector<pbd::Vec4> values(particles_.vertices());
    from.read(std::span(values), particles_.sorted());
    std::transform(values.begin(), values.end(), out.begin(), [](const pbd::Vec4& v) { return v.xyz(); });
  };
  read(particles_.position.current, positions);
  read(particles_.velocity.current, velocities);
}

}  // namespace meniscus
