// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Rays, overlaps, distances, and the fluid at points.
#include <nanobind/stl/optional.h>

#include "sdk/python/values/arrays.h"
#include "sdk/python/values/from_python.h"
#include "sdk/python/values/results.h"
#include "sdk/python/values/to_python.h"

namespace meniscus::python {

namespace {

/// The members of QueryTargets in signatures.
constexpr const char* target_arguments =
    "*, solids: bool = True, particles: bool = True, cloth: bool = True, ropes: bool = True";

/// A RayHit or a NearestPoint.
template <class Place>
nb::object place(const PyWorld& self, const char* name, const std::optional<Place>& found) {
  if (!found) return nb::none();
  const bool has_elements = !(found->cloth == ClothId{}) || !(found->rope == RopeId{});
  return make_result(name, thing(self, found->body), thing(self, found->shape), to_python(found->particle),
                     to_python(found->point), to_python(found->normal), found->distance,
                     thing(self, found->cloth), thing(self, found->rope),
                     has_elements ? to_python(found->element) : nb::object(nb::none()));
}

nb::object cast_ray(const PyWorld& self, nb::handle start, nb::handle end, bool solids, bool particles,
                    bool cloth, bool ropes) {
  Vec3 from, to;
  read(start, {"cast_ray", "start"}, from);
  read(end, {"cast_ray", "end"}, to);
  const QueryTargets targets{solids, particles, cloth, ropes};
  return place(self, "RayHit", self.state->measure([&](World& w) { return w.cast_ray(from, to, targets); }));
}

nb::object nearest(const PyWorld& self, nb::handle given, float reach, bool solids, bool particles,
                   bool cloth, bool ropes) {
  Vec3 point;
  read(given, {"nearest", "point"}, point);
  const QueryTargets targets{solids, particles, cloth, ropes};
  return place(self, "NearestPoint",
               self.state->measure([&](World& w) { return w.nearest(point, reach, targets); }));
}

nb::object overlaps(const PyWorld& self, const Overlaps& found) {
  return make_result("Overlaps", things(self, found.bodies), things(self, found.shapes),
                     array_of(std::vector(found.particles)), things(self, found.cloths),
                     things(self, found.ropes));
}

nb::object overlap_ball(const PyWorld& self, nb::handle centre, float radius, bool solids, bool particles,
                        bool cloth, bool ropes) {
  Vec3 point;
  read(centre, {"overlap_ball", "centre"}, point);
  const QueryTargets targets{solids, particles, cloth, ropes};
  return overlaps(self,
                  self.state->measure([&](World& w) { return w.overlap_ball(point, radius, targets); }));
}

nb::object overlap_box(const PyWorld& self, nb::handle pose, nb::handle half_extents, bool solids,
                       bool particles, bool cloth, bool ropes) {
  Pose placed;
  Vec3 half;
  read(pose, {"overlap_box", "pose"}, placed);
  read(half_extents, {"overlap_box", "half_extents"}, half);
  const QueryTargets targets{solids, particles, cloth, ropes};
  return overlaps(self, self.state->measure([&](World& w) { return w.overlap_box(placed, half, targets); }));
}

/// A query with two arguments and targets.
template <class Query>
void bind_query(nb::class_<PyWorld>& world, const std::string& name, const Query& query, const char* first,
                const char* second, const std::string& types, const std::string& result, const char* doc) {
  const std::string text =
      "def " + name + "(self, " + types + ", " + target_arguments + ") -> meniscus.results." + result;
  world.def(name.c_str(), query, nb::arg(first), nb::arg(second), nb::kw_only(), nb::arg("solids") = true,
            nb::arg("particles") = true, nb::arg("cloth") = true, nb::arg("ropes") = true,
            nb::sig(text.c_str()), doc);
}

nb::object solid_distances(const PyWorld& self, nb::handle points, float reach, uint32_t groups,
                           uint32_t mask) {
  std::vector<Vec3> places;
  read(points, {"solid_distances", "points"}, places);
  return array_of(self.state->measure([&](World& w) {
    return w.solid_distances(places, reach, {groups, mask});
  }));
}

nb::object sample_fluid(const PyWorld& self, nb::handle points, std::optional<Handle<FluidId>> fluid) {
  std::vector<Vec3> places;
  read(points, {"sample_fluid", "points"}, places);
  std::optional<FluidId> id;
  if (fluid) id = fluid->id;
  std::vector<float> densities;
  std::vector<Vec3> velocities;
  std::vector<uint32_t> particles;
  for (const FluidSample& s : self.state->measure([&](World& w) { return w.sample_fluid(places, id); })) {
    densities.push_back(s.density);
    velocities.push_back(s.velocity);
    particles.push_back(s.particles);
  }
  return make_result("FluidSamples", array_of(std::move(densities)), array_of(std::move(velocities)),
                     array_of(std::move(particles)));
}

}  // namespace

void bind_queries(nb::class_<PyWorld>& world) {
  const std::string array = "numpy.typing.ArrayLike";
  bind_query(
      world, "cast_ray", cast_ray, "start", "end", "start: " + array + ", end: " + array, "RayHit | None",
      "The first thing between two points, m. A particle is a ball with a radius of half a spacing. The "
      "four others say what counts.");
  bind_query(
      world, "nearest", nearest, "point", "reach", "point: " + array + ", reach: float",
      "NearestPoint | None",
      "The nearest place on a surface within `reach` (m) of a point. A particle is a ball with a radius "
      "of half a spacing. Of equally near places the first counts, in the order of the arguments.");
  bind_query(world, "overlap_ball", overlap_ball, "centre", "radius", "centre: " + array + ", radius: float",
             "Overlaps", "What overlaps a ball, m. Particles count where their centres are inside.");
  bind_query(world, "overlap_box", overlap_box, "pose", "half_extents",
             "pose: Pose | dict[str, typing.Any] | " + array + ", half_extents: " + array, "Overlaps",
             "What overlaps a box, m. Particles count where their centres are inside.");
  world.def(
      "solid_distances", solid_distances, nb::arg("points"), nb::arg("reach"), nb::arg("groups") = 1u,
      nb::arg("mask") = 0xffffffffu,
      nb::sig("def solid_distances(self, points: numpy.typing.ArrayLike, reach: float, groups: int = 1, "
              "mask: int = 4294967295) -> numpy.typing.NDArray[numpy.float32]"),
      "m, from each point to the nearest solid, negative inside; `reach` where none is nearer.");
  world.def(
      "sample_fluid", sample_fluid, nb::arg("points"), nb::arg("fluid") = nb::none(),
      nb::sig("def sample_fluid(self, points: numpy.typing.ArrayLike, fluid: Fluid | None = None) -> "
              "meniscus.results.FluidSamples"),
      "Density and velocity of the fluid at points, from the present positions: of one fluid or granular "
      "material, or of all.");
}

}  // namespace meniscus::python
