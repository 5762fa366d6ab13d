// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Definitions of C: makes, sets and reads them.
#include <cmath>
#include <limits>
#include <memory>

#include "sdk/c/member.h"
#include "sdk/scene/closest_name.h"

namespace meniscus::c {
namespace {

using For = Search::For;

/// Makes the definition of a kind by its number among the alternatives.
template <std::size_t number = 0>
AnyDef default_def(std::size_t kind) {
  if constexpr (number < std::variant_size_v<AnyDef>) {
    return kind == number ? AnyDef(std::in_place_index<number>) : default_def<number + 1>(kind);
  } else {
    throw Error(ErrorCode::invalid_argument, "kind is " + std::to_string(kind) + "; it must be at most " +
                                                 std::to_string(std::variant_size_v<AnyDef> - 1));
  }
}

template <class Whole>
Whole whole_number(const Search& search, double x) {
  constexpr std::numeric_limits<Whole> limits;
  if (!(x >= limits.min() && x <= limits.max() && x == std::floor(x)))
    search.fail("must be a whole number of 32 bits");
  return static_cast<Whole>(x);
}

void set_number(const Search& search, double value) {
  if (auto* const* real = std::get_if<float*>(&search.found)) {
    if (std::isfinite(value) && std::fabs(value) > double{std::numeric_limits<float>::max()})
      search.fail("must be a number of single precision");
    **real = static_cast<float>(value);
  } else if (auto* const* whole = std::get_if<int*>(&search.found)) {
    **whole = whole_number<int>(search, value);
  } else if (auto* const* natural = std::get_if<uint32_t*>(&search.found)) {
    **natural = whole_number<uint32_t>(search, value);
  } else {
    search.fail("is no number");
  }
}

void set_word(const Search& search, const WordRef& ref, const std::string& word) {
  for (std::size_t i = 0; i < ref.words.size(); ++i) {
    if (ref.words[i] == word) return ref.choose[i]();
  }
  search.fail("\"" + word + "\" is not known; " + name_hint(word, {ref.words.begin(), ref.words.end()}));
}

/// The member, which must be of this type.
template <class T>
T& member_of(Search& search, const char* type) {
  if (T* const* const found = std::get_if<T*>(&search.found)) return **found;
  search.fail(std::string("is no ") + type);
}

/// Finds a member and changes it, or else changes nothing.
template <class Change>
MeniscusStatus change(MeniscusDef* def, const char* path, const Change& change_it, For what = For::write) {
  return guarded([&] {
    Search search(required(def, "def").def, path, what);
    change_it(search);
    search.commit();
  });
}

/// Finds a member and reads it. A search to read changes nothing.
template <class Read>
MeniscusStatus read(const MeniscusDef* def, const char* path, const Read& read_it, For what = For::read) {
  return guarded([&] {
    Search search(const_cast<MeniscusDef&>(required(def, "def")).def, path, what);
    read_it(search);
  });
}

template <class T, class From>
MeniscusStatus set_list(MeniscusDef* def, const char* path, const From* values, std::size_t count,
                        const char* type) {
  return change(def, path, [&](Search& search) {
    const T* const first = same_layout<T>(required_array(values, count, "values"));
    member_of<std::vector<T>>(search, type) = std::vector<T>(first, first + count);
  });
}

template <class T, class To>
MeniscusStatus get_list(const MeniscusDef* def, const char* path, const To** values, std::size_t* count,
                        const char* type) {
  return read(def, path,
              [&](Search& search) { write_same(values, count, member_of<std::vector<T>>(search, type)); });
}

}  // namespace
}  // namespace meniscus::c

using namespace meniscus::c;
using meniscus::Quat;
using meniscus::Vec3;

MeniscusStatus meniscus_def_create(MeniscusDefKind kind, MeniscusDef** def) {
  return guarded([&] {
    MeniscusDef*& out = required(def, "def");
    out = std::make_unique<MeniscusDef>(MeniscusDef{default_def(static_cast<std::size_t>(kind))}).release();
  });
}

MeniscusStatus meniscus_def_copy(const MeniscusDef* def, MeniscusDef** copy) {
  return guarded([&] {
    MeniscusDef*& out = required(copy, "copy");
    out = std::make_unique<MeniscusDef>(required(def, "def")).release();
  });
}

void meniscus_def_destroy(MeniscusDef* def) {
  delete def;
}

MeniscusStatus meniscus_def_set_number(MeniscusDef* def, const char* path, double value) {
  return change(def, path, [&](const Search& search) { set_number(search, value); });
}

MeniscusStatus meniscus_def_set_flag(MeniscusDef* def, const char* path, int value) {
  return change(def, path, [&](Search& search) { member_of<bool>(search, "flag") = value != 0; });
}

MeniscusStatus meniscus_def_set_text(MeniscusDef* def, const char* path, const char* value) {
  return change(def, path, [&](Search& search) {
    const std::string text = &required(value, "value");
    if (const auto* ref = std::get_if<WordRef>(&search.found)) return set_word(search, *ref, text);
    member_of<std::string>(search, "text") = text;
  });
}

MeniscusStatus meniscus_def_set_vector(MeniscusDef* def, const char* path, MeniscusVec3 value) {
  return change(def, path, [&](Search& search) { member_of<Vec3>(search, "vector") = in_cpp(value); });
}

MeniscusStatus meniscus_def_set_rotation(MeniscusDef* def, const char* path, MeniscusQuat value) {
  return change(def, path, [&](Search& search) { member_of<Quat>(search, "rotation") = in_cpp(value); });
}

MeniscusStatus meniscus_def_set_id(MeniscusDef* def, const char* path, MeniscusId value) {
  return change(def, path, [&](Search& search) {
    const auto* const ref = std::get_if<IdRef>(&search.found);
    if (!ref) search.fail("is no id");
    ref->set(value);
  });
}

MeniscusStatus meniscus_def_set_numbers(MeniscusDef* def, const char* path, const float* values,
                                        size_t count) {
  return set_list<float>(def, path, values, count, "list of numbers");
}

MeniscusStatus meniscus_def_set_vectors(MeniscusDef* def, const char* path, const MeniscusVec3* values,
                                        size_t count) {
  return set_list<Vec3>(def, path, values, count, "list of vectors");
}

MeniscusStatus meniscus_def_set_indices(MeniscusDef* def, const char* path, const uint32_t* values,
                                        size_t count) {
  return set_list<uint32_t>(def, path, values, count, "list of whole numbers");
}

MeniscusStatus meniscus_def_resize(MeniscusDef* def, const char* path, size_t count) {
  return change(
      def, path, [&](const Search& search) { std::get<SizeRef>(search.found).resize(count); },
      For::write_size);
}

MeniscusStatus meniscus_def_get_number(const MeniscusDef* def, const char* path, double* value) {
  return read(def, path, [&](const Search& search) {
    double& out = required(value, "value");
    if (auto* const* real = std::get_if<float*>(&search.found))
      out = double{**real};
    else if (auto* const* whole = std::get_if<int*>(&search.found))
      out = **whole;
    else if (auto* const* natural = std::get_if<uint32_t*>(&search.found))
      out = **natural;
    else
      search.fail("is no number");
  });
}

MeniscusStatus meniscus_def_get_flag(const MeniscusDef* def, const char* path, int* value) {
  return read(def, path,
              [&](Search& search) { required(value, "value") = member_of<bool>(search, "flag") ? 1 : 0; });
}

MeniscusStatus meniscus_def_get_text(const MeniscusDef* def, const char* path, const char** value) {
  return read(def, path, [&](Search& search) {
    const char*& out = required(value, "value");
    if (const auto* ref = std::get_if<WordRef>(&search.found))
      out = ref->words.at(ref->current);
    else
      out = member_of<std::string>(search, "text").c_str();
  });
}

MeniscusStatus meniscus_def_get_vector(const MeniscusDef* def, const char* path, MeniscusVec3* value) {
  return read(def, path,
              [&](Search& search) { required(value, "value") = in_c(member_of<Vec3>(search, "vector")); });
}

MeniscusStatus meniscus_def_get_rotation(const MeniscusDef* def, const char* path, MeniscusQuat* value) {
  return read(def, path,
              [&](Search& search) { required(value, "value") = in_c(member_of<Quat>(search, "rotation")); });
}

MeniscusStatus meniscus_def_get_id(const MeniscusDef* def, const char* path, MeniscusId* value) {
  return read(def, path, [&](const Search& search) {
    const auto* const ref = std::get_if<IdRef>(&search.found);
    if (!ref) search.fail("is no id");
    required(value, "value") = ref->id;
  });
}

MeniscusStatus meniscus_def_get_numbers(const MeniscusDef* def, const char* path, const float** values,
                                        size_t* count) {
  return get_list<float>(def, path, values, count, "list of numbers");
}

MeniscusStatus meniscus_def_get_vectors(const MeniscusDef* def, const char* path, const MeniscusVec3** values,
                                        size_t* count) {
  return get_list<Vec3>(def, path, values, count, "list of vectors");
}

MeniscusStatus meniscus_def_get_indices(const MeniscusDef* def, const char* path, const uint32_t** values,
                                        size_t* count) {
  return get_list<uint32_t>(def, path, values, count, "list of whole numbers");
}

MeniscusStatus meniscus_def_get_count(const MeniscusDef* def, const char* path, size_t* count) {
  return read(
      def, path,
      [&](const Search& search) { required(count, "count") = std::get<SizeRef>(search.found).size; },
      For::read_size);
}
