// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The exit codes of the program.
#pragma once

namespace meniscus::cli {

/// The exit codes that the program returns to the shell.
enum ExitCode {
  success = 0,
  run_failed = 1,     ///< the device, a step, or an output failed during a run
  bad_input = 2,      ///< the command line, a scene or an output folder cannot be used
  check_broken = 3,   ///< the run is complete, but a check of the scene failed
  interrupted = 130,  ///< by SIGINT or SIGTERM, in the convention of shells
};

}  // namespace meniscus::cli
