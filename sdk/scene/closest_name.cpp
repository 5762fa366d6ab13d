// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds the name that a mistyped one is closest to.
#include "sdk/scene/closest_name.h"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace meniscus {
namespace {

std::string in_lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

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

/// Of two names in lower case. The beginning of a name is near to it, however long the rest.
std::size_t distance_between(const std::string& unknown, const std::string& known) {
  constexpr std::size_t telling = 4;  // letters
  if (unknown.size() >= telling && known.starts_with(unknown))
    return std::min(known.size() - unknown.size(), std::size_t{1});
  return edit_distance(unknown, known);
}

}  // namespace

std::string name_hint(const std::string& unknown, const std::vector<std::string>& known) {
  constexpr std::size_t longest_word = 64;  // longer is no slip of the finger, and not worth the search
  const std::string* best = nullptr;
  const std::string written = in_lower_case(unknown);
  std::size_t best_distance =
      written.size() < 3 ? 1 : (written.size() + 3) / 4 + 1;  // a slip in each four letters
  for (const std::string& name : known) {
    if (unknown.size() > longest_word) break;
    const std::size_t distance = distance_between(written, in_lower_case(name));
    if (distance >= best_distance) continue;
    best = &name;
    best_distance = distance;
  }
  return best ? "did you mean \"" + *best + "\"?" : "allowed: " + quoted_list(known);
}

}  // namespace meniscus
