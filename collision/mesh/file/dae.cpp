// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Checks Collada files before assimp reads them.
#include "collision/mesh/file/dae.h"

#include <cstdint>
#include <string>

#include "collision/mesh/file/defect.h"
#include "collision/mesh/file/xml.h"

namespace meniscus::collision {

namespace {

std::string_view attribute(const XmlTag& tag, std::string_view key) {
  const auto found = tag.attributes.find(key);
  return found == tag.attributes.end() ? std::string_view() : found->second;
}

/// A count that an attribute gives, or `absent`.
uint64_t count_of(const XmlTag& tag, std::string_view key, uint64_t absent) {
  const std::string_view text = attribute(tag, key);
  if (text.empty()) return absent;
  const auto value = number_of<uint32_t>(text);
  if (!value) {
    throw FileDefect("has " + in_quotes(text) + " in place of the " + std::string(key) + " of an element " +
                     in_quotes(tag.name));
  }
  return *value;
}

template <class Number>
uint64_t numbers_in(const XmlTag& tag) {
  Words words(tag.text);
  uint64_t count = 0;
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (!number_of<Number>(word))
      throw FileDefect("has " + in_quotes(word) + " among the numbers of an element " + in_quotes(tag.name));
    ++count;
  }
  return count;
}

class DaeCheck {
 public:
  explicit DaeCheck(uint64_t file_size) : file_size_(file_size) {}

  void take(const XmlTag& tag) {
    if (!tag.opens) return;
    for (const char* key : {"count", "stride", "offset"}) {
      if (count_of(tag, key, 0) > file_size_)
        throw FileDefect("promises more in an element " + in_quotes(tag.name) + " than it has bytes");
    }
    if (tag.name == "float_array") take_array(tag);
    if (tag.name == "accessor") check_accessor(tag);
    if (tag.name == "p" || tag.name == "vcount" || tag.name == "v" || tag.name == "h")
      numbers_in<int64_t>(tag);
    if (tag.name == "matrix" || tag.name == "translate" || tag.name == "rotate" || tag.name == "scale" ||
        tag.name == "lookat" || tag.name == "skew")
      numbers_in<double>(tag);
  }

 private:
  void take_array(const XmlTag& tag) {
    const uint64_t count = numbers_in<double>(tag);
    if (attribute(tag, "count").empty() || count_of(tag, "count", 0) != count) {
      throw FileDefect("promises " + in_quotes(attribute(tag, "count")) + " numbers in its list " +
                       in_quotes(attribute(tag, "id")) + ", and has " + std::to_string(count));
    }
    lengths_[attribute(tag, "id")] = count;
  }

  void check_accessor(const XmlTag& tag) const {
    std::string_view source = attribute(tag, "source");
    source.remove_prefix(source.starts_with('#') ? 1 : 0);
    const auto list = lengths_.find(source);
    if (list == lengths_.end()) return;  // of names
    const uint64_t needed =
        count_of(tag, "offset", 0) + count_of(tag, "count", 0) * count_of(tag, "stride", 1);
    if (needed <= list->second) return;
    throw FileDefect("has an accessor of " + std::to_string(needed) + " numbers of its list " +
                     in_quotes(source) + ", which has " + std::to_string(list->second));
  }

  uint64_t file_size_;
  std::map<std::string_view, uint64_t> lengths_;  ///< of lists of numbers, by their id
};

}  // namespace

void check_dae(std::string_view bytes) {
  if (bytes.find('\0') != std::string_view::npos) throw FileDefect("has a byte 0, and so is not text");
  XmlTags tags(bytes);
  DaeCheck check(bytes.size());
  while (const auto tag = tags.next()) check.take(*tag);
}

}  // namespace meniscus::collision
