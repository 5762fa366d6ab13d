// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Snapshot: the state of a world at one moment, to go back to.
#pragma once

#include <meniscus/defs.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

namespace meniscus {

/// The whole state of a world at one moment, made by World::snapshot. Its arrays stay on the world's device.
/// A copy shares them. It may outlive its world, but is then of no use.
class Snapshot {
 public:
  Snapshot() = default;  ///< of no world

  bool empty() const { return !data_; }  ///< holds no state
  double time() const;                   ///< s, of the world at that moment; 0 if it is empty
  std::size_t device_bytes() const;      ///< held on the device

  struct Data;  ///< for the library alone

 private:
  friend class World;
  explicit Snapshot(std::shared_ptr<Data> data) : data_(std::move(data)) {}

  std::shared_ptr<Data> data_;
};

/// How World::load makes its world.
struct LoadDef {
  std::optional<DeviceChoice> device{};  ///< left out, the choice with which the saved world was made
  std::optional<int> threads{};          ///< of the CPU device, 0 to 1024; left out, as the saved world
  std::optional<int> cuda_device{};      ///< WorldDef::cuda_device; left out, as the saved world
  void* cuda_stream = nullptr;           ///< WorldDef::cuda_stream
  FileReader read_file{};                ///< WorldDef::read_file, which is in no file; a clone keeps its own
  LogSink log{};                         ///< WorldDef::log, likewise
  ParallelFor parallel_for{};            ///< WorldDef::parallel_for, likewise, if its world is on the CPU
};

}  // namespace meniscus
