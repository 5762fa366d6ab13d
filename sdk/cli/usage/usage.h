// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The commands and options of the program as plain data, for completion and for messages.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace meniscus::cli {

/// What a value of an option or an argument may be.
enum class ValueKind {
  none,    ///< a flag
  words,   ///< one of OptionUsage::words
  scene,   ///< the name of a sample, or a file
  file,    ///< any file
  folder,  ///< any folder
  other    ///< such as a number
};

struct OptionUsage {
  std::vector<std::string> names{};  ///< with their dashes; an argument has none
  std::string description{};
  ValueKind kind = ValueKind::none;
  std::vector<std::string> words{};
  bool list = false;        ///< several words, with commas between them
  bool by_equals = false;   ///< the value may be left out, and stands only behind a '='
  bool repeatable = false;  ///< may be given several times

  /// Whether the word behind the option is its value.
  bool takes_next() const { return kind != ValueKind::none && !by_equals; }
};

struct VerbUsage {
  std::string name, description;
  std::vector<OptionUsage> options, arguments;
};

struct Usage {
  std::vector<OptionUsage> options;  ///< without a command
  std::vector<VerbUsage> verbs;

  /// Null where there is none of this name.
  const VerbUsage* verb(const std::string& name) const;
  std::vector<std::string> verb_names() const;
};

/// Reads what an app declares. Kinds of values follow from the names of their types: `a|b` and `a,b` are
/// words, SCENE is a scene, FILE a file, DIR a folder.
Usage usage_of(const CLI::App& app);

/// All names of options, with their dashes.
std::vector<std::string> names_in(const std::vector<OptionUsage>& options);

/// Moves the command before the options that stand in front of it. `arguments` are without the program's
/// name.
std::vector<std::string> verb_first(const Usage& usage, std::vector<std::string> arguments);

/// The message about a word that neither a command nor an option takes, with the nearest name. `verb` is
/// empty where no command was named.
std::string unknown_argument(const Usage& usage, const std::string& verb, const std::string& word);

}  // namespace meniscus::cli
