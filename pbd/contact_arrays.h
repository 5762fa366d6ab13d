// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The contacts of a substep, gathered from all contact sources.
#pragma once

#include <algorithm>
#include <vector>

#include "pbd/substep.h"

namespace meniscus::pbd {

/// The contacts of one substep, gathered from all sources and packed particle by particle. The total stays on
/// the device. Contacts beyond the capacity are left out, and the total is noted as capacity().
template <class D>
class ContactArrays {
 public:
  explicit ContactArrays(D& device) : device_(device) {}

  void add(ContactSource<D>& source) { sources_.push_back(&source); }
  void reserve(uint32_t capacity);

  /// See ContactSource.
  bool limits_motion() const {
    return std::any_of(sources_.begin(), sources_.end(), [](const auto* s) { return s->limits_motion(); });
  }
  void limit_motion(const MotionView& motion, bool planes_too) {
    for (ContactSource<D>* source : sources_) source->limit_motion(motion, planes_too);
  }
  /// Counts the contacts of each particle, and writes those for which there is room. note[0], on the device,
  /// records their number.
  void find(const Substep<D>& substep, View<SumNote> note);
  /// See ContactSource. Call it when contacts and neighbours have been found.
  void part_neighbours(const Substep<D>& substep);
  uint32_t capacity() const { return static_cast<uint32_t>(contacts_.size()); }
  void grow() { resize(capacity() + capacity() / 4); }
  /// For far fewer particles: the contacts get the room that they had at first.
  void shrink(uint32_t particles) { resize(first_room(particles)); }

  ContactView view() {
    bool any_moving = false;
    for (const ContactSource<D>* source : sources_) any_moving |= source->any_moving();
    return {start_.view().first(counted_ + 1), contacts_.view().first(any_ ? capacity() : 0),
            particle_.view(), touching(), any_moving};
  }

 private:
  static uint32_t first_room(uint32_t particles) { return particles < 8192 ? 1024 : particles / 8; }
  void resize(uint32_t contacts);
  /// The two counts follow the counts of the particles, so that one fill sets all of them to 0.
  TouchingView touching() { return {touching_.view(), {counts_.view().data + counted_, 2}}; }

  D& device_;
  std::vector<ContactSource<D>*> sources_;
  uint32_t counted_ = 0;
  bool any_ = false;  // at the last search
  Buffer<uint32_t> counts_{device_, "contact counts"};
  Buffer<uint32_t> start_{device_, "contact offsets"};
  Buffer<uint32_t> particle_{device_, "contact particles"};
  Buffer<uint32_t> touching_{device_, "touching particles"};
  Buffer<Contact> contacts_{device_, "contacts"};
};

}  // namespace meniscus::pbd
