// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Items of state in memory, and the visitors that save and restore them.
#include "pbd/state/saved_state.h"

#include <meniscus/error.h>

#include <cstring>
#include <utility>

namespace meniscus::pbd {

namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw Error(ErrorCode::io, "the saved item \"" + path + "\" " + why);
}

StateItem item_of(const ElementForm& form, std::size_t count) {
  return {.form = form.word, .element_bytes = form.bytes, .count = count};
}

}  // namespace

StateItem& SavedState::add(const std::string& path, StateItem item) {
  const auto [place, is_new] = items_.try_emplace(path, std::move(item));
  if (!is_new) refuse(path, "is there twice");
  order_.push_back(path);
  return place->second;
}

void SavedState::start_over() {
  for (auto& [path, item] : items_)
    if (item.device) spare_[path] = std::move(item.device);
  items_.clear();
  order_.clear();
}

std::unique_ptr<Buffer<std::byte>> SavedState::take_memory(const std::string& path) {
  const auto place = spare_.find(path);
  return place == spare_.end() ? nullptr : std::move(place->second);
}

const StateItem* SavedState::find(const std::string& path) const {
  const auto place = items_.find(path);
  return place == items_.end() ? nullptr : &place->second;
}

std::size_t SavedState::device_bytes() const {
  std::size_t sum = 0;
  for (const auto& [path, item] : items_) sum += item.device ? item.bytes() : 0;
  return sum;
}

void SavedState::move_to_host() {
  for (auto& [path, item] : items_) {
    if (!item.device) continue;
    item.host = item.device->read(item.bytes());
    item.device.reset();
  }
}

void StateSaver::visit_host(const std::string& path, const ElementForm& form, void* data, std::size_t count) {
  StateItem item = item_of(form, count);
  item.host.resize(item.bytes());
  if (count) std::memcpy(item.host.data(), data, item.bytes());
  to_.add(path, std::move(item));
}

void StateSaver::visit_device(const std::string& path, const ElementForm& form, void* data, std::size_t,
                              std::size_t count) {
  StateItem item = item_of(form, count);
  if (arrays_ == SavedTo::host) {
    item.host.resize(item.bytes());
    if (count) device_.copy_out(item.host.data(), data, item.bytes());
    to_.add(path, std::move(item));
    return;
  }
  item.device = to_.take_memory(path);
  if (!item.device) item.device = std::make_unique<Buffer<std::byte>>(device_, "snapshots");
  if (item.device->size() < item.bytes()) item.device->resize_discard(item.bytes());
  if (count) device_.copy(item.device->view().data, data, item.bytes());
  to_.add(path, std::move(item));
}

std::size_t StateSaver::count_of(const std::string&) {
  return 0;
}

void StateRestorer::expect_all_used() const {
  for (const std::string& path : from_.paths()) {
    if (!used_.contains(path) && from_.find(path)->required) refuse(path, "is not known to this program");
  }
}

const StateItem& StateRestorer::item(const std::string& path, const ElementForm& form) {
  const StateItem* const found = from_.find(path);
  if (!found) refuse(path, "is missing");
  if (found->form != form.word || found->element_bytes != form.bytes) {
    refuse(path, "has elements of the form " + found->form + " and of " +
                     std::to_string(found->element_bytes) + " bytes; this program has " + form.word + " of " +
                     std::to_string(form.bytes));
  }
  used_.insert(path);
  return *found;
}

std::size_t StateRestorer::count_of(const std::string& path) {
  const StateItem* const found = from_.find(path);
  if (!found) refuse(path, "is missing");
  used_.insert(path);
  return found->count;
}

void StateRestorer::visit_host(const std::string& path, const ElementForm& form, void* data,
                               std::size_t count) {
  const StateItem& from = item(path, form);
  if (from.count != count) {
    refuse(path,
           "has " + std::to_string(from.count) + " elements where the world has " + std::to_string(count));
  }
  if (count) std::memcpy(data, from.host.data(), from.bytes());
}

void StateRestorer::visit_device(const std::string& path, const ElementForm& form, void* data,
                                 std::size_t room, std::size_t) {
  const StateItem& from = item(path, form);
  if (from.count > room) {
    refuse(path, "has " + std::to_string(from.count) + " elements where the world has room for " +
                     std::to_string(room));
  }
  if (from.count == 0) return;
  if (from.device)
    device_.copy(data, from.device->view().data, from.bytes());
  else
    device_.copy_in(data, from.host.data(), from.bytes());
}

}  // namespace meniscus::pbd
