// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Walks over CBOR without recursion.
#include "sdk/world/recording/check_cbor.h"

#include <meniscus/error.h>

#include <string>
#include <vector>

namespace meniscus::call_text {

namespace {

[[noreturn]] void refuse(const char* why) {
  throw Error(ErrorCode::io, std::string("a call of the recording is not valid: it ") + why);
}

/// The major types of RFC 8949, section 3.1, that calls have.
enum Major : uint8_t { bytes_of = 2, text = 3, list = 4, object = 5, tag = 6, simple = 7 };

class Walk {
 public:
  explicit Walk(std::span<const uint8_t> bytes) : left_(bytes) {}

  void item() {
    const uint8_t first = take(1)[0], major = first >> 5, info = first & 31;
    if (info > 27) refuse("has an item without a definite length");
    if (major == tag) refuse("has a tag");
    const uint64_t value = info < 24 ? info : number(std::size_t{1} << (info - 24));
    if (major == bytes_of || major == text) take(value);
    if (major == list || major == object) open(value, major == object ? 2 : 1);
  }
  /// Whether an item is still to come.
  bool goes_on() {
    while (!open_.empty() && open_.back() == 0) open_.pop_back();
    if (open_.empty()) return false;
    --open_.back();
    return true;
  }
  void end() const {
    if (!left_.empty()) refuse("goes on after its end");
  }

 private:
  std::span<const uint8_t> take(uint64_t count) {
    if (count > left_.size()) refuse("ends within an item");
    const auto taken = left_.first(count);
    left_ = left_.subspan(count);
    return taken;
  }
  /// Big-endian.
  uint64_t number(std::size_t size) {
    uint64_t value = 0;
    for (const uint8_t byte : take(size)) value = value << 8 | byte;
    return value;
  }
  /// Each item takes at least one byte.
  void open(uint64_t count, uint64_t items_each) {
    if (count > left_.size() / items_each) refuse("ends within a list");
    if (open_.size() == max_depth) refuse("is nested too deep");
    open_.push_back(count * items_each);
  }

  std::span<const uint8_t> left_;
  std::vector<uint64_t> open_;  // items that are to come, by depth
};

}  // namespace

void check_cbor(std::span<const uint8_t> bytes) {
  Walk walk(bytes);
  do walk.item();
  while (walk.goes_on());
  walk.end();
}

}  // namespace meniscus::call_text
