// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The words in which errors of C++ and of scene files say what a rule allows.
#include "sdk/fields/rule.h"

#include <cmath>
#include <sstream>

namespace meniscus {
namespace {

std::string number_text(double x) {
  std::ostringstream out;
  out.precision(10);
  out << x;
  return out.str();
}

}  // namespace

std::string range_text(const FieldRule& rule) {
  const bool low = std::isfinite(rule.low), high = std::isfinite(rule.high);
  std::string text;
  if (low) text = (rule.above_low ? "greater than " : "at least ") + number_text(rule.low);
  if (low && high) text += " and ";
  if (high) text += (rule.below_high ? "less than " : "at most ") + number_text(rule.high);
  return text;
}

}  // namespace meniscus
