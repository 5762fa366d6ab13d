// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A contact sheet: one picture of twelve frames of a run.
#pragma once

#include <vector>

#include "sdk/io/png.h"

namespace meniscus::io {

/// Twelve frames of a run, scaled down, in rows of four from the top left.
class ContactSheet {
 public:
  /// For a run of this many frames, 1 or more.
  explicit ContactSheet(int frames);

  /// Whether this frame is among the twelve. Frames count from 1, and the last one is included.
  bool wants(int frame) const;
  /// All images have the same size.
  void add(const Image& image);

  bool empty() const { return added_.empty(); }
  /// The sheet of the images added, one or more.
  Image image() const;

 private:
  int frames_, tiles_;
  std::vector<Image> added_;
};

}  // namespace meniscus::io
