// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads the commands and options that a CLI11 app declares.
#include "sdk/cli/usage/usage.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

namespace meniscus::cli {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, separator);) words.push_back(word);
  return words;
}

bool is_word(const std::string& text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](char c) { return (c >= 'a' && c <= 'z') || c == '-'; });
}

/// `a|b` and `a,b` are words; placeholders are in capitals.
void set_value(OptionUsage& option, std::string type) {
  option.by_equals = type.starts_with('=');
  if (option.by_equals) type.erase(0, 1);
  option.list = type.find(',') != std::string::npos;
  option.words = split(type, option.list ? ',' : '|');
  if (!std::all_of(option.words.begin(), option.words.end(), is_word)) option.words.clear();
  option.kind = !option.words.empty()      ? ValueKind::words
                : type == "SCENE"          ? ValueKind::scene
                : type == "DIR"            ? ValueKind::folder
                : type.starts_with("FILE") ? ValueKind::file
                                           : ValueKind::other;
}

OptionUsage option_usage(const CLI::Option& option) {
  OptionUsage usage{.description = option.get_description()};
  for (const std::string& name : option.get_snames()) usage.names.push_back(std::string("-").append(name));
  for (const std::string& name : option.get_lnames()) usage.names.push_back(std::string("--").append(name));
  usage.repeatable = option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
  const std::string type = option.get_type_name();
  if (option.get_items_expected_max() > 0 || type.starts_with('=')) set_value(usage, type);
  return usage;
}

void add_options(const CLI::App& app, std::vector<OptionUsage>& options,
                 std::vector<OptionUsage>& arguments) {
  for (const CLI::Option* option : app.get_options())
    (option->nonpositional() ? options : arguments).push_back(option_usage(*option));
}

}  // namespace

Usage usage_of(const CLI::App& app) {
  Usage usage;
  std::vector<OptionUsage> none;
  add_options(app, usage.options, none);
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    usage.verbs.push_back({verb->get_name(), verb->get_description(), {}, {}});
    add_options(*verb, usage.verbs.back().options, usage.verbs.back().arguments);
  }
  return usage;
}

}  // namespace meniscus::cli
