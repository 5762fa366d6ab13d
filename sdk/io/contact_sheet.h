// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "sdk/io/png.h"

namespace meniscus::io {

/// A run at a glance: twelve of its frames, made small, in rows of four from the top left.
class ContactSheet {
 public:
  /// For a run of so many frames, 1 or more.
  explicit ContactSheet(int frames);

  /// Whether this one is among the twelve; frames count from 1, and the last one is.
  bool wants(int frame) const;
  /// All of them are of one size.
  void add(const Image& image);

  bool empty() const { return added_.empty(); }
  /// Of those that were added, one or more.
  Image image() const;

 private:
  int frames_, tiles_;
  std::vector<Image> added_;
};

}  // namespace meniscus::io
