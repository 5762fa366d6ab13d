// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A USD stage as a tree of prims: what holds for all times, and which attributes have a value a frame.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace meniscus::io {

/// An attribute with a value a frame.
struct UsdVarying {
  std::string declaration;    ///< type and name, as in "point3f[] points"
  std::string metadata{};     ///< as in `interpolation = "vertex"`
  bool interpolates = false;  ///< whether values between two frames count, as those of a transform
};

/// A prim: a node of the stage.
struct UsdPrim {
  std::string type, name;
  std::vector<std::string> metadata{};    ///< as in `kind = "group"`
  std::vector<std::string> attributes{};  ///< statements that hold for all times
  std::vector<std::size_t> varying{};     ///< numbers of attributes in UsdStage::varying
  std::vector<UsdPrim> children{};
};

/// A stage. Time codes are numbers of frames.
struct UsdStage {
  UsdPrim root;
  std::vector<UsdVarying> varying{};
  double frames_a_second = 24;
  char up_axis = 'Y';

  /// Declares an attribute of a prim with a value a frame; returns its number.
  std::size_t vary(UsdPrim& prim, UsdVarying attribute);
};

/// Receives pieces of text, one after another.
using UsdSink = std::function<void(std::string_view)>;
/// Writes the samples of an attribute by its number, as in "0: [], 1: [], ".
using UsdSamples = std::function<void(const UsdSink& out, std::size_t number)>;

/// The head of a layer: unit, axis, time. `more`: further statements.
std::string usd_head(const UsdStage& stage, int first_frame, int last_frame, const std::string& more = {});
/// All prims, with what holds for all times. Without samples, attributes with a value a frame are declared
/// alone.
void write_prims(const UsdSink& out, const UsdStage& stage, const UsdSamples& samples = {});
/// What has a value a frame alone, over prims that are defined elsewhere. Without samples it is declared.
void write_overs(const UsdSink& out, const UsdStage& stage, const UsdSamples& samples = {});

}  // namespace meniscus::io
