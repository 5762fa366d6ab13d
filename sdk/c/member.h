// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds a member of a definition by its path.
#pragma once

#include <meniscus/c/base.h>
#include <meniscus/types.h>

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sdk/c/handles.h"

namespace meniscus::c {

/// An enumerator, or the alternative of a variant.
struct WordRef {
  std::vector<const char*> words;
  std::vector<std::function<void()>> choose;  ///< for each word
  std::size_t current = 0;
};

/// The id of another object.
struct IdRef {
  MeniscusId id;
  std::function<void(MeniscusId)> set;
};

/// The length of a list, or of an optional member.
struct SizeRef {
  std::size_t size;
  std::function<void(std::size_t)> resize;
};

using Member =
    std::variant<std::monostate, float*, int*, uint32_t*, bool*, std::string*, Vec3*, Quat*,
                 std::vector<float>*, std::vector<Vec3>*, std::vector<uint32_t>*, WordRef, IdRef, SizeRef>;

/// A search for a member. A search to write gives optional members on the path a value. It takes these values
/// away again unless the change is committed.
class Search {
 public:
  enum class For { read, write, read_size, write_size };

  /// Throws Error(not_found) and Error(invalid_argument).
  Search(AnyDef& def, const char* path, For what);
  ~Search();
  Search(const Search&) = delete;
  Search& operator=(const Search&) = delete;

  Member found;

  void commit() { undo.clear(); }
  [[noreturn]] void fail(const std::string& problem, ErrorCode code = ErrorCode::invalid_argument) const;

  // What the visitors of the definition use.
  bool writes() const { return what_ == For::write || what_ == For::write_size; }
  bool wants_size() const { return what_ == For::read_size || what_ == For::write_size; }
  std::vector<std::function<void()>> undo;

 private:
  std::string path_;
  For what_;
};

}  // namespace meniscus::c
