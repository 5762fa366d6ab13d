// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The completion of fish, and what the three shells share.
#include "sdk/cli/usage/completion.h"

namespace meniscus::cli {
namespace {

/// The action behind `complete`, with its values.
std::string values_of(const OptionUsage& option) {
  switch (option.kind) {
    case ValueKind::words:
      return option.list ? " -x -a \"(__fish_append , " + spaced(option.words) + ")\""
                         : " -x -a " + shell_quoted(spaced(option.words));
    case ValueKind::scene:
      return " -r -F -k -a '(__meniscus_samples)'";
    case ValueKind::file:
      return " -r -F";
    case ValueKind::folder:
      return " -x -a '(__fish_complete_directories)'";
    case ValueKind::other:
      return " -x";
    case ValueKind::none:
      break;
  }
  return "";
}

std::string names_of(const OptionUsage& option) {
  std::string text;
  for (const std::string& name : option.names)
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  return text;
}

/// An optional value has entries of its own, with the '='.
std::string option_lines(const std::string& complete, const OptionUsage& option) {
  const std::string description = " -d " + shell_quoted(option.description);
  if (!option.by_equals) return complete + names_of(option) + values_of(option) + description + "\n";
  std::string text = complete + names_of(option) + description + "\n";
  for (const std::string& name : option.names) {
    std::string words;
    for (const std::string& word : option.words) words += (words.empty() ? "" : " ") + name + "=" + word;
    text += complete + " -a " + shell_quoted(words) + description + "\n";
  }
  return text;
}

}  // namespace

std::string fish_completion(const Usage& usage) {
  std::string text =
      "# Completion of meniscus for fish, as `meniscus completion fish` writes it.\n\n"
      "function __meniscus_samples\n"
      "  set -l words (commandline -opc)\n"
      "  command -q $words[1]; and $words[1] samples 2>/dev/null\n"
      "end\n\n"
      "complete -c meniscus -f\n";
  for (const OptionUsage& option : usage.options)
    text += option_lines("complete -c meniscus -n __fish_use_subcommand", option);
  for (const VerbUsage& verb : usage.verbs) {
    text += "complete -c meniscus -n __fish_use_subcommand -a " + verb.name + " -d " +
            shell_quoted(verb.description) + "\n";
  }
  for (const VerbUsage& verb : usage.verbs) {
    const std::string complete = "complete -c meniscus -n '__fish_seen_subcommand_from " + verb.name + "'";
    for (const OptionUsage& option : verb.options) text += option_lines(complete, option);
    for (const OptionUsage& argument : verb.arguments) {
      if (argument.kind == ValueKind::scene) {
        text += complete + " -F -a '(__meniscus_samples)'\n";
      } else if (argument.kind == ValueKind::words) {
        text += complete + " -a " + shell_quoted(spaced(argument.words)) + "\n";
      }
    }
  }
  return text;
}

std::string shell_quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "'\"'\"'" : std::string(1, c);
  return quoted + "'";
}

std::string spaced(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

}  // namespace meniscus::cli
