// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The list of all cases.
#include "sdk/validation/cases/registry.h"

#include <meniscus/error.h>

#include <algorithm>

#include "sdk/scene/closest_name.h"
#include "sdk/validation/cases/cases.h"

namespace meniscus::validation {

const std::vector<Case>& all_cases() {
  static const std::vector<Case> cases{
      martin_moyce(), koshizuka_oka(),   marin(),        sloshing(),   hydrostatics(),
      torricelli(),   added_mass(),      couette(),      poiseuille(), taylor_green_vortices(),
      draft(),        neutral_density(), friction(),     catenary(),   elastica(),
      chain(),        membrane(),        elastic_gate(), drop(),
  };
  return cases;
}

const std::vector<std::string>& missing_cases() {
  static const std::vector<std::string> missing{
      "For MARIN's dam break there are no readings after 1.15 s here.",
  };
  return missing;
}

std::vector<Case> chosen_cases(const std::vector<std::string>& names) {
  if (names.empty()) return all_cases();
  std::vector<std::string> known;
  for (const Case& c : all_cases()) known.push_back(c.name);
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw Error(ErrorCode::invalid_argument,
                "there is no case of validation named \"" + name + "\"; " + name_hint(name, known));
  }
  std::vector<Case> chosen;
  for (const Case& c : all_cases()) {
    if (std::find(names.begin(), names.end(), c.name) != names.end()) chosen.push_back(c);
  }
  return chosen;
}

}  // namespace meniscus::validation
