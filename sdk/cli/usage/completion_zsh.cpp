// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The completion of zsh.
#include <spdlog/fmt/fmt.h>

#include "sdk/cli/usage/completion.h"

namespace meniscus::cli {
namespace {

constexpr const char* start = R"zsh(#compdef meniscus
# Completion of meniscus for zsh, as `meniscus completion zsh` writes it.

_meniscus_scenes() {
  local -a samples
  samples=(${(f)"$($meniscus_program samples 2>/dev/null)"})
  _alternative 'samples:sample:compadd -a samples' 'files:scene file:_files -g "*.json"'
}

_meniscus() {
  local context state state_descr line meniscus_program=$words[1]
  local -a commands
  typeset -A opt_args
)zsh";

/// In the brackets of _arguments.
std::string description_of(const OptionUsage& option) {
  std::string text;
  for (const char c : option.description) {
    if (c == '[' || c == ']' || c == '\\') text += '\\';
    text += c;
  }
  return text;
}

std::string action_of(const OptionUsage& option) {
  switch (option.kind) {
    case ValueKind::words:
      return option.list ? fmt::format("_values -s , value {}", spaced(option.words))
                         : fmt::format("({})", spaced(option.words));
    case ValueKind::scene:
      return "_meniscus_scenes";
    case ValueKind::file:
      return "_files";
    case ValueKind::folder:
      return "_files -/";
    case ValueKind::none:
    case ValueKind::other:
      break;
  }
  return " ";
}

std::string option_specs(const OptionUsage& option) {
  std::string text;
  for (const std::string& name : option.names) {
    std::string spec = option.repeatable ? "*" : "";
    spec += name;
    if (option.kind != ValueKind::none) spec += option.by_equals ? "=-" : name.starts_with("--") ? "=" : "+";
    spec += fmt::format("[{}]", description_of(option));
    if (option.kind != ValueKind::none)
      spec += std::string(option.by_equals ? "::" : ":") + "value:" + action_of(option);
    text += " \\\n          " + shell_quoted(spec);
  }
  return text;
}

std::string verb_case(const VerbUsage& verb) {
  std::string specs;
  for (const OptionUsage& option : verb.options) specs += option_specs(option);
  for (const OptionUsage& argument : verb.arguments)
    specs += " \\\n          " + shell_quoted(":argument:" + action_of(argument));
  return fmt::format("        {})\n          _arguments{}\n          ;;\n", verb.name, specs);
}

}  // namespace

std::string zsh_completion(const Usage& usage) {
  std::string specs;
  for (const OptionUsage& option : usage.options) specs += option_specs(option);
  std::string text = start;
  text += "  _arguments -C" + specs +
          " \\\n          '1:command:->command' '*::argument:->argument'\n"
          "  case $state in\n    command)\n      commands=(\n";
  for (const VerbUsage& verb : usage.verbs)
    text += "        " + shell_quoted(verb.name + ":" + verb.description) + "\n";
  text += "      )\n      _describe command commands\n      ;;\n    argument)\n      case $words[1] in\n";
  for (const VerbUsage& verb : usage.verbs) text += verb_case(verb);
  return text +
         "      esac\n      ;;\n  esac\n}\n\n"
         "# From a folder of $fpath, or read by source.\n"
         "if [[ $funcstack[1] == _meniscus ]]; then\n  _meniscus \"$@\"\n"
         "else\n  compdef _meniscus meniscus\nfi\n";
}

}  // namespace meniscus::cli
