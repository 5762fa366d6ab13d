// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Makes classes, properties and signatures by the fields() of definitions.
#include "sdk/python/definitions.h"

#include <meniscus/meniscus.h>

#include "sdk/python/bind_members.h"

namespace meniscus::python {

std::string bounds_text(const FieldRule& rule) {
  FieldRule shown = rule;
  shown.low *= double(unit_of(rule));
  shown.high *= double(unit_of(rule));
  return range_text(shown);
}

namespace {

template <class T>
void bind_struct(nb::module_& module);

struct ChoiceBinder {
  nb::module_& module;

  template <class T, class Whole>
  void choice(const char*, const T&, Whole&, const char*) {
    bind_struct<T>(module);
  }
};

/// Makes the classes that a member is made of.
template <class T>
void bind_type(nb::module_& module) {
  if constexpr (IsOptional<T>::value || IsList<T>::value) {
    bind_type<typename T::value_type>(module);
  } else if constexpr (std::is_same_v<T, BodyGeometry> || std::is_same_v<T, PartGeometry>) {
    Geometry geometry;
    T wrapped{geometry};
    ChoiceBinder binder{module};
    choices(binder, wrapped);
  } else if constexpr (HasChoices<T>) {
    T value{};
    ChoiceBinder binder{module};
    choices(binder, value);
  } else if constexpr (HasFields<T>) {
    bind_struct<T>(module);
  }
}

template <class T>
nb::dict members_of(const T& def) {
  nb::dict members;
  for_each_member(const_cast<T&>(def), [&](const char* key, auto& value, const FieldRule&, const char*,
                                           const char*) { members[key] = to_python(stored(value)); });
  return members;
}

template <class T>
std::string repr(const T& def) {
  std::string text;
  for (const auto& [key, value] : members_of(def))
    text += (text.empty() ? "" : ", ") + nb::cast<std::string>(key) + "=" +
            nb::cast<std::string>(nb::repr(value));
  return std::string(type_name<T>()) + "(" + text + ")";
}

/// A class whose objects do not change, like those of a frozen dataclass.
template <class T>
void bind_struct(nb::module_& module) {
  if (nb::type<T>().is_valid()) return;
  const std::string name(type_name<T>());
  const Description init =
      describe_call<T>("__init__", "None", "Makes a " + name + "; what is left out has its default.");
  nb::class_<T> type(module, name.c_str());
  type.def(
      "__init__",
      [](T* self, const nb::kwargs& given) {
        T def{};
        read_members(def, given, std::string(type_name<T>()));
        new (self) T(std::move(def));
      },
      nb::sig(init.signature.c_str()), init.doc.c_str());
  const Description replace =
      describe_call<T>("replace", name, "A copy in which these members are different.", true);
  type.def(
      "replace",
      [](const T& self, const nb::kwargs& given) {
        nb::dict members = members_of(self);
        members.update(given);
        T def{};
        read_members(def, members, std::string(type_name<T>()) + ".replace");
        return def;
      },
      nb::sig(replace.signature.c_str()), "A copy in which these members are different.");
  type.def("__repr__", [](const T& self) { return repr(self); });
  type.def(
      "__eq__",
      [](const T& self, nb::handle other) {
        return nb::isinstance<T>(other) && repr(self) == repr(*nb::cast<const T*>(other));
      },
      nb::arg("other").none(), nb::sig("def __eq__(self, other: object, /) -> bool"));
  type.def("__hash__", [](const T& self) { return std::hash<std::string>()(repr(self)); });
  type.def(
      "__getstate__", [](const T& self) { return members_of(self); },
      nb::sig("def __getstate__(self) -> dict[str, typing.Any]"));
  type.def(
      "__setstate__",
      [](T& self, const nb::dict& members) {
        T def{};
        read_members(def, members, std::string(type_name<T>()));
        new (&self) T(std::move(def));
      },
      nb::sig("def __setstate__(self, members: dict[str, typing.Any], /) -> None"));
  T usual{};
  for_each_member(
      usual, [&](const char* key, auto& value, const FieldRule& rule, const char* unit, const char* meaning) {
        using Value = std::decay_t<decltype(value)>;
        using Stored = std::decay_t<decltype(stored(value))>;
        bind_type<Value>(module);
        const std::ptrdiff_t offset = offset_in(usual, &stored(value));
        const Description text{getter_text(key, value), member_doc(key, value, rule, unit, meaning)};
        type.def_prop_ro(
            key, [offset](T& self) { return to_python(member_at<Stored>(self, offset)); },
            nb::for_getter(nb::sig(text.signature.c_str())), text.doc.c_str());
      });
}

/// The classes of the members of a definition that is no class itself.
template <class D>
void bind_parts(nb::module_& module) {
  D def{};
  for_any_member(def, [&](const char*, auto& value, const FieldRule&, const char*, const char*) {
    bind_type<std::decay_t<decltype(value)>>(module);
  });
}

template <class... D>
struct Definitions {
  static void bind(nb::module_& module) { (bind_parts<D>(module), ...); }
};

using AllDefinitions = Definitions<WorldDef, FluidDef, GranularDef, ShapeDef, BodyDef, JointDef, ClothDef,
                                   RopeDef, AttachmentDef, WindDef, FluidVolumeDef, EmitterDef, SinkDef,
                                   ProbeDef, SurfaceMeshDef, ForceFieldDef>;

}  // namespace

void bind_definitions(nb::module_& module) {
  AllDefinitions::bind(module);
  bind_type<CollisionFilter>(module);
}

void bind_world_members(nb::class_<PyWorld>& type) {
  bind_members<WorldDef>(
      type, [](PyWorld& self) { return self.state->look([](World& w) { return w.def(); }); },
      [](PyWorld& self, const WorldDef& def) { self.state->change([&](World& w) { w.set_def(def); }); });
}

void bind_fluid_members(nb::class_<Handle<FluidId>>& type) {
  using Fluid = Handle<FluidId>;
  const auto def_of = [](Fluid& self) -> FluidDef& {
    auto* material = self.state->fluids.find(self.id);
    if (auto* def = material ? std::get_if<FluidDef>(material) : nullptr) return *def;
    throw nb::attribute_error("a granular material has no members that can change");
  };
  bind_members<FluidDef>(
      type, [def_of](Fluid& self) { return def_of(self); },
      [def_of](Fluid& self, const FluidDef& def) {
        self.state->change([&](World& w) { w.set_fluid(self.id, def); });
        def_of(self) = def;
      });
  const auto of_grains = [&](const char* name, float GranularDef::*member, const char* doc) {
    type.def_prop_ro(
        name,
        [member](Fluid& self) {
          const auto* material = self.state->fluids.find(self.id);
          if (const auto* def = material ? std::get_if<GranularDef>(material) : nullptr) return def->*member;
          throw nb::attribute_error("only a granular material has it");
        },
        nb::for_getter(nb::sig(("def " + std::string(name) + "(self) -> float").c_str())), doc);
  };
  of_grains("density", &GranularDef::density,
            "kg/m³, of a granular material: a grain's mass over a spacing cubed.");
  of_grains("friction", &GranularDef::friction,
            "Of a granular material: tangent of the angle at which a heap stands.");
}

void bind_force_field_members(nb::class_<Handle<ForceFieldId>>& type) {
  using Field = Handle<ForceFieldId>;
  const auto def_of = [](Field& self) -> ForceFieldDef& {
    if (ForceFieldDef* def = self.state->force_fields.find(self.id)) return *def;
    throw nb::attribute_error("the force field is destroyed");
  };
  bind_members<ForceFieldDef>(
      type, [def_of](Field& self) { return def_of(self); },
      [def_of](Field& self, const ForceFieldDef& def) {
        self.state->change([&](World& w) { w.set_force_field(self.id, def); });
        def_of(self) = def;
      });
}

}  // namespace meniscus::python
