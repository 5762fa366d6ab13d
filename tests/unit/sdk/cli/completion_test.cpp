// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the completion scripts, each in its shell.
#include <gtest/gtest.h>

#include <cstdio>
#include <regex>
#include <set>

#include "tests/unit/sdk/cli/program_fixture.h"

namespace meniscus::cli {
namespace {

class CompletionTest : public ProgramTest {
 protected:
  /// The lines that a script for a shell prints, or a skipped test without that shell. The script has the
  /// completion in $1.
  std::set<std::string> lines_of(const std::string& shell, const std::string& script) {
    const fs::path completion = folder_ / ("completion." + shell), file = folder_ / "script";
    std::ofstream(completion) << printed({"completion", shell});
    std::ofstream(file) << script;
    const std::string options = shell == "fish" ? " --no-config " : shell == "zsh" ? " -f " : " --norc ";
    const std::string command = "cd " + folder_.string() + " && " + shell + options + file.string() + " " +
                                completion.string() + " 2>&1";
    FILE* pipe = popen(command.c_str(), "r");
    std::string text;
    for (int c; (c = std::fgetc(pipe)) != EOF;) text += static_cast<char>(c);
    pclose(pipe);
    std::istringstream stream(text);
    std::set<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.insert(line.substr(0, line.find('\t')));
    return lines;
  }
  static bool is_here(const std::string& shell) {
    return std::system(("command -v " + shell + " >/dev/null").c_str()) == 0;
  }

  std::set<std::string> of_bash(const std::string& words) {
    return lines_of("bash", "source $1\nCOMP_WORDS=(" + words +
                                ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_meniscus\n"
                                "printf '%s\\n' \"${COMPREPLY[@]}\"\n");
  }
  std::set<std::string> of_fish(const std::string& line) {
    return lines_of("fish", "source $argv[1]\ncomplete -C '" + line + "'\n");
  }
};

using Words = std::set<std::string>;

TEST_F(CompletionTest, EachScriptKnowsEachOptionOfTheHelp) {
  const std::regex option("--[a-z][a-z-]*");
  for (const char* shell : {"bash", "zsh", "fish"}) {
    const std::string script = printed({"completion", shell});
    for (const char* verb : {"run", "view", "check", "compare", "devices", "samples"}) {
      EXPECT_NE(script.find(verb), std::string::npos) << shell << " " << verb;
      std::string help = printed({verb, "--help"});
      for (std::smatch found; std::regex_search(help, found, option); help = found.suffix()) {
        const std::string name = found.str();
        const std::string written = shell == std::string("fish") ? "-l " + name.substr(2) : name;
        EXPECT_NE(script.find(written), std::string::npos) << shell << " " << verb << " " << name;
      }
    }
  }
}

TEST_F(CompletionTest, BashCompletesCommandsOptionsAndValues) {
  if (!is_here("bash")) GTEST_SKIP() << "bash is not here";
  EXPECT_EQ(of_bash("meniscus co"), (Words{"compare", "completion"}));
  EXPECT_EQ(of_bash("meniscus run --fra"), (Words{"--frames"}));
  EXPECT_EQ(of_bash("meniscus run drop --device c"), (Words{"cpu", "cuda"}));
  EXPECT_EQ(of_bash("meniscus run drop --device = cu"), (Words{"cuda"}));
  EXPECT_EQ(of_bash("meniscus run drop --render = ''"), (Words{"frames", "last", "auto"}));
  EXPECT_EQ(of_bash("meniscus run drop --export ply,vt"), (Words{"ply,vtp"}));
  EXPECT_EQ(of_bash("meniscus run drop --frames ''"), (Words{""})) << "a number";
  EXPECT_EQ(of_bash("meniscus check dr"), (Words{"drop.json"})) << "a file here";
  EXPECT_EQ(of_bash("meniscus completion z"), (Words{"zsh"}));
  fs::create_directories(folder_ / "results");
  EXPECT_EQ(of_bash("meniscus run drop --out re"), (Words{"results"}));
}

TEST_F(CompletionTest, BashAsksTheProgramForTheSamples) {
  if (!is_here("bash")) GTEST_SKIP() << "bash is not here";
  write("program", "#!/bin/sh\n[ \"$1\" = samples ] && printf 'tank\\nwheel\\n'\n");
  fs::permissions(folder_ / "program", fs::perms::owner_all);
  EXPECT_EQ(of_bash("./program run wh"), (Words{"wheel"}));
  EXPECT_EQ(printed({"samples"}), "drop\nflag\nraft\n");
}

TEST_F(CompletionTest, FishCompletesCommandsOptionsAndValues) {
  if (!is_here("fish")) GTEST_SKIP() << "fish is not here";
  EXPECT_EQ(of_fish("meniscus comp"), (Words{"compare", "completion"}));
  EXPECT_EQ(of_fish("meniscus run --fra"), (Words{"--frames"}));
  EXPECT_EQ(of_fish("meniscus run drop --device c"), (Words{"cpu", "cuda"}));
  EXPECT_EQ(of_fish("meniscus run drop --render=l"), (Words{"--render=last"}));
  EXPECT_EQ(of_fish("meniscus run drop --export ply,vt"), (Words{"ply,vtp"}));
  EXPECT_EQ(of_fish("meniscus completion z"), (Words{"zsh"}));
}

TEST_F(CompletionTest, ZshTakesItsScript) {
  if (!is_here("zsh")) GTEST_SKIP() << "zsh is not here";
  // zsh completes on a terminal alone, so what its own functions are told takes their place.
  EXPECT_EQ(lines_of("zsh",
                     "compdef() { print compdef $* }\n_arguments() { print -l -- $* }\nsource $1\n"
                     "words=(run)\nstate=argument\n_arguments() { state=argument; print -l -- $* }\n"
                     "_meniscus\n")
                .count("--device=[Where to run; by default what the scene says]:value:(auto cpu cuda)"),
            1u);
}

}  // namespace
}  // namespace meniscus::cli
