// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Keeps and draws the triangles of solids, cloth and ropes.
#include "sdk/render/passes/solids.h"

#include <algorithm>
#include <utility>

#include "sdk/io/preview/palette.h"
#include "sdk/io/solid_triangles.h"

namespace meniscus::render {
namespace {

void set_model(const Pose& pose) {
  const Matrix4 m = matrix_of(pose);
  glUniformMatrix4fv(0, 1, GL_FALSE, m.data());
}

}  // namespace

Solids::Solids(const io::PreviewScene& scene) : scene_(scene), up_(normalized_or(-scene.gravity, {0, 1, 0})) {
  for (std::size_t i = 0; i < scene.shapes.size(); ++i)
    add(scene.shapes[i].geometry, scene.shapes[i].pose, io::shape_color(i));
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    add(scene.bodies[i].geometry, scene.bodies[i].pose, io::body_color(i));
}

void Solids::add(const Geometry& geometry, const Pose& pose, Vec3 color) {
  for (const io::SolidTriangle& t : io::solid_triangles(geometry)) {
    for (const Vec3 corner : t.corners) bounds_.add(to_world(pose, corner));
  }
  Item& item = items_.emplace_back();
  item.pose = pose;
  item.is_vessel = std::holds_alternative<ContainerGeometry>(geometry);
  item.surface.set(solid_surface(geometry, pose, up_, color));
}

void Solids::measure(const io::ClothFrame& cloth) {
  if (details_.size() != piece_count(cloth)) details_ = cloth_details(cloth);
  if (triangles_ == cloth.triangles) return;
  triangles_ = cloth.triangles;
  borders_ = border_edges(triangles_);
}

bool Solids::place(std::span<const BodyState> states, const io::ClothFrame& cloth, const io::RopeFrame& ropes,
                   std::span<const Vec3> cloth_triangle_colors) {
  if (!states.empty() && states.size() != scene_.bodies.size()) {
    throw Error(ErrorCode::invalid_argument, "states has " + std::to_string(states.size()) +
                                                 " elements, but the scene has " +
                                                 std::to_string(scene_.bodies.size()) + " bodies");
  }
  for (std::size_t i = 0; i < states.size(); ++i) items_[scene_.shapes.size() + i].pose = states[i].pose;
  measure(cloth);
  cloth_.set(cloth_surface(cloth, scene_.cloth_colors, details_, borders_, cloth_triangle_colors));
  ropes_.set(rope_surface(ropes, scene_.rope_colors));
  const bool moves = !states.empty() || !cloth.vertices.empty() || !ropes.vertices.empty();
  return std::exchange(moves_, moves) || moves;
}

void Solids::draw(const Program& program, bool with_vessels) const {
  program.use();
  for (const Item& item : items_) {
    if (item.surface.empty() || (item.is_vessel && !with_vessels)) continue;
    set_model(item.pose);
    item.surface.draw();
  }
  set_model({});
  cloth_.draw();
  ropes_.draw();
}

void Solids::draw_shadows() const {
  draw(shadow_, true);
}

void Solids::draw() const {
  draw(solid_, false);
}

bool Solids::empty() const {
  const auto is_drawn = [](const Item& item) { return !item.is_vessel && !item.surface.empty(); };
  return cloth_.empty() && ropes_.empty() && std::none_of(items_.begin(), items_.end(), is_drawn);
}

}  // namespace meniscus::render
