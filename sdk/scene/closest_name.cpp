// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds the name that a mistyped one is closest to.
#include "sdk/scene/closest_name.h"

#include <algorithm>
#include <numeric>

namespace meniscus {
namespace {

/// How many letters to insert, remove, change, or exchange with the next one (optimal string alignment).
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(before, last);
    std::swap(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j - 1] + (a[i - 1] != b[j - 1]), last[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row.back();
}

std::string quoted_list(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "\"" : ", \"") + name + "\"";
  return text.empty() ? "none" : text;
}

}  // namespace

std::string name_hint(const std::string& unknown, const std::vector<std::string>& known) {
  constexpr std::size_t longest_word = 64;  // longer is no slip of the finger, and not worth the search
  const std::string* best = nullptr;
  std::size_t best_distance = unknown.size() / 4 + 2;  // a slip or two, more in a long word
  for (const std::string& name : known) {
    if (unknown.size() > longest_word) break;
    const std::size_t distance = edit_distance(unknown, name);
    if (distance >= best_distance) continue;
    best = &name;
    best_distance = distance;
  }
  return best ? "did you mean \"" + *best + "\"?" : "allowed: " + quoted_list(known);
}

}  // namespace meniscus
