// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What all kinds of things in a world share: creation by keyword arguments, lists, names, destruction.
#pragma once

#include <string>

#include "sdk/python/values/describe.h"
#include "sdk/python/values/from_python.h"
#include "sdk/python/values/to_python.h"

namespace meniscus::python {

inline const std::string& name_of(const auto& def) {
  return def.name;
}
inline const std::string& name_of(const std::variant<FluidDef, GranularDef>& def) {
  return std::visit([](const auto& held) -> const std::string& { return held.name; }, def);
}

/// Makes the class of a kind, and the calls of World that list it and find it by name. `find` is the latter,
/// where it has another name than the kind.
template <class Id, class Def>
nb::class_<Handle<Id>> bind_thing(nb::module_& module, nb::class_<PyWorld>& world, const char* singular,
                                  const char* plural, Registry<Id, Def> Things::*registry,
                                  const char* find = nullptr) {
  using Thing = Handle<Id>;
  const std::string type_name = handle_name(Id{});
  nb::class_<Thing> type(module, type_name.c_str(), ("A " + std::string(singular) + " in a world.").c_str());
  type.def_prop_ro(
      "name",
      [registry](const Thing& self) {
        const Def* def = ((*self.state).*registry).find(self.id);
        return def ? name_of(*def) : std::string();
      },
      "Its name at its creation; empty once it is destroyed.");
  type.def(
      "__eq__",
      [](const Thing& self, nb::handle other) {
        return nb::isinstance<Thing>(other) && self == *nb::cast<const Thing*>(other);
      },
      nb::arg("other").none(), nb::sig("def __eq__(self, other: object, /) -> bool"));
  type.def("__hash__", [](const Thing& self) {
    return std::hash<const void*>()(self.state.get()) ^ (std::size_t{self.id.index} << 8);
  });
  type.def("__repr__", [registry, type_name](const Thing& self) {
    const Def* def = ((*self.state).*registry).find(self.id);
    return "<" + type_name + (def ? " '" + name_of(*def) + "'" : std::string(", destroyed")) + ">";
  });
  world.def_prop_ro(
      plural,
      [registry](const PyWorld& self) {
        nb::list list;
        for (const Id id : ((*self.state).*registry).ids) list.append(Thing{self.state, id});
        return list;
      },
      nb::for_getter(nb::sig(("def " + std::string(plural) + "(self) -> list[" + type_name + "]").c_str())),
      "Those that exist, in the order of their creation.");
  world.def(
      find ? find : singular,
      [registry, singular](const PyWorld& self, const std::string& name) {
        const auto& all = (*self.state).*registry;
        for (std::size_t i = 0; i < all.ids.size(); ++i) {
          if (name_of(all.defs[i]) == name) return Thing{self.state, all.ids[i]};
        }
        throw Error(ErrorCode::not_found,
                    "the world has no " + std::string(singular) + " named \"" + name + "\"");
      },
      nb::arg("name"), "The first with this name. Raises NotFoundError.");
  return type;
}

/// A call of World that creates a thing from keyword arguments.
template <class Def, class Id, class Stored>
void bind_creation(nb::class_<PyWorld>& world, const char* call, Registry<Id, Stored> Things::*registry,
                   Id (World::*create)(const Def&), const char* summary) {
  const Description text = describe_call<Def>(call, handle_name(Id{}), summary);
  world.def(
      call,
      [call, registry, create](const PyWorld& self, const nb::kwargs& given) {
        Def def{};
        read_members(def, given, call);
        const Id id = self.state->change([&](World& w) { return (w.*create)(def); });
        ((*self.state).*registry).add(id, std::move(def));
        return Handle<Id>{self.state, id};
      },
      nb::sig(text.signature.c_str()), text.doc.c_str());
}

/// Whether the world still has a thing, by a call that refuses ids of others.
template <class Ask>
bool exists(const Ask& ask) {
  try {
    ask();
    return true;
  } catch (const Error& error) {
    return error.code() != ErrorCode::not_found;
  }
}

/// Forgets what went with a body, a piece of cloth or a rope.
inline void forget_dependents(WorldState& state) {
  state.look([&](World& w) {
    state.joints.keep([&](JointId id) { return exists([&] { w.hinge_angle(id); }); });
    state.attachments.keep([&](AttachmentId id) { return exists([&] { w.attachment_vertices(id); }); });
    state.emitters.keep([&](EmitterId id) { return exists([&] { w.emitter_count(id); }); });
    state.sinks.keep([&](SinkId id) { return exists([&] { w.sink_count(id); }); });
  });
}

/// destroy() of a thing.
template <class Id, class Def>
void bind_destruction(nb::class_<Handle<Id>>& type, Registry<Id, Def> Things::*registry,
                      void (World::*destroy)(Id), const char* doc) {
  type.def(
      "destroy",
      [registry, destroy](const Handle<Id>& self) {
        self.state->change([&](World& w) { (w.*destroy)(self.id); });
        ((*self.state).*registry).keep([&](Id id) { return !(id == self.id); });
        forget_dependents(*self.state);
      },
      doc);
}

/// A property that one quick call of the world answers.
template <class Id, class Ask>
void bind_answer(nb::class_<Handle<Id>>& type, const char* name, const char* result, const Ask& ask,
                 const char* doc) {
  type.def_prop_ro(
      name,
      [ask](const Handle<Id>& self) {
        return to_python(self.state->look([&](World& w) { return ask(w, self.id); }));
      },
      nb::for_getter(nb::sig(("def " + std::string(name) + "(self) -> " + result).c_str())), doc);
}

}  // namespace meniscus::python
