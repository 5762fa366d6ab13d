// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A double buffer whose contents can be saved and restored without a copy.
#pragma once

#include "pbd/particles.h"

namespace meniscus::pbd {

/// Two arrays of which one is current, and a third that keeps the values of save(). Nothing is copied: the
/// first flip after save() keeps the memory with the values, and uses other memory from then on.
template <class T>
class RestorableBuffer {
 public:
  RestorableBuffer(Device& device, const char* what) : pair_(device, what), saved_(device, what) {}

  View<T> current() { return pair_.current.view(); }
  View<T> next() { return pair_.next.view(); }

  /// The size of current() is the new one only if there is memory for all three.
  void reserve(size_t size, size_t kept) {
    pair_.next.resize_discard(size);
    saved_.resize_discard(size);
    pair_.current.resize_keep(size, kept);
  }
  void flip() {
    pair_.flip();
    if (saving_) pair_.next.swap(saved_);
    saving_ = false;
  }
  void save() { saving_ = true; }
  /// The values of save().
  View<T> saved() { return (saving_ ? pair_.current : saved_).view(); }
  void restore() {
    if (!saving_) pair_.current.swap(saved_);
    saving_ = false;
  }

 private:
  DoubleBuffer<T> pair_;
  Buffer<T> saved_;
  bool saving_ = false;
};

}  // namespace meniscus::pbd
