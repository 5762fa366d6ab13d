// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The source of contacts between fluid and cloth.
#pragma once

#include <span>
#include <vector>

#include "collision/fluid_cloth/cloth_shapes.h"
#include "collision/fluid_cloth/cloth_surface.h"
#include "pbd/device/shared_buffer.h"
#include "pbd/substep.h"
#include "pbd/surface_tree/surface_tree.h"

namespace meniscus::collision {

/// Finds the contacts of fluid with cloth: one for each layer near a particle, at the nearest triangle. Each
/// has the fraction of a whole plane that the layer covers there (pbd::Contact::fraction).
///
/// The side is the one that the particle was on at the substep's start. Motion through a triangle ends in a
/// contact on that side. Neighbours with a triangle between them are separated, and mirror ghosts of the
/// cloth take their place.
///
/// Must come before ShapeContacts among the sources. FluidClothSet makes the contacts act on the cloth.
template <class D>
class FluidClothContacts final : public pbd::ContactSource<D> {
 public:
  FluidClothContacts(D& device, pbd::Particles& particles, float support_radius)
      : device_(device), particles_(particles), support_radius_(support_radius), tree_(device) {}

  /// Sets all triangles of all pieces, and the pieces by number. `positions` are those of the vertices at
  /// rest. With several worlds all are those of the first.
  void set_surface(std::span<const pbd::SurfaceTriangle> triangles, std::span<const Vec3> positions,
                   std::span<const FluidClothPiece> pieces, uint32_t worlds);
  /// One filter a fluid, or empty where all collide with everything. Must stay valid until the next call.
  void set_filters(pbd::View<const CollisionFilter> filters) { filters_ = filters; }

  bool any() const override { return tree_.places() > 0 && particles_.sorted() > 0; }
  bool any_moving() const override { return any(); }
  void count(const pbd::Substep<D>& substep, const pbd::ContactCounter& counter) override;
  void fill(const pbd::Substep<D>& substep, const pbd::ContactWriter& writer) override;
  void part_neighbours(const pbd::Substep<D>& substep) override;

  /// Clamps particles that would end on the other side at the time of impact. The contacts correct their
  /// velocity.
  void clamp_at_impact(const pbd::Substep<D>& substep);

  /// Particles that touched absorbent pieces at the end of the last substep, by slot.
  std::vector<WettingTouch> read_wetting(pbd::View<const pbd::Contact> contacts);

  /// Whether fluid passes through any piece.
  bool permeable() const { return permeable_; }
  pbd::View<const FluidClothPiece> pieces() const { return pieces_.view(); }

  // For FluidClothSet: the results of the last search.
  fluid_cloth_kernels::NearList near();
  /// By vertex: where its entries begin (fluid_cloth_kernels::EnterTouches); last: the total.
  pbd::View<const uint32_t> entry_start() const { return entry_start_.view(); }
  pbd::View<const uint32_t> entries() const { return entries_.view(); }
  uint32_t vertices() const { return vertices_; }
  /// The size of launches over the near particles: the capacity, or, where the host is in step with the
  /// device, their number.
  uint32_t near_count();

  void start_step();
  bool had_room() const { return most_near() <= near_.size(); }
  void make_room();
  /// The largest number of particles near cloth in any substep of the last step.
  uint32_t most_near() const { return found(fluid_cloth_kernels::near_cloth); }
  /// Of the last step, summed over its substeps: see fluid_cloth_kernels::Found.
  uint32_t found(fluid_cloth_kernels::Found what) const {
    return found_.host().empty() ? 0 : found_.host()[what];
  }

 private:
  fluid_cloth_kernels::Surface surface(const pbd::Substep<D>& substep);
  void reserve_near(uint32_t capacity);

  D& device_;
  pbd::Particles& particles_;
  float support_radius_;
  pbd::SurfaceTree<D> tree_;
  uint32_t vertices_ = 0, worlds_ = 1;
  float largest_radius_ = 0;
  bool permeable_ = false, absorbent_ = false;
  pbd::View<const CollisionFilter> filters_;
  pbd::Buffer<FluidClothPiece> pieces_{device_, "cloth pieces"};
  pbd::Buffer<uint32_t> marks_{device_, "cloth marks"};
  pbd::Buffer<fluid_cloth_kernels::GroupShape> shapes_{device_, "shapes of sheets"};
  pbd::Buffer<uint32_t> near_{device_, "particles near sheets"};
  pbd::Buffer<uint32_t> counter_{device_, "particles near sheets"};
  pbd::Buffer<fluid_cloth_kernels::FluidClothContact> touches_{device_, "cloth touches"};
  pbd::Buffer<uint32_t> entry_count_{device_, "touches of vertices"};
  pbd::Buffer<uint32_t> entry_start_{device_, "touches of vertices"};
  pbd::Buffer<uint32_t> entries_{device_, "touches of vertices"};
  pbd::Buffer<WettingTouch> wetting_{device_, "wetting particles"};
  pbd::Buffer<uint32_t> wetting_count_{device_, "wetting particles"};
  pbd::SharedBuffer<uint32_t> found_{device_, "cloth counts"};
};

}  // namespace meniscus::collision
