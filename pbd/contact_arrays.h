// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "pbd/substep.h"

namespace meniscus::pbd {

/// The contacts of one substep, gathered from all sources and packed particle by particle.
template <class D>
class ContactArrays {
 public:
  ContactArrays(D& device, float radius) : device_(device), radius_(radius) {}

  void add(ContactSource<D>& source) { sources_.push_back(&source); }
  void reserve(uint32_t capacity);

  /// Counts the contacts of each particle. Their total, and the number of particles that have any, are then
  /// on the device.
  void find_counts(const Substep<D>& substep);
  View<const uint32_t> total() const { return {start_.view().data + counted_, 1}; }
  View<const uint32_t> total_particles() const { return {place_.view().data + counted_, 1}; }
  /// Makes room for `total` contacts and writes them.
  void fill(const Substep<D>& substep, uint32_t total, uint32_t total_particles);

  uint32_t count() const { return count_; }
  ContactView view() {
    return {start_.view(), contacts_.view(), particles_.view().first(particle_count_), radius_};
  }

 private:
  D& device_;
  float radius_;
  std::vector<ContactSource<D>*> sources_;
  uint32_t counted_ = 0;
  uint32_t count_ = 0;
  uint32_t particle_count_ = 0;
  Buffer<uint32_t> counts_{device_, "contact counts"};
  Buffer<uint32_t> start_{device_, "contact offsets"};
  Buffer<uint32_t> touched_{device_, "touching particles"};
  Buffer<uint32_t> place_{device_, "touching particle offsets"};
  Buffer<uint32_t> particles_{device_, "touching particles"};
  Buffer<Contact> contacts_{device_, "contacts"};
};

}  // namespace meniscus::pbd
