// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Functions of RigidContactSet: its parts, and what it keeps from step to step.
#pragma once

#include <algorithm>
#include <bit>
#include <cassert>
#include <unordered_map>

#include "collision/rigid_contact/rigid_contact_set.h"

namespace meniscus::collision {

/// Makes room for `count` elements, with a half more so that it seldom grows.
template <class T>
void make_room(pbd::Buffer<T>& buffer, uint32_t count) {
  if (buffer.size() < count) buffer.resize_discard(count + count / 2 + 64);
}

/// The size of cells: small parts are those of up to twice the median radius.
inline float largest_small_radius(std::span<const ContactPart> parts) {
  std::vector<float> radii;
  for (const ContactPart& p : parts)
    if (!is_unbounded(p.shape)) radii.push_back(bounding_radius(p.shape));
  if (radii.empty()) return 1;
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::ranges::nth_element(radii, middle);
  const float most = rigid_contact_tuning::large * *middle;
  float largest = 0;
  for (const float r : radii)
    if (r <= most) largest = std::max(largest, r);
  return largest;
}

template <class D>
void RigidContactSet<D>::set_parts(const ContactSolid& all) {
  const std::vector<SavedContact> kept = save();
  const std::vector<ContactPart>& parts = all.parts;
  host_parts_ = parts;
  const uint32_t count = part_count();
  const float small = largest_small_radius(parts);
  std::vector<uint32_t> is_large(count), large;
  any_bounces_ = false;
  for (uint32_t i = 0; i < count; ++i) {
    const Convex& shape = parts[i].shape;
    is_large[i] = is_unbounded(shape) || bounding_radius(shape) > small;
    if (is_large[i]) large.push_back(i);
    any_bounces_ |= parts[i].restitution > 0;
  }
  // Boxes of two small parts overlap only if their centres are in cells beside each other.
  grid_ = {2 * (1 + rigid_contact_tuning::most_reach) * small,
           static_cast<uint32_t>(std::bit_width(std::max(2 * count, 8u)))};
  device_.wait();
  parts_.resize_discard(count);
  for (ContactPart& part : host_parts_)
    if (part.shape.kind != ConvexKind::ground) part.shape.table = HullBuffers::number_of(part.shape);
  parts_.write(host_parts_);
  hulls_.set(all.hulls, !all.grounds.empty());
  grounds_.set(all.grounds);
  is_large_.resize_discard(count);
  is_large_.write(is_large);
  large_.resize_discard(large.size());
  large_.write(large);
  placed_.resize_discard(count);
  for (auto* buffer : {&bucket_, &sorted_bucket_, &number_, &sorted_, &partners_})
    buffer->resize_discard(count);
  bucket_starts_.resize_discard((size_t{1} << grid_.bits) + 2);
  pair_starts_.resize_discard(count + 1);
  contact_start_.resize_discard(count + 1);
  starts_.resize_discard(rigid_contact_kernels::colour_count + 1);
  contact_count_ = 0;
  restore(kept);
}

inline SavedContact saved_point(uint64_t key_a, uint64_t key_b, const rigid_contact_kernels::ContactMemory& m,
                                uint32_t k) {
  return {key_a,         key_b,    m.feature[k],  m.pressure[k], m.friction[k],
          m.position[k], m.normal, m.distance[k], m.impulse[k]};
}

inline void add_point(rigid_contact_kernels::ContactMemory& m, const SavedContact& s) {
  const uint32_t k = m.count++;
  m.feature[k] = s.feature;
  m.pressure[k] = s.pressure;
  m.friction[k] = s.friction;
  m.position[k] = s.position;
  m.distance[k] = s.distance;
  m.impulse[k] = s.impulse;
}

template <class D>
void RigidContactSet<D>::Memory::make_room(uint32_t contact_count) {
  collision::make_room(contacts, contact_count);
  collision::make_room(touching, contact_count);
}

template <class D>
void RigidContactSet<D>::Memory::swap(Memory& other) {
  std::swap(count, other.count);
  contacts.swap(other.contacts);
  starts.swap(other.starts);
  touching.swap(other.touching);
}

template <class D>
void RigidContactSet<D>::keep() {
  kept_.make_room(memory_.count);
  kept_.starts.resize_discard(memory_.starts.size());
  kept_.count = memory_.count;
  const auto copy = [this](auto& to, auto& from, size_t count) {
    if (count) device_.copy(to.view().data, from.view().data, count * sizeof(*from.view().data));
  };
  copy(kept_.contacts, memory_.contacts, memory_.count);
  copy(kept_.touching, memory_.touching, memory_.count);
  copy(kept_.starts, memory_.starts, memory_.starts.size());
}

template <class D>
void RigidContactSet<D>::take_back() {
  assert(kept_.starts.size() == host_parts_.size() + 1);
  memory_.swap(kept_);
  contact_count_ = 0;
}

template <class D>
std::vector<TouchingParts> RigidContactSet<D>::touching() {
  std::vector<TouchingParts> all;
  if (memory_.count == 0) return all;
  for (const rigid_contact_kernels::PartPair& pair : memory_.touching.read(memory_.count))
    if (pair.a != pbd::no_index) all.push_back({host_parts_[pair.a].key, host_parts_[pair.b].key});
  return all;
}

template <class D>
std::vector<SavedContact> RigidContactSet<D>::save() {
  std::vector<SavedContact> saved;
  if (memory_.count == 0) return saved;
  device_.wait();
  const auto memory = memory_.contacts.read(memory_.count);
  const std::vector<uint32_t> start = memory_.starts.read(host_parts_.size() + 1);
  for (uint32_t a = 0; a < part_count(); ++a) {
    for (uint32_t m = start[a]; m < start[a + 1]; ++m) {
      for (uint32_t k = 0; k < memory[m].count; ++k)
        saved.push_back(saved_point(host_parts_[a].key, host_parts_[memory[m].b].key, memory[m], k));
    }
  }
  return saved;
}

/// Points of parts that are gone are left out.
template <class D>
void RigidContactSet<D>::restore(std::span<const SavedContact> saved) {
  using namespace rigid_contact_kernels;
  std::unordered_map<uint64_t, uint32_t> place;
  for (uint32_t i = 0; i < part_count(); ++i) place.emplace(host_parts_[i].key, i);
  std::vector<std::vector<ContactMemory>> of_part(host_parts_.size());
  for (const SavedContact& s : saved) {
    const auto a = place.find(s.key_a), b = place.find(s.key_b);
    if (a == place.end() || b == place.end()) continue;
    std::vector<ContactMemory>& all = of_part[a->second];
    // A ground has several manifolds with a part.
    if (all.empty() || all.back().b != b->second || all.back().count == most_manifold_points ||
        !(all.back().normal == s.normal))
      all.push_back({b->second, 0, s.normal, {}, {}, {}, {}, {}, {}});
    add_point(all.back(), s);
  }
  std::vector<ContactMemory> memory;
  std::vector<PartPair> touching;
  std::vector<uint32_t> start{0};
  for (uint32_t a = 0; a < part_count(); ++a) {
    for (const ContactMemory& m : of_part[a]) {
      memory.push_back(m);
      touching.push_back(touching_parts(a, m));
    }
    start.push_back(static_cast<uint32_t>(memory.size()));
  }
  memory_.count = static_cast<uint32_t>(memory.size());
  device_.wait();
  memory_.starts.resize_discard(start.size());
  memory_.starts.write(start);
  memory_.make_room(memory_.count);
  memory_.contacts.write(memory);
  memory_.touching.write(touching);
  contact_count_ = 0;
}

template <class D>
std::vector<ContactBodies> RigidContactSet<D>::found() {
  if (contact_count_ == 0) return {};
  device_.wait();
  return contact_bodies_.read(contact_count_);
}

}  // namespace meniscus::collision
