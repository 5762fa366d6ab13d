// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Adds gates and figures to the result of a case.
#include "sdk/validation/case.h"

#include <utility>

namespace meniscus::validation {

WorldDef Settings::world(float spacing) const {
  WorldDef def;
  def.device = device;
  def.threads = threads;
  def.particle_spacing = spacing;
  return def;
}

void Result::at_most(std::string name, std::string unit, double value, double most, Bar bar,
                     std::string reason) {
  within(std::move(name), std::move(unit), value, 0, most, bar, std::move(reason));
}

void Result::about_zero(std::string name, std::string unit, double deviation, double most, Bar bar,
                        std::string reason) {
  within(std::move(name), std::move(unit), deviation, -most, most, bar, std::move(reason));
}

void Result::within(std::string name, std::string unit, double value, double low, double high, Bar bar,
                    std::string reason) {
  gates.push_back({std::move(name), std::move(unit), value, low, high, bar, std::move(reason)});
}

void Result::tell(std::string name, std::string unit, double value) {
  figures.push_back({std::move(name), std::move(unit), value});
}

}  // namespace meniscus::validation
