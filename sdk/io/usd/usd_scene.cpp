// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Makes a USD stage of a scene.
#include "sdk/io/usd/usd_scene.h"

#include <spdlog/fmt/fmt.h>

#include "pbd/math/vec.h"
#include "sdk/io/mesh_parts.h"
#include "sdk/io/preview/palette.h"
#include "sdk/io/scene_units.h"
#include "sdk/io/usd/usd_materials.h"
#include "sdk/io/usd/usd_text.h"

namespace meniscus::io {
namespace {

std::string original_name(const std::string& name) {
  return "customData = { string name = " + usd_text(name) + " }";
}

std::vector<std::string> topology(std::span<const std::array<uint32_t, 3>> triangles) {
  return {"int[] faceVertexCounts = " + triangle_counts(triangles.size()),
          "int[] faceVertexIndices = " + triangle_corners(triangles, 0)};
}

UsdPrim still_mesh(const std::string& name, const collision::TriangleMesh& mesh, const std::string& binding) {
  UsdPrim prim{"Mesh", name, {usd_binding_schema}, topology(mesh.triangles), {}, {}};
  const std::span<const Vec3> points(mesh.vertices);
  prim.attributes.push_back("point3f[] points = " + usd_array(points));
  prim.attributes.push_back("float3[] extent = " + usd_extent(points));
  prim.attributes.emplace_back("uniform token subdivisionScheme = \"none\"");
  prim.attributes.emplace_back("uniform bool doubleSided = 1");
  prim.attributes.push_back(binding);
  return prim;
}

std::string constant_width(float width) {
  return fmt::format("float[] widths = [{}] (interpolation = \"constant\")", width);
}

const char* transform_order = "uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:orient\"]";

}  // namespace

UsdScene::UsdScene(const Scene& scene, const ExportContents& contents, const BodySurfaces* bodies,
                   const SceneFrame& first)
    : stage_{{"Xform", "scene", {"kind = \"component\""}, {}, {}, {}},
             {},
             rate_of(scene.frame_time),
             up_axis(scene.world.gravity)},
      spacing_(scene.world.particle_spacing) {
  stage_.root.metadata.push_back(original_name(scene.name));
  if (contents.particles) add_particles(scene);
  if (contents.diffuse) add_diffuse();
  if (contents.surface) add_surface(scene);
  if (bodies) add_bodies(scene, *bodies);
  add_shapes(scene);
  add_cloth(scene, first.cloth);
  add_ropes(scene, first.ropes);
  stage_.root.children.push_back(materials_.prim());
}

UsdPrim& UsdScene::add_group(const char* name) {
  return stage_.root.children.emplace_back(UsdPrim{"Scope", name, {}, {}, {}, {}});
}

void UsdScene::add_particles(const Scene& scene) {
  UsdPrim& group = add_group("particles");
  UsdNames names;
  const auto add = [&](const std::string& name, const UsdLook& look) {
    UsdPrim prim{"Points", names.add(name, "fluid"), {usd_binding_schema, original_name(name)}, {}, {}, {}};
    prim.attributes = {constant_width(spacing_), materials_.add(name, look)};
    particles_.push_back({stage_.vary(prim, {"point3f[] points"}),
                          stage_.vary(prim, {"vector3f[] velocities"}), stage_.vary(prim, {"int64[] ids"}),
                          stage_.vary(prim, {"float3[] extent"})});
    group.children.push_back(std::move(prim));
  };
  for (const FluidDef& fluid : scene.fluids) add(fluid.name, {fluid.color, usd_roughness::liquid});
  for (const GranularDef& grains : scene.granulars) add(grains.name, {grains.color, usd_roughness::grains});
}

void UsdScene::add_diffuse() {
  UsdPrim prim{"Points", "diffuse", {usd_binding_schema}, {}, {}, {}};
  prim.attributes = {constant_width(0.25f * spacing_),
                     materials_.add("diffuse", {{0.9f, 0.93f, 0.95f}, usd_roughness::grains})};
  const std::string each = "interpolation = \"vertex\"";
  diffuse_ = {stage_.vary(prim, {"point3f[] points"}), stage_.vary(prim, {"vector3f[] velocities"}),
              stage_.vary(prim, {"float[] primvars:life", each}),
              stage_.vary(prim, {"int[] primvars:kind", each}), stage_.vary(prim, {"float3[] extent"})};
  stage_.root.children.push_back(std::move(prim));
}

UsdPrim UsdScene::moving_mesh(const std::string& name, bool topology_stays, MeshNumbers& numbers) {
  UsdPrim prim{"Mesh", name, {usd_binding_schema}, {}, {}, {}};
  prim.attributes.emplace_back("uniform token subdivisionScheme = \"none\"");
  numbers.points = stage_.vary(prim, {"point3f[] points"});
  numbers.velocities = stage_.vary(prim, {"vector3f[] velocities"});
  numbers.normals = stage_.vary(prim, {"normal3f[] normals", "interpolation = \"vertex\""});
  numbers.extent = stage_.vary(prim, {"float3[] extent"});
  if (topology_stays) return prim;
  numbers.counts = stage_.vary(prim, {"int[] faceVertexCounts"});
  numbers.corners = stage_.vary(prim, {"int[] faceVertexIndices"});
  return prim;
}

void UsdScene::add_surface(const Scene& scene) {
  UsdPrim& group = add_group("surface");
  UsdNames names;
  for (const FluidDef& fluid : scene.fluids) {
    UsdPrim prim = moving_mesh(names.add(fluid.name, "fluid"), false, surface_.emplace_back());
    prim.metadata.push_back(original_name(fluid.name));
    prim.attributes.push_back(
        materials_.add(fluid.name + "_surface", {fluid.color, usd_roughness::liquid, true}));
    group.children.push_back(std::move(prim));
  }
}

void UsdScene::add_bodies(const Scene& scene, const BodySurfaces& bodies) {
  UsdPrim& group = add_group("bodies");
  UsdNames names;
  const std::vector<BodyDef> defs = bodies_of(scene);
  for (std::size_t i = 0; i < defs.size(); ++i) {
    UsdPrim prim{"Xform", names.add(defs[i].name, "body"), {}, {}, {}, {}};
    prim.metadata = {"prepend apiSchemas = [\"PhysicsRigidBodyAPI\"]", original_name(defs[i].name)};
    // The motion is recorded: a program with physics must not compute it again.
    prim.attributes = {"bool physics:rigidBodyEnabled = 0", transform_order};
    bodies_.push_back({stage_.vary(prim, {"float3 xformOp:translate", {}, true}),
                       stage_.vary(prim, {"quatf xformOp:orient", {}, true}),
                       stage_.vary(prim, {"vector3f physics:velocity", {}, true}),
                       stage_.vary(prim, {"vector3f physics:angularVelocity", {}, true})});
    const std::string binding = materials_.add(defs[i].name, {body_color(i), usd_roughness::body});
    prim.children.push_back(still_mesh("mesh", bodies.meshes()[i], binding));
    group.children.push_back(std::move(prim));
  }
}

void UsdScene::add_shapes(const Scene& scene) {
  if (scene.shapes.empty()) return;
  UsdPrim& group = add_group("shapes");
  UsdNames names;
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    const ShapeDef& shape = scene.shapes[i];
    const collision::TriangleMesh mesh = solid_mesh(shape.geometry);
    if (mesh.triangles.empty()) continue;  // a plane, which has no end
    const std::string binding = materials_.add(shape.name, {shape_color(i), usd_roughness::shape});
    UsdPrim prim = still_mesh(names.add(shape.name, "shape"), mesh, binding);
    prim.metadata.push_back(original_name(shape.name));
    prim.attributes.push_back("float3 xformOp:translate = " + usd_value(shape.pose.position));
    prim.attributes.push_back("quatf xformOp:orient = " + usd_value(shape.pose.rotation));
    prim.attributes.emplace_back(transform_order);
    group.children.push_back(std::move(prim));
  }
}

void UsdScene::add_cloth(const Scene& scene, const ClothFrame& first) {
  if (scene.cloths.empty()) return;
  UsdPrim& group = add_group("cloth");
  UsdNames names;
  const std::vector<MeshPart> parts = parts_of(first);
  for (std::size_t i = 0; i < scene.cloths.size(); ++i) {
    const ClothDef& cloth = scene.cloths[i];
    const bool tears = cloth.fabric.tear_strain > 0;
    UsdPrim prim = moving_mesh(names.add(cloth.name, "cloth"), !tears, cloth_.emplace_back());
    prim.metadata.push_back(original_name(cloth.name));
    const std::span<const std::array<uint32_t, 3>> triangles = parts[i].triangles(first.triangles);
    if (!tears) {
      prim.attributes.push_back("int[] faceVertexCounts = " + triangle_counts(triangles.size()));
      prim.attributes.push_back("int[] faceVertexIndices = " +
                                triangle_corners(triangles, parts[i].first_vertex));
    }
    if (!first.texture.empty())
      prim.attributes.push_back("texCoord2f[] primvars:st = " + usd_array(parts[i].corners(first.texture)) +
                                " (interpolation = \"faceVarying\")");
    prim.attributes.emplace_back("uniform bool doubleSided = 1");
    prim.attributes.push_back(materials_.add(cloth.name, {cloth.color, usd_roughness::cloth}));
    group.children.push_back(std::move(prim));
  }
}

void UsdScene::add_ropes(const Scene& scene, const RopeFrame& first) {
  if (scene.ropes.empty()) return;
  UsdPrim& group = add_group("ropes");
  UsdNames names;
  for (std::size_t i = 0; i < scene.ropes.size(); ++i) {
    const RopeDef& rope = scene.ropes[i];
    UsdPrim prim{"BasisCurves", names.add(rope.name, "rope"), {usd_binding_schema}, {}, {}, {}};
    prim.metadata.push_back(original_name(rope.name));
    prim.attributes = {"uniform token type = \"linear\"", "uniform token wrap = \"nonperiodic\"",
                       fmt::format("int[] curveVertexCounts = [{}]", first.lines[i].size()),
                       constant_width(2 * rope.radius),
                       materials_.add(rope.name, {rope.color, usd_roughness::rope})};
    ropes_.push_back({stage_.vary(prim, {"point3f[] points"}), stage_.vary(prim, {"vector3f[] velocities"}),
                      stage_.vary(prim, {"float3[] extent"})});
    rope_radii_.push_back(rope.radius);
    group.children.push_back(std::move(prim));
  }
}

}  // namespace meniscus::io
