// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The visitor of fields() that lists the members of a definition.
#include <meniscus/c/defs.h>

#include <functional>
#include <memory>

#include "sdk/c/handles.h"
#include "sdk/fields/fields.h"

namespace meniscus::c {
namespace {

using Use = std::function<void(const MeniscusMember&)>;

/// The description of a member.
struct Text {
  FieldRule rule{};
  const char* unit = "";
  const char* meaning = "";
  bool is_optional = false;
};

/// The type of a value without members of its own.
template <class T>
constexpr MeniscusMemberType leaf_type() {
  if constexpr (HasNames<T>) return MENISCUS_WORD;
  if constexpr (kind_of<T> != MENISCUS_NONE) return MENISCUS_ID;
  if constexpr (std::is_same_v<T, float>) return MENISCUS_NUMBER;
  if constexpr (std::is_same_v<T, int> || std::is_same_v<T, uint32_t>) return MENISCUS_WHOLE_NUMBER;
  if constexpr (std::is_same_v<T, bool>) return MENISCUS_FLAG;
  if constexpr (std::is_same_v<T, Vec3>) return MENISCUS_VECTOR;
  if constexpr (std::is_same_v<T, Quat>) return MENISCUS_ROTATION;
  if constexpr (std::is_same_v<T, std::vector<float>>) return MENISCUS_NUMBERS;
  if constexpr (std::is_same_v<T, std::vector<Vec3>>) return MENISCUS_VECTORS;
  if constexpr (std::is_same_v<T, std::vector<uint32_t>>) return MENISCUS_INDICES;
  return MENISCUS_TEXT;
}

/// Lists what is below a path.
class Lister {
 public:
  static constexpr bool of_members = true;

  Lister(std::string path, std::string needs, const Use& use)
      : path_(std::move(path)), needs_(std::move(needs)), use_(use) {}

  template <class T>
  void operator()(const char* name, T& value, const FieldRule& rule, const char* unit, const char* meaning) {
    if (rule.key_only) return;
    Lister inner(path_.empty() ? name : path_ + "." + name, needs_, use_);
    inner.list(value, {rule, unit, meaning});
  }
  template <class T>
  void flat(const char* name, T& part) {
    (*this)(name, part, any_value, "", "");
  }
  template <class... Subject>
  void check(bool, const std::string&, const Subject&...) const {}

  template <class T>
  void list_members(T& def) {
    if constexpr (std::is_same_v<T, ProbeDef>) {
      list_probes(def);
    } else {
      fields(*this, def);
    }
  }

 private:
  template <class T>
  void list(T& value, Text text) {
    if constexpr (IsOptional<T>::value) {
      typename T::value_type held{};
      text.is_optional = true;
      list(held, text);
    } else if constexpr (HasChoices<T>) {
      list_choices(value, text);
    } else if constexpr (HasFields<T>) {
      if (text.is_optional) emit(MENISCUS_LIST, text);
      list_members(value);
    } else if constexpr (IsList<T>::value && leaf_type<T>() == MENISCUS_TEXT) {
      emit(MENISCUS_LIST, text);
      typename T::value_type item{};
      Lister(path_ + "[0]", needs_, use_).list(item, {});
    } else if constexpr (HasNames<T>) {
      std::string words;
      for (const auto& named : names_of(value)) words += (words.empty() ? "" : ",") + std::string(named.name);
      emit(MENISCUS_WORD, text, words);
    } else {
      emit(leaf_type<T>(), text);
    }
  }

  /// Gathers the words of a variant.
  struct Words {
    std::string words{};
    template <class T, class Whole>
    void choice(const char* name, const T&, Whole&, const char*) {
      words += (words.empty() ? "" : ",") + std::string(name);
    }
  };

  /// Lists the members of each alternative.
  struct Alternatives {
    const Lister& owner;
    template <class T, class Whole>
    void choice(const char* name, T value, Whole&, const char*) {
      Lister(owner.path_, owner.needs_ + owner.path_ + "=" + name + ";", owner.use_).list_members(value);
    }
  };

  template <class T>
  void list_choices(T& value, const Text& text) {
    Words words;
    choices(words, value);
    emit(MENISCUS_CHOICE, text, words.words);
    Alternatives alternatives{*this};
    choices(alternatives, value);
  }

  /// Which members a probe has depends on its kind.
  void list_probes(ProbeDef& def) {
    for (const auto& named : names_of(ProbeKind{})) {
      def.kind = named.value;
      Lister of_kind(path_, needs_ + "kind=" + named.name + ";", use_);
      fields(of_kind, def);
    }
  }

  void emit(MeniscusMemberType type, const Text& text, const std::string& words = "") const {
    const double unit = double{unit_of(text.rule)};
    use_({sizeof(MeniscusMember), static_cast<uint32_t>(type), path_.c_str(), needs_.c_str(),
          text.rule.in_degrees ? "rad" : text.unit, text.meaning, words.c_str(), text.rule.low * unit,
          text.rule.high * unit, text.is_optional ? 1 : 0});
  }

  std::string path_, needs_;
  const Use& use_;
};

}  // namespace
}  // namespace meniscus::c

using namespace meniscus::c;

MeniscusStatus meniscus_def_members(MeniscusDefKind kind,
                                    void (*use)(const MeniscusMember* member, void* user), void* user) {
  return guarded([&] {
    required(use, "use");
    MeniscusDef* created = nullptr;
    if (meniscus_def_create(kind, &created) != MENISCUS_OK)
      throw meniscus::Error(meniscus::ErrorCode::invalid_argument, meniscus_last_error());
    const std::unique_ptr<MeniscusDef> def(created);
    const Use call = [&](const MeniscusMember& member) { use(&member, user); };
    std::visit([&](auto& d) { Lister("", "", call).list_members(d); }, def->def);
  });
}
