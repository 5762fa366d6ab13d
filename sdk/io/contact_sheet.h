// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A contact sheet: one picture of twelve frames of a run.
#pragma once

#include <vector>

#include "sdk/io/png.h"

namespace meniscus::io {

/// Twelve frames of a run, scaled down, in rows of four from the top left. They are chosen from twice as
/// many, so that about as much moves from each to the next.
class ContactSheet {
 public:
  /// For a run of this many frames, 1 or more.
  explicit ContactSheet(int frames);

  /// Whether this frame is one of 24 to choose from. Frames count from 1. The last one is included.
  bool wants(int frame) const;
  /// All images have the same size.
  void add(const Image& image);

  bool empty() const { return added_.empty(); }
  /// The sheet of shots from the images added, one or more. The first and the last of them are shots.
  Image image() const;

 private:
  int frames_, candidates_;
  std::vector<Image> added_;
};

}  // namespace meniscus::io
