// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The exit codes of the program.
#pragma once

namespace meniscus::cli {

/// What the program hands back to the shell.
enum ExitCode {
  success = 0,
  run_failed = 1,     ///< the device, or a step, or an output in the middle of a run
  bad_input = 2,      ///< the command line, or a scene, or an output folder that cannot be used
  check_broken = 3,   ///< the run is done, but what the scene states did not hold
  interrupted = 130,  ///< by SIGINT or SIGTERM, as shells count it
};

}  // namespace meniscus::cli
