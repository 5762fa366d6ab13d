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

  /// See ContactSource.
  void limit_motion(View<const Vec4> from, View<Vec4> to, uint32_t count) {
    for (ContactSource<D>* source : sources_) source->limit_motion(from, to, count);
  }
  /// Counts the contacts of each particle.
  void count(const Substep<D>& substep);
  /// One element, on the device: how many there are.
  View<const uint32_t> total() const { return {start_.view().data + counted_, 1}; }
  /// Makes room for the contacts, and writes them.
  void fill(const Substep<D>& substep, uint32_t total);

  uint32_t contact_count() const { return total_; }
  ContactView view() { return {start_.view(), contacts_.view(), particle_.view().first(total_), radius_}; }

 private:
  void resize(uint32_t contacts);

  D& device_;
  float radius_;
  std::vector<ContactSource<D>*> sources_;
  uint32_t counted_ = 0;
  uint32_t total_ = 0;
  Buffer<uint32_t> counts_{device_, "contact counts"};
  Buffer<uint32_t> start_{device_, "contact offsets"};
  Buffer<uint32_t> particle_{device_, "contact particles"};
  Buffer<Contact> contacts_{device_, "contacts"};
};

}  // namespace meniscus::pbd
