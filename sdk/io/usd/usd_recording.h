// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A run as a USD file, frame by frame.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sdk/io/usd/usd_stage.h"

namespace meniscus::io {

/// Writes the frames of a stage. While it records, FOLDER/scene.usda refers to a layer a frame by value
/// clips, in FOLDER/frames/usd.00000.usda and so on. After each frame it is a stage that can be opened. At
/// the end, a run whose values take at most `one_file_bytes` as text becomes one file, and the layers are
/// removed.
///
/// Transforms count between frames too. So a frame's layer has those of the next frame as well, and is
/// written when that is known, or at the end.
class UsdRecording {
 public:
  static constexpr std::size_t one_file_bytes = std::size_t{64} << 20;

  /// FOLDER/frames must exist. Nothing is written before the first frame.
  UsdRecording(std::filesystem::path folder, UsdStage stage, std::size_t one_file = one_file_bytes);

  /// Adds a frame, whose number is one more than that of the last. `values`: the value of each attribute in
  /// UsdStage::varying, as text. Throws Error(io).
  void add(int frame, std::vector<std::string> values);

  /// Writes what is left to write. Throws Error(io).
  void finish();

 private:
  struct Frame {
    int number;
    std::vector<std::string> values;
  };

  std::filesystem::path clip(int frame) const;
  void begin(int frame);
  void write_clip(const Frame& frame, const Frame* next) const;
  void write_master(int last) const;
  void write_one_file() const;
  void remove_clips() const;

  std::filesystem::path folder_;
  UsdStage stage_;
  std::size_t one_file_;          // bytes
  std::size_t bytes_ = 0;         // of all values so far
  int first_ = 0, written_ = -1;  // frames; written_: the last one that scene.usda refers to
  std::vector<Frame> frames_;     // all of a run that is short so far; else the last one
};

}  // namespace meniscus::io
