// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Poses, filters and surfaces of what exists, as properties with the names of the arguments that made it.
#include "sdk/python/bind_members.h"
#include "sdk/python/things.h"

namespace meniscus::python {

namespace {

template <class Id>
struct TableOf;
template <>
struct TableOf<ShapeId> {
  static constexpr auto member = &Things::shapes;
};
template <>
struct TableOf<BodyId> {
  static constexpr auto member = &Things::bodies;
};
template <>
struct TableOf<ClothId> {
  static constexpr auto member = &Things::cloths;
};
template <>
struct TableOf<RopeId> {
  static constexpr auto member = &Things::ropes;
};

/// The definition of a thing as Python knows it.
template <class Id>
auto& def_of(const Handle<Id>& self) {
  if (auto* const def = ((*self.state).*TableOf<Id>::member).find(self.id)) return *def;
  throw Error(ErrorCode::not_found, "the " + handle_name(self.id) + " is destroyed");
}

/// Properties groups and mask.
template <class Id>
void bind_filter(nb::class_<Handle<Id>>& type) {
  bind_members<CollisionFilter>(
      type, [](Handle<Id>& self) { return def_of(self).filter; },
      [](Handle<Id>& self, const CollisionFilter& filter) {
        self.state->change([&](World& w) { w.set_filter(self.id, filter); });
        def_of(self).filter = filter;
      });
}

/// A property for each member of SurfaceDef.
template <class Id>
void bind_surface(nb::class_<Handle<Id>>& type) {
  bind_members<SurfaceDef>(
      type, [](Handle<Id>& self) { return def_of(self).surface; },
      [](Handle<Id>& self, const SurfaceDef& surface) {
        self.state->change([&](World& w) { w.set_surface(self.id, surface); });
        def_of(self).surface = surface;
      });
}

/// Pose::position and Pose::rotation are properties of their own.
void set_pose(Handle<ShapeId>& self, const Pose& pose) {
  self.state->change([&](World& w) { w.set_shape_pose(self.id, pose); });
  def_of(self).pose = pose;
}

void bind_pose(nb::class_<Handle<ShapeId>>& shape) {
  shape.def_prop_rw(
      "pose", [](Handle<ShapeId>& self) { return def_of(self).pose; },
      [](Handle<ShapeId>& self, nb::handle given) {
        Pose pose;
        read(given, {"Shape", "pose"}, pose);
        set_pose(self, pose);
      },
      nb::for_getter(nb::sig("def pose(self) -> Pose")),
      nb::for_setter(
          nb::sig("def pose(self, value: Pose | dict[str, typing.Any] | numpy.typing.ArrayLike, /) -> None")),
      "Of the geometry's frame. What a shape covers once it is placed is pushed out; a kinematic body "
      "carries "
      "things along instead.");
  bind_members<Pose>(
      shape, [](Handle<ShapeId>& self) { return def_of(self).pose; },
      [](Handle<ShapeId>& self, const Pose& pose) { set_pose(self, pose); });
}

}  // namespace

void bind_surfaces(nb::class_<Handle<ShapeId>>& shape) {
  bind_pose(shape);
  bind_filter(shape);
  bind_surface(shape);
}

void bind_surfaces(nb::class_<Handle<BodyId>>& body) {
  bind_filter(body);
  bind_surface(body);
}

void bind_filter(nb::class_<Handle<FluidId>>& fluid) {
  const auto filter_of = [](Handle<FluidId>& self) -> CollisionFilter& {
    auto* const def = self.state->fluids.find(self.id);
    if (!def) throw Error(ErrorCode::not_found, "the fluid does not exist");
    return std::visit([](auto& held) -> CollisionFilter& { return held.filter; }, *def);
  };
  bind_members<CollisionFilter>(
      fluid, [filter_of](Handle<FluidId>& self) { return filter_of(self); },
      [filter_of](Handle<FluidId>& self, const CollisionFilter& filter) {
        self.state->change([&](World& w) { w.set_filter(self.id, filter); });
        filter_of(self) = filter;
      });
}

void bind_filters(nb::class_<Handle<ClothId>>& cloth, nb::class_<Handle<RopeId>>& rope) {
  bind_filter(cloth);
  bind_filter(rope);
}

}  // namespace meniscus::python
