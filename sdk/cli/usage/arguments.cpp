// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Orders the words of a command line, and finds what a mistyped one was to be.
#include <algorithm>

#include "sdk/cli/usage/usage.h"
#include "sdk/scene/closest_name.h"

namespace meniscus::cli {
namespace {

/// Whether some command has an option of this name whose value is the next word.
bool takes_next(const Usage& usage, const std::string& name) {
  const auto has = [&](const VerbUsage& verb) {
    return std::any_of(verb.options.begin(), verb.options.end(), [&](const OptionUsage& option) {
      return option.takes_next() && std::count(option.names.begin(), option.names.end(), name) > 0;
    });
  };
  return std::any_of(usage.verbs.begin(), usage.verbs.end(), has);
}

}  // namespace

const VerbUsage* Usage::verb(const std::string& name) const {
  const auto found = std::find_if(verbs.begin(), verbs.end(), [&](const auto& v) { return v.name == name; });
  return found == verbs.end() ? nullptr : &*found;
}

std::vector<std::string> Usage::verb_names() const {
  std::vector<std::string> names;
  for (const VerbUsage& verb : verbs) names.push_back(verb.name);
  return names;
}

std::vector<std::string> names_in(const std::vector<OptionUsage>& options) {
  std::vector<std::string> names;
  for (const OptionUsage& option : options)
    names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

std::vector<std::string> verb_first(const Usage& usage, std::vector<std::string> arguments) {
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i].starts_with('-')) {
      if (takes_next(usage, arguments[i])) ++i;
      continue;
    }
    const auto at = arguments.begin() + static_cast<std::ptrdiff_t>(i);
    if (usage.verb(*at)) std::rotate(arguments.begin(), at, at + 1);
    break;
  }
  return arguments;
}

std::string unknown_argument(const Usage& usage, const std::string& verb, const std::string& word) {
  const VerbUsage* known = usage.verb(verb);
  const std::string command = known ? "meniscus " + verb : "meniscus";
  if (word.starts_with('-')) {
    const std::string name = word.substr(0, word.find('='));
    return command + " has no option '" + name + "'; " +
           name_hint(name, names_in(known ? known->options : usage.options));
  }
  if (!known) return "there is no command '" + word + "'; " + name_hint(word, usage.verb_names());
  return command + " does not expect '" + word + "'";
}

}  // namespace meniscus::cli
