// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The classes Cloth, Rope and Attachment.
#include "sdk/python/thing.h"
#include "sdk/python/things.h"
#include "sdk/python/values/arrays.h"
#include "sdk/python/values/results.h"

namespace meniscus::python {

namespace {

/// A property that is an array, of the present state.
template <class Id, class Read>
void bind_array(nb::class_<Handle<Id>>& type, const char* name, ReadoutKind kind, const char* number,
                const Read& read_out, const char* doc) {
  const std::string getter =
      "def " + std::string(name) + "(self) -> numpy.typing.NDArray[numpy." + number + "]";
  type.def_prop_ro(
      name,
      [kind, read_out](const Handle<Id>& self) {
        return self.state->array(
            kind, self.id.index, [&](World& w) { return read_out(w, self.id); },
            [](World&, const auto& values) { return copied(values); });
      },
      nb::for_getter(nb::sig(getter.c_str())), doc);
}

/// A property that is an array of vectors, and can be assigned.
template <class Id, class Read>
void bind_vectors(nb::class_<Handle<Id>>& type, const char* name, ReadoutKind kind, const Read& read_out,
                  void (World::*set)(Id, std::span<const Vec3>), const char* doc) {
  const std::string getter = "def " + std::string(name) + "(self) -> numpy.typing.NDArray[numpy.float32]";
  const std::string setter = "def " + std::string(name) + "(self, value: numpy.typing.ArrayLike, /) -> None";
  type.def_prop_rw(
      name,
      [kind, read_out](const Handle<Id>& self) {
        return self.state->array(
            kind, self.id.index, [&](World& w) { return read_out(w, self.id); },
            [](World&, const auto& values) { return copied(values); });
      },
      [name, set](const Handle<Id>& self, nb::handle given) {
        std::vector<Vec3> values;
        read(given, {handle_name(Id{}), name}, values);
        self.state->change([&](World& w) { (w.*set)(self.id, values); });
      },
      nb::for_getter(nb::sig(getter.c_str())), nb::for_setter(nb::sig(setter.c_str())), doc);
}

template <class Id>
void bind_impulses(nb::class_<Handle<Id>>& type) {
  type.def(
      "apply_impulses",
      [](const Handle<Id>& self, nb::handle vertices, nb::handle impulses) {
        std::vector<uint32_t> numbers;
        std::vector<Vec3> pushes;
        read(vertices, {"apply_impulses", "vertices"}, numbers);
        read(impulses, {"apply_impulses", "impulses"}, pushes);
        self.state->change([&](World& w) { w.apply_impulses(self.id, numbers, pushes); });
      },
      nb::arg("vertices"), nb::arg("impulses"),
      nb::sig(
          "def apply_impulses(self, vertices: numpy.typing.ArrayLike, impulses: numpy.typing.ArrayLike) -> "
          "None"),
      "N·s on each of these vertices, by number, at once. No number may repeat.");
}

void bind_cloth_arrays(nb::class_<Handle<ClothId>>& type) {
  bind_vectors(
      type, "positions", ReadoutKind::cloth_positions,
      [](World& w, ClothId id) { return w.cloth_positions(id); }, &World::set_cloth_positions,
      "m, one row a vertex.");
  bind_vectors(
      type, "velocities", ReadoutKind::cloth_velocities,
      [](World& w, ClothId id) { return w.cloth_velocities(id); }, &World::set_cloth_velocities,
      "m/s, one row a vertex.");
  bind_array(
      type, "normals", ReadoutKind::cloth_normals, "float32",
      [](World& w, ClothId id) { return w.cloth_normals(id); }, "Unit vectors, one a vertex.");
  bind_array(
      type, "strains", ReadoutKind::cloth_strains, "float32",
      [](World& w, ClothId id) { return w.cloth_strains(id); }, "Largest principal strain of each triangle.");
  bind_array(
      type, "wetness", ReadoutKind::cloth_wetness, "float32",
      [](World& w, ClothId id) { return w.cloth_wetness(id); },
      "For each vertex: the fluid that it holds over the fabric's absorbency, or 0 if that is 0.");
  type.def_prop_ro(
      "triangles",
      [](const Handle<ClothId>& self) {
        return self.state->array(
            ReadoutKind::cloth_triangles, self.id.index, [&](World& w) { return w.cloth_triangles(self.id); },
            [](World&, std::span<const uint32_t> corners) {
              const auto owner =
                  std::make_shared<const std::vector<uint32_t>>(corners.begin(), corners.end());
              return rows(owner->data(), owner->size() / 3, 3, 3, kept(owner));
            });
      },
      nb::for_getter(nb::sig("def triangles(self) -> numpy.typing.NDArray[numpy.uint32]")),
      "Three vertices each. Tearing adds vertices at the end and keeps the order of triangles.");
  type.def_prop_ro(
      "texture",
      [](const Handle<ClothId>& self) {
        return self.state->array(
            ReadoutKind::cloth_texture, self.id.index, [&](World& w) { return w.cloth_texture(self.id); },
            [](World&, std::span<const TexturePoint> points) {
              const auto owner =
                  std::make_shared<const std::vector<TexturePoint>>(points.begin(), points.end());
              return rows(owner->empty() ? nullptr : &owner->front().u, owner->size(), 2, 2, kept(owner));
            });
      },
      nb::for_getter(nb::sig("def texture(self) -> numpy.typing.NDArray[numpy.float32]")),
      "Texture coordinates (u, v), one row a corner of the triangles; no row if there are none.");
}

}  // namespace

void bind_cloth(nb::module_& module, nb::class_<PyWorld>& world) {
  // World.cloth is the solver of cloth.
  nb::class_<Handle<ClothId>> cloth =
      bind_thing(module, world, "cloth", "cloths", &Things::cloths, "find_cloth");
  bind_creation<ClothDef>(world, "add_cloth", &Things::cloths, &World::create_cloth,
                          "Adds a piece of cloth. Raises MeshError where the mesh is no surface.");
  bind_destruction(cloth, &Things::cloths, &World::destroy_cloth, "Removes it, and its attachments.");
  bind_cloth_arrays(cloth);
  bind_impulses(cloth);
  bind_answer(
      cloth, "welded_vertices", "int", [](World& w, ClothId id) { return w.cloth_welded_vertices(id); },
      "How many vertices of its file were merged into others.");
  bind_answer(
      cloth, "bending_fraction", "float", [](World& w, ClothId id) { return w.cloth_bending_fraction(id); },
      "Of the bending stiffness of its fabric, the least part that substeps have resolved.");
  cloth.def_prop_ro(
      "state",
      [](const Handle<ClothId>& self) {
        return self.state->look([&](World& w) { return w.cloth_state(self.id); });
      },
      "Mass, area, stretch, volume, pressure, momentum and energy.");

  nb::class_<Handle<RopeId>> rope = bind_thing(module, world, "rope", "ropes", &Things::ropes);
  bind_creation<RopeDef>(world, "add_rope", &Things::ropes, &World::create_rope, "Adds a rope or a rod.");
  bind_destruction(rope, &Things::ropes, &World::destroy_rope, "Removes it, and its attachments.");
  bind_vectors(
      rope, "positions", ReadoutKind::rope_positions,
      [](World& w, RopeId id) { return w.rope_positions(id); }, &World::set_rope_positions,
      "m, one row a vertex.");
  bind_vectors(
      rope, "velocities", ReadoutKind::rope_velocities,
      [](World& w, RopeId id) { return w.rope_velocities(id); }, &World::set_rope_velocities,
      "m/s, one row a vertex.");
  bind_array(
      rope, "frames", ReadoutKind::rope_frames, "float32",
      [](World& w, RopeId id) { return w.rope_frames(id); },
      "Quaternions (x, y, z, w), one a segment of a rod, z along it. Ropes have none.");
  bind_impulses(rope);
  bind_filters(cloth, rope);

  nb::class_<Handle<AttachmentId>> attachment =
      bind_thing(module, world, "attachment", "attachments", &Things::attachments);
  bind_creation<AttachmentDef>(world, "add_attachment", &Things::attachments, &World::create_attachment,
                               "Holds vertices of cloth or of a rope, or sews them to others.");
  bind_destruction(attachment, &Things::attachments, &World::destroy_attachment, "Lets go.");
  bind_answer(
      attachment, "force", "tuple[float, float, float]",
      [](World& w, AttachmentId id) { return w.attachment_force(id); },
      "N, on the world or the body in the last step. Seams read 0.");
  bind_answer(
      attachment, "vertices", "list[int]",
      [](World& w, AttachmentId id) { return w.attachment_vertices(id); }, "By number.");
}

}  // namespace meniscus::python
