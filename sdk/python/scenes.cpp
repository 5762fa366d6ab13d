// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Worlds from scene files, and pictures of worlds.
#include <meniscus/scene.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "sdk/io/preview/preview.h"
#include "sdk/python/lent.h"
#include "sdk/python/values/arrays.h"
#include "sdk/python/values/from_python.h"
#include "sdk/python/world.h"

namespace meniscus::python {

namespace {

PyWorld read_world(const std::string& path, const std::vector<std::string>& overrides, nb::handle given) {
  const Callable log = function_of(given, {"load_scene", "log"});
  const nb::gil_scoped_release released;
  Scene scene = read_scene(path, overrides);
  scene.world.log = sink_of(log);
  const auto state = std::make_shared<WorldState>(build_scene(scene), scene);
  state->log = log;
  return {state};
}

/// What the preview draws around the particles.
io::PreviewScene surroundings(const WorldState& state) {
  io::PreviewScene picture;
  std::size_t last_fluid = 0;
  for (const auto& material : state.fluids.defs) {
    picture.fluid_colors.push_back(std::visit([](const auto& def) { return def.color; }, material));
    if (std::holds_alternative<FluidDef>(material)) last_fluid = picture.fluid_colors.size();
  }
  picture.first_granular = last_fluid;
  for (const ClothDef& def : state.cloths.defs) picture.cloth_colors.push_back(def.color);
  for (const RopeDef& def : state.ropes.defs) picture.rope_colors.push_back(def.color);
  picture.shapes = state.shapes.defs;
  picture.bodies = state.bodies.defs;
  picture.camera = state.camera;
  return picture;
}

std::optional<SceneCamera> camera_of(nb::handle position, nb::handle target, float field_of_view) {
  if (position.is_none()) return {};
  SceneCamera camera;
  camera.field_of_view = field_of_view;
  read(position, {"draw", "position"}, camera.position);
  read(target, {"draw", "target"}, camera.target);
  return camera;
}

nb::object draw(const PyWorld& self, int width, int height, nb::handle position, nb::handle target,
                float field_of_view) {
  if (width < 1 || height < 1 || width > 16384 || height > 16384)
    throw Error(ErrorCode::invalid_argument, "width and height must be at least 1 and at most 16384");
  WorldState& state = *self.state;
  io::PreviewScene picture = surroundings(state);
  picture.width = width;
  picture.height = height;
  if (const auto camera = camera_of(position, target, field_of_view)) picture.camera = camera;
  // Copies: without the GIL, other threads may add to the lists.
  const auto bodies = state.bodies.ids;
  const auto cloths = state.cloths;
  const auto ropes = state.ropes;
  io::Image image = state.measure([&](World& w) {
    picture.gravity = w.def().gravity;
    picture.particle_spacing = w.def().particle_spacing;
    std::vector<BodyState> states;
    for (const BodyId id : bodies) states.push_back(w.body_state(id));
    return io::render_preview(io::frame_of(w), picture, states,
                              io::cloth_frame_of(w, cloths.ids, cloths.defs),
                              io::rope_frame_of(w, ropes.ids, ropes.defs));
  });
  const auto rgb = std::make_shared<const std::vector<uint8_t>>(std::move(image.rgb));
  using Pixels = nb::ndarray<nb::numpy, const uint8_t>;
  return nb::cast(Pixels(rgb->data(), {std::size_t(image.height), std::size_t(image.width), 3}, kept(rgb)));
}

}  // namespace

void bind_scenes(nb::module_& module, nb::class_<PyWorld>& world) {
  module.def(
      "read_world", read_world, nb::arg("path"), nb::arg("overrides"), nb::arg("log") = nb::none(),
      nb::sig("def read_world(path: str, overrides: collections.abc.Sequence[str], log: "
              "collections.abc.Callable[[typing.Literal['note', 'warning'], str], object] | None = None) "
              "-> World"),
      "A world from a scene file. Overrides are texts such as \"world.substeps=8\".");
  module.def("scene_schema", scene_schema, "The JSON Schema of scene files.");
  world.def(
      "draw", draw, nb::arg("width") = 960, nb::arg("height") = 540, nb::arg("position") = nb::none(),
      nb::arg("target") = nb::make_tuple(0, 0, 0), nb::arg("field_of_view") = 35.0f,
      nb::sig("def draw(self, width: int = 960, height: int = 540, position: numpy.typing.ArrayLike | None "
              "= None, target: numpy.typing.ArrayLike = (0, 0, 0), field_of_view: float = 35.0) -> "
              "numpy.typing.NDArray[numpy.uint8]"),
      "A picture by the rasteriser on the CPU: height rows of width pixels, sRGB. Without the position of "
      "an eye, m, the view is the scene's, or one that holds everything.");
  world.def(
      "show",
      [](nb::handle self, const nb::kwargs& options) {
        return nb::module_::import_("meniscus.pictures").attr("Picture")(self.attr("draw")(**options));
      },
      nb::sig(
          "def show(self, *, width: int = 960, height: int = 540, position: numpy.typing.ArrayLike | None = "
          "None, target: numpy.typing.ArrayLike = (0, 0, 0), field_of_view: float = 35.0) -> "
          "meniscus.pictures.Picture"),
      "The picture of draw(), which notebooks display and save() writes as PNG.");
}

}  // namespace meniscus::python
