// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The command `meniscus reproduce`.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace meniscus::cli {

struct ReproduceOptions {
  std::string paper;  ///< "pbf"
  std::string device;
  std::optional<int> threads;      ///< of the CPU device
  double scale = 1;                ///< particles, as a fraction of the paper's
  double seconds = 4;              ///< of simulated time, of each run
  bool quick = false;              ///< a hundredth of the particles and a second
  std::vector<std::string> parts;  ///< names of parts; empty: all
  std::string armadillo;           ///< mesh file; empty: a ball of the same volume stands in
  double minutes = 0;              ///< limit on the wall clock; 0: none
  std::string output;              ///< folder; empty: out/pbf
  std::string page;                ///< a second place for the page; empty: none
  std::string commit;              ///< what the page says that the build is from
};

/// The names of all parts, in their order.
std::vector<std::string> reproduce_parts();

/// Repeats the measurements of Macklin & Müller 2013 and writes pbf.md, with its pictures and figures beside
/// it. What is done stays written if the command ends early. Throws Error.
int reproduce_paper(const ReproduceOptions& options);

}  // namespace meniscus::cli
