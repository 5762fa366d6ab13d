// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Parts of a solver, ordered by named phases, in whatever order they are added.
#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace meniscus::pbd {

/// `Phase` is an enumeration without gaps from 0, which ends with `count`; phase_name(Phase) names its
/// values. Each phase takes exactly one part.
template <class Phase, class Part>
class Pipeline {
 public:
  /// Throws std::logic_error if the phase already has a part.
  Pipeline& place(Phase phase, Part& part) {
    Part*& at = parts_[static_cast<std::size_t>(phase)];
    if (at) throw std::logic_error(std::string("two parts for the phase ") + phase_name(phase));
    at = &part;
    return *this;
  }

  /// Calls visit(part) for each, in the order of the phases. Throws std::logic_error where one is missing.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      if (!parts_[k])
        throw std::logic_error(std::string("no part for the phase ") + phase_name(static_cast<Phase>(k)));
    }
    for (Part* part : parts_) visit(*part);
  }

 private:
  std::array<Part*, static_cast<std::size_t>(Phase::count)> parts_{};
};

}  // namespace meniscus::pbd
