// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds the name that a mistyped one is closest to.
#include "sdk/scene/closest_name.h"

#include <algorithm>
#include <numeric>

namespace meniscus {
namespace {

/// Levenshtein's distance: how many letters to insert, remove or change.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
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
