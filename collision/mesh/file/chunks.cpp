// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Checks how the parts of 3DS and FBX files are nested, before assimp reads them.
#include "collision/mesh/file/chunks.h"

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "collision/mesh/file/defect.h"
#include "collision/mesh/file/tuning.h"

namespace meniscus::collision {

namespace {

template <class T>
T number_at(std::string_view bytes, size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

[[noreturn]] void refuse_depth() {
  throw FileDefect("is nested more than " + std::to_string(mesh_file_tuning::most_levels) + " levels deep");
}

// Those of text, in which a quote hides a brace, and a semicolon the rest of its line.
void check_braces(std::string_view text) {
  int depth = 0;
  bool is_quoted = false, is_comment = false;
  for (const char c : text) {
    if (c == '\n') is_comment = false;
    if (is_comment) continue;
    if (c == '"') is_quoted = !is_quoted;
    if (is_quoted) continue;
    if (c == ';') is_comment = true;
    if (c == '{' && ++depth > mesh_file_tuning::most_levels) refuse_depth();
    if (c == '}') --depth;
  }
}

/// The records of a binary FBX file. Each begins with where it ends.
class FbxRecords {
 public:
  explicit FbxRecords(std::string_view bytes)
      : bytes_(bytes), is_long_(number_at<uint32_t>(bytes, magic_size) >= first_long_version) {}

  void check() {
    std::vector<uint64_t> ends{bytes_.size()};
    for (uint64_t at = magic_size + 4; !ends.empty();) {
      if (at >= ends.back()) {
        ends.pop_back();
        continue;
      }
      const Record record = record_at(at, ends.back());
      if (record.end == 0) {  // closes the list; at the top, other data follows
        at = ends.size() == 1 ? bytes_.size() : ends.back();
        continue;
      }
      at = record.children;
      ends.push_back(record.end);
      if (static_cast<int>(ends.size()) > mesh_file_tuning::most_levels) refuse_depth();
    }
  }

 private:
  static constexpr size_t magic_size = 23;
  static constexpr uint32_t first_long_version = 7500;

  struct Record {
    uint64_t end, children;
  };

  Record record_at(uint64_t at, uint64_t limit) const {
    const uint64_t width = is_long_ ? 8 : 4, head = 3 * width + 1;
    if (limit - at < head) refuse(at);
    const auto number = [&](uint64_t k) {
      const uint64_t place = at + k * width;
      return is_long_ ? number_at<uint64_t>(bytes_, place) : number_at<uint32_t>(bytes_, place);
    };
    const uint64_t end = number(0), properties = number(2);
    const auto name = static_cast<unsigned char>(bytes_[at + 3 * width]);
    if (end == 0) return {0, 0};
    if (end > limit || end < at + head + name || properties > end - (at + head + name)) refuse(at);
    return {end, at + head + name + properties};
  }

  [[noreturn]] static void refuse(uint64_t at) {
    throw FileDefect("ends within its record at byte " + std::to_string(at));
  }

  std::string_view bytes_;
  bool is_long_;
};

}  // namespace

void check_fbx(std::string_view bytes) {
  constexpr std::string_view magic = "Kaydara FBX Binary";
  if (!bytes.starts_with(magic)) return check_braces(bytes);
  if (bytes.size() < 27) throw FileDefect("ends within its header");
  FbxRecords(bytes).check();
}

void check_three_ds(std::string_view bytes) {
  constexpr size_t head = 6;
  // Only the outermost chunks are alike in all files. assimp bounds those within by them.
  for (size_t at = 0; at < bytes.size();) {
    const size_t left = bytes.size() - at;
    const uint64_t size = left < head ? 0 : number_at<uint32_t>(bytes, at + 2);
    if (size < head || size > left) throw FileDefect("ends within its chunk at byte " + std::to_string(at));
    at += size;
  }
}

}  // namespace meniscus::collision
