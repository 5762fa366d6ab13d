// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads what moves prims from OpenUSD files in text form.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meniscus::motion {

/// One operation of a transform, such as xformOp:rotateXYZ.
struct UsdaOp {
  std::string type;                                 ///< of its values, such as double3
  std::optional<std::vector<double>> fixed{};       ///< its value without samples
  std::map<double, std::vector<double>> samples{};  ///< by time code
};

struct UsdaPrim {
  std::string name;
  int parent = -1;  ///< its number; -1: none
  std::map<std::string, UsdaOp> ops{};
  std::vector<std::string> order{};  ///< xformOpOrder: the outermost operation first

  bool moves() const;
};

struct UsdaLayer {
  double time_codes_per_second = 24;  ///< the fallbacks of OpenUSD
  double metres_per_unit = 0.01;
  std::vector<UsdaPrim> prims{};  ///< parents before children

  std::string path_of(int prim) const;  ///< as /World/Arm
};

/// Reads the prims of a layer, their transforms, and its units. All else is skipped, and takes no memory.
/// Throws FileDefect, with the line, for text that is not understood, and for prims more than 256 deep.
UsdaLayer read_usda(std::string_view text);

}  // namespace meniscus::motion
