// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Recordings: files of all calls that changed a world, with which its run can be repeated.
#pragma once

#include <meniscus/outputs.h>
#include <meniscus/snapshot.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace meniscus {

class World;

/// A step that a replay has made again.
struct ReplayStep {
  StepReport report;           ///< of the step that was made now
  double time = 0;             ///< s, of the world after it
  uint64_t hash = 0;           ///< World::state_hash after it
  uint64_t recorded_hash = 0;  ///< the same in the run that was recorded
};

/// A recording that is read: see World::start_recording. start() makes the world, and each next() repeats the
/// calls up to the end of the next step.
///
/// For the same program and kind of device all hashes are equal, whatever the number of threads. On the other
/// kind the world continues within the usual difference of the devices. Hooks are in no recording: add them
/// to the world before the first next().
class Replay {
 public:
  /// Opens a file. Throws Error(io) if it is no recording, or of a version that this program does not know.
  explicit Replay(const std::string& path);
  ~Replay();                             ///< closes the file
  Replay(Replay&&) noexcept;             ///< takes another one, which is then of no use
  Replay& operator=(Replay&&) noexcept;  ///< likewise

  /// The world at the beginning of the recording. Throws as World::load does.
  World start(const LoadDef& def = {});
  /// Repeats calls on the world that start() made, to the end of the next step. Returns nothing at the end of
  /// the recording. Where the recorded world went back to a snapshot, `world` becomes a new one. Throws
  /// Error(io) if the file is damaged, and what a call throws.
  std::optional<ReplayStep> next(World& world);
  /// Whether next() has found the end that World::stop_recording wrote. A program that ended before it leaves
  /// a recording without one, which is good up to there.
  bool is_complete() const;
  const std::string& device() const;   ///< "cpu" or "cuda", of the recorded world
  const std::string& program() const;  ///< the version that recorded it

 private:
  struct Reader;
  std::unique_ptr<Reader> reader_;
};

}  // namespace meniscus
