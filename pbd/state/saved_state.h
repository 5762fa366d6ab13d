// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Items of state in memory, on the host or on a device, and the visitors that save and restore them.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "pbd/device/buffer.h"
#include "pbd/state/state_visitor.h"

namespace meniscus::pbd {

/// One item: its elements are in `host`, or in `device` where that has any.
struct StateItem {
  std::string form;  ///< see ElementForm
  uint32_t element_bytes = 0;
  std::size_t count = 0;
  bool required = true;  ///< a program that does not know it must refuse it
  std::vector<std::byte> host{};
  std::unique_ptr<Buffer<std::byte>> device{};

  std::size_t bytes() const { return count * element_bytes; }
};

/// Items by their paths, in the order in which they were saved.
class SavedState {
 public:
  /// Throws Error(io) if there is one of that name.
  StateItem& add(const std::string& path, StateItem item);
  const StateItem* find(const std::string& path) const;
  const std::vector<std::string>& paths() const { return order_; }
  std::size_t device_bytes() const;
  /// Forgets the items. Items of the same paths that are added from now on take over their memory on the
  /// device.
  void start_over();
  /// The memory of an item before start_over(); null if there was none.
  std::unique_ptr<Buffer<std::byte>> take_memory(const std::string& path);
  /// Moves what is on a device to the host. From then on the device is not needed.
  void move_to_host();

 private:
  std::map<std::string, StateItem, std::less<>> items_;
  std::vector<std::string> order_;
  std::map<std::string, std::unique_ptr<Buffer<std::byte>>, std::less<>> spare_;
};

/// Where arrays are copied to.
enum class SavedTo { device, host };

/// Copies the state of parts to a SavedState.
class StateSaver final : public StateVisitor {
 public:
  StateSaver(Device& device, SavedState& to, SavedTo arrays) : device_(device), to_(to), arrays_(arrays) {}
  bool restores() const override { return false; }

 private:
  void visit_host(const std::string& path, const ElementForm& form, void* data, std::size_t count) override;
  void visit_device(const std::string& path, const ElementForm& form, void* data, std::size_t room,
                    std::size_t count) override;
  std::size_t count_of(const std::string& path) override;
  bool has(const std::string&) const override { return false; }

  Device& device_;
  SavedState& to_;
  SavedTo arrays_;
};

/// Copies a SavedState to parts. Throws Error(io) if an item is missing, has another form, or does not fit.
class StateRestorer final : public StateVisitor {
 public:
  StateRestorer(Device& device, const SavedState& from) : device_(device), from_(from) {}
  bool restores() const override { return true; }
  /// Throws Error(io) with the name of a required item that was not visited, if there is one.
  void expect_all_used() const;

 private:
  void visit_host(const std::string& path, const ElementForm& form, void* data, std::size_t count) override;
  void visit_device(const std::string& path, const ElementForm& form, void* data, std::size_t room,
                    std::size_t count) override;
  std::size_t count_of(const std::string& path) override;
  bool has(const std::string& path) const override { return from_.find(path) != nullptr; }
  const StateItem& item(const std::string& path, const ElementForm& form);

  Device& device_;
  const SavedState& from_;
  std::set<std::string, std::less<>> used_;
};

}  // namespace meniscus::pbd
