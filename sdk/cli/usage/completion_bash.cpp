// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The completion of bash.
#include <spdlog/fmt/fmt.h>

#include "sdk/cli/usage/completion.h"

namespace meniscus::cli {
namespace {

constexpr const char* start =
    R"bash(# Completion of meniscus for bash, as `meniscus completion bash` writes it.

_meniscus_words() {
  mapfile -t COMPREPLY < <(IFS=$' \t\n'; compgen -W "$1" -- "$word")
}

# Words with commas between them: the last one is completed.
_meniscus_list() {
  local before=
  [[ $word == *,* ]] && before=${word%,*},
  mapfile -t COMPREPLY < <(IFS=$' \t\n'; compgen -P "$before" -W "$1" -- "${word##*,}")
}

_meniscus_files() {
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen "$1" -- "$word")
}

_meniscus_scenes() {
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(
    IFS=$' \t\n'
    compgen -W "$("${COMP_WORDS[0]}" samples 2>/dev/null)" -- "$word"
    compgen -f -X '!*.json' -- "$word"
    compgen -d -- "$word"
  )
}

_meniscus() {
  local word=${COMP_WORDS[COMP_CWORD]} option=${COMP_WORDS[COMP_CWORD - 1]} verb='' i
  # bash takes --option=value apart.
  if [[ $word == = ]]; then
    word=''
    option+==
  elif [[ $option == = ]]; then
    option=${COMP_WORDS[COMP_CWORD - 2]}=
  fi
  COMPREPLY=()
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case ${COMP_WORDS[i]} in
)bash";

std::string action_of(const OptionUsage& option) {
  switch (option.kind) {
    case ValueKind::words:
      return (option.list ? "_meniscus_list " : "_meniscus_words ") + shell_quoted(spaced(option.words));
    case ValueKind::scene:
      return "_meniscus_scenes";
    case ValueKind::file:
      return "_meniscus_files -f";
    case ValueKind::folder:
      return "_meniscus_files -d";
    case ValueKind::none:
    case ValueKind::other:
      break;
  }
  return "";
}  // namespace meniscus::cli

/// The case of an option behind which the cursor is.
std::string value_case(const VerbUsage& verb, const OptionUsage& option) {
  std::string pattern;
  for (const std::string& name : option.names) {
    if (!option.by_equals) pattern += (pattern.empty() ? "" : " | ") + verb.name + ":" + name;
    pattern += (pattern.empty() ? "" : " | ") + verb.name + ":" + name + "=";
  }
  const std::string action = action_of(option);
  return fmt::format("    {})\n{}      return\n      ;;\n", pattern,
                     action.empty() ? "" : "      " + action + "\n");
}

std::string verb_case(const VerbUsage& verb) {
  std::string text = fmt::format("    {})\n      if [[ $word == -* ]]; then\n        _meniscus_words {}\n",
                                 verb.name, shell_quoted(spaced(names_in(verb.options))));
  if (!verb.arguments.empty()) {
    if (const std::string action = action_of(verb.arguments.front()); !action.empty())
      text += "      else\n        " + action + "\n";
  }
  return text + "      fi\n      ;;\n";
}

}  // namespace

std::string bash_completion(const Usage& usage) {
  std::string verbs;
  for (const VerbUsage& verb : usage.verbs) verbs += (verbs.empty() ? "" : " | ") + verb.name;
  std::string text = start;
  text +=
      "      " + verbs + ")\n        verb=${COMP_WORDS[i]}\n        break\n        ;;\n    esac\n  done\n";
  text += "  case $verb:$option in\n";
  for (const VerbUsage& verb : usage.verbs) {
    for (const OptionUsage& option : verb.options) {
      if (option.kind != ValueKind::none) text += value_case(verb, option);
    }
  }
  std::vector<std::string> first = usage.verb_names();
  for (const std::string& name : names_in(usage.options)) first.push_back(name);
  text += "  esac\n  case $verb in\n    '') _meniscus_words " + shell_quoted(spaced(first)) + " ;;\n";
  for (const VerbUsage& verb : usage.verbs) text += verb_case(verb);
  return text + "  esac\n}\n\ncomplete -F _meniscus meniscus\n";
}

}  // namespace meniscus::cli
