// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The entry point of the program `meniscus`.
#include "sdk/cli/program.h"

int main(int argc, char** argv) {
  return meniscus::cli::run_program(argc, argv);
}
