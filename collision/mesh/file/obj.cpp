// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Checks OBJ files before assimp reads them.
#include "collision/mesh/file/obj.h"

#include <array>
#include <cstdint>
#include <string>

#include "collision/mesh/file/defect.h"
#include "collision/mesh/file/tuning.h"

namespace meniscus::collision {

namespace {

class ObjCheck {
 public:
  explicit ObjCheck(std::string_view text) : lines_(text) {}

  void run() {
    while (!lines_.at_end()) {
      ++line_;
      read_line(Words(next_line()));
    }
    // A face may stand before its vertices. So numbers are compared when all are known.
    for (size_t kind = 0; kind < count_.size(); ++kind) {
      if (most_named_[kind] > count_[kind]) {
        refuse(line_of_most_[kind], "names " + what(kind) + " " + std::to_string(most_named_[kind]) + " of " +
                                        std::to_string(count_[kind]));
      }
    }
  }

 private:
  static constexpr size_t position = 0, texture = 1, normal = 2;

  static std::string what(size_t kind) {
    constexpr std::array<const char*, 3> names{"vertex", "texture coordinate", "normal"};
    return names[kind];
  }

  /// A line; a backslash at its end joins the next one to it.
  std::string_view next_line() {
    std::string_view line = lines_.line();
    if (!line.ends_with('\\')) return line;
    joined_.clear();
    for (;;) {
      const bool goes_on = line.ends_with('\\');
      joined_ += line.substr(0, line.size() - goes_on);
      joined_ += ' ';
      if (!goes_on || lines_.at_end()) return joined_;
      ++line_;
      line = lines_.line();
    }
  }

  void read_line(Words words) {
    const std::string_view key = words.next();
    if (key == "v") {
      read_numbers(words, 3);
      ++count_[position];
    } else if (key == "vt") {
      read_numbers(words, 1);
      ++count_[texture];
    } else if (key == "vn") {
      read_numbers(words, 3);
      ++count_[normal];
    } else if (key == "f" || key == "l" || key == "p") {
      read_corners(words);
    } else if (key == "o" || key == "g" || key == "usemtl") {
      if (++parts_ > mesh_file_tuning::most_parts)
        refuse(line_, "begins one of more than " + std::to_string(mesh_file_tuning::most_parts) + " parts");
    }
  }

  void read_numbers(Words& words, int least) const {
    for (int i = 0; i < least; ++i) {
      const std::string_view word = words.next();
      if (!number_of<double>(word)) refuse(line_, "has " + in_quotes(word) + " in place of a number");
    }
  }

  void read_corners(Words& words) {
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
      if (word.starts_with('#')) return;
      for (size_t kind = 0; kind < 3 && !word.empty(); ++kind) {
        const size_t slash = std::min(word.find('/'), word.size());
        read_corner(word.substr(0, slash), kind);
        word.remove_prefix(std::min(slash + 1, word.size()));
      }
    }
  }

  void read_corner(std::string_view number, size_t kind) {
    if (number.empty() && kind > 0) return;  // as in 1//2
    const auto value = number_of<int64_t>(number);
    if (!value || *value == 0)
      refuse(line_, "has " + in_quotes(number) + " in place of the number of a vertex");
    const auto present = static_cast<int64_t>(count_[kind]);
    if (*value < -present) {
      refuse(line_, "names the last " + what(kind) + " but " + std::to_string(-(*value + 1)) + ", of " +
                        std::to_string(present));
    }
    if (*value <= 0 || static_cast<uint64_t>(*value) <= most_named_[kind]) return;
    most_named_[kind] = static_cast<uint64_t>(*value);
    line_of_most_[kind] = line_;
  }

  [[noreturn]] static void refuse(size_t line, const std::string& why) {
    throw FileDefect("is not valid: line " + std::to_string(line) + " " + why);
  }

  Words lines_;
  std::string joined_;
  size_t line_ = 0, parts_ = 0;
  std::array<uint64_t, 3> count_{}, most_named_{};
  std::array<size_t, 3> line_of_most_{};
};

}  // namespace

void check_obj(std::string_view bytes) {
  if (bytes.find('\0') != std::string_view::npos) throw FileDefect("has a byte 0, and so is not text");
  ObjCheck(bytes).run();
}

}  // namespace meniscus::collision
