// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The visitor of fields() that finds a member by its path.
#include "sdk/c/member.h"

#include <charconv>

#include "sdk/fields/fields.h"
#include "sdk/scene/closest_name.h"

namespace meniscus::c {
namespace {

/// Whether a type is that of an id.
template <class T>
constexpr bool is_id = kind_of<T> != MENISCUS_NONE;

template <class T>
constexpr bool is_plain_list =
    std::is_same_v<T, std::vector<float>> || std::is_same_v<T, std::vector<Vec3>> ||
    std::is_same_v<T, std::vector<uint32_t>>;

/// Takes `name` off the front of "name.rest" or "name[0]".
std::string_view take_name(std::string_view& rest) {
  if (!rest.empty() && rest.front() == '.') rest.remove_prefix(1);
  const std::string_view name = rest.substr(0, rest.find_first_of(".["));
  rest.remove_prefix(name.size());
  return name;
}

template <class T>
void visit_value(Search& search, T& value, std::string_view rest);

/// Looks for one name among the members of a struct.
class MemberFinder {
 public:
  static constexpr bool of_members = true;

  MemberFinder(Search& search, std::string_view rest)
      : search_(search), name_(take_name(rest)), rest_(rest) {}

  template <class T>
  void operator()(const char* name, T& value, const FieldRule& rule, const char*, const char*) {
    if (rule.key_only) return;
    names_.emplace_back(name);
    if (name_ != name) return;
    is_found_ = true;
    visit_value(search_, value, rest_);
  }
  template <class T>
  void flat(const char* name, T& part) {
    (*this)(name, part, any_value, "", "");
  }
  template <class... Subject>
  void check(bool, const std::string&, const Subject&...) const {}

  void finish() const {
    if (is_found_) return;
    search_.fail(
        "there is no member \"" + std::string(name_) + "\"; " + name_hint(std::string(name_), names_),
        ErrorCode::not_found);
  }

 private:
  Search& search_;
  std::string_view name_, rest_;
  std::vector<std::string> names_;
  bool is_found_ = false;
};

template <class T>
void visit_members(Search& search, T& value, std::string_view rest) {
  if (rest.empty()) search.fail("has members; name one of them");
  MemberFinder finder(search, rest);
  fields(finder, value);
  finder.finish();
}

/// Lists the alternatives of a variant, or goes on in that which it holds.
struct ChoiceFinder {
  Search& search;
  std::string_view rest;
  WordRef words{};

  template <class T, class Whole>
  void choice(const char* name, T value, Whole& whole, const char*) {
    T* const held = std::get_if<T>(&whole);
    if (!rest.empty()) {
      if (held) visit_members(search, *held, rest);
      return;
    }
    if (held) words.current = words.words.size();
    words.words.push_back(name);
    words.choose.push_back([&whole, value] { whole = value; });
  }
};

template <class E>
WordRef words_of(E& value) {
  WordRef ref;
  for (const Named<E>& named : names_of(value)) {
    if (named.value == value) ref.current = ref.words.size();
    ref.words.push_back(named.name);
    ref.choose.push_back([&value, chosen = named.value] { value = chosen; });
  }
  return ref;
}

template <class T>
void visit_optional(Search& search, std::optional<T>& value, std::string_view rest) {
  if (rest.empty() && search.wants_size()) {
    search.found = SizeRef{value ? 1u : 0u, [&value, &search](std::size_t count) {
                             if (count > 1) search.fail("is optional, and holds at most one value");
                             if (count == 0) value.reset();
                             if (count == 1 && !value) value.emplace();
                           }};
    return;
  }
  if (!value) {
    if (!search.writes()) search.fail("has no value", ErrorCode::not_found);
    search.undo.push_back([&value] { value.reset(); });
    value.emplace();
  }
  visit_value(search, *value, rest);
}

template <class T>
void visit_list(Search& search, std::vector<T>& values, std::string_view rest) {
  if (rest.empty() && search.wants_size()) {
    search.found = SizeRef{values.size(), [&values](std::size_t count) { values.resize(count); }};
  } else if (rest.empty()) {
    if constexpr (is_plain_list<std::vector<T>>)
      search.found = &values;
    else
      search.fail("is a list; name an item, as in [0]");
  } else {
    std::size_t item = 0;
    const char* const end = rest.data() + rest.size();
    const auto [after, error] = std::from_chars(rest.data() + 1, end, item);
    if (rest.front() != '[' || error != std::errc{} || after == end || *after != ']')
      search.fail("is a list; name an item, as in [0]");
    if (item >= values.size())
      search.fail("the list has " + std::to_string(values.size()) + " items, counted from 0",
                  ErrorCode::not_found);
    rest.remove_prefix(std::size_t(after + 1 - rest.data()));
    visit_value(search, values[item], rest);
  }
}

template <class T>
void visit_leaf(Search& search, T& value, std::string_view rest) {
  if (!rest.empty()) search.fail("the path goes on behind a single value", ErrorCode::not_found);
  if constexpr (HasNames<T>)
    search.found = words_of(value);
  else if constexpr (is_id<T>)
    search.found = IdRef{in_c(value), [&value](MeniscusId id) { value = in_cpp<T>(id); }};
  else
    search.found = &value;
}

template <class T>
void visit_value(Search& search, T& value, std::string_view rest) {
  if constexpr (IsOptional<T>::value) {
    visit_optional(search, value, rest);
  } else if constexpr (IsList<T>::value) {
    visit_list(search, value, rest);
  } else if constexpr (HasChoices<T>) {
    ChoiceFinder finder{search, rest};
    choices(finder, value);
    if (rest.empty()) search.found = std::move(finder.words);
  } else if constexpr (HasFields<T>) {
    visit_members(search, value, rest);
  } else {
    visit_leaf(search, value, rest);
  }
}

}  // namespace

Search::Search(AnyDef& def, const char* path, For what) : path_(&required(path, "path")), what_(what) {
  try {
    if (path_.empty()) fail("the path is empty");
    std::visit([&](auto& d) { visit_members(*this, d, path_); }, def);
    if (wants_size() && !std::holds_alternative<SizeRef>(found)) fail("is neither a list nor optional");
  } catch (...) {
    if (!undo.empty()) undo.front()();
    throw;
  }
}

Search::~Search() {
  // The first value that was given holds all later ones.
  if (!undo.empty()) undo.front()();
}

void Search::fail(const std::string& problem, ErrorCode code) const {
  throw Error(code, path_ + ": " + problem);
}

}  // namespace meniscus::c
