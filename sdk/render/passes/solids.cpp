// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/render/passes/solids.h"

#include <utility>

#include "sdk/io/preview/palette.h"

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
  const Triangles surface = solid_surface(geometry, pose, up_, color),
                  walls = glass_walls(geometry, pose, up_);
  for (const Triangles* triangles : {&surface, &walls}) {
    for (const Vertex& v : *triangles) bounds_.add(to_world(pose, v.position));
  }
  Item& item = items_.emplace_back();
  item.pose = pose;
  item.surface.set(surface);
  item.walls.set(walls);
}

void Solids::set_edges(float radius) {
  for (std::size_t i = 0; i < items_.size(); ++i) {
    const std::size_t body = i - scene_.shapes.size();
    items_[i].edges.set(container_edges(
        i < scene_.shapes.size() ? scene_.shapes[i].geometry : scene_.bodies[body].geometry, radius));
  }
}

bool Solids::place(std::span<const BodyState> states, const io::ClothFrame& cloth, const io::RopeFrame& ropes,
                   std::span<const Vec3> cloth_triangle_colors) {
  if (!states.empty() && states.size() != scene_.bodies.size()) {
    throw Error(ErrorCode::invalid_argument, "states has " + std::to_string(states.size()) +
                                                 " elements, but the scene has " +
                                                 std::to_string(scene_.bodies.size()) + " bodies");
  }
  for (std::size_t i = 0; i < states.size(); ++i) items_[scene_.shapes.size() + i].pose = states[i].pose;
  cloth_.set(cloth_surface(cloth, scene_.cloth_colors, cloth_triangle_colors));
  ropes_.set(rope_surface(ropes, scene_.rope_colors));
  const bool moves = !states.empty() || !cloth.vertices.empty() || !ropes.vertices.empty();
  return std::exchange(moves_, moves) || moves;
}

void Solids::draw(const Program& program, Mesh Item::*mesh) const {
  program.use();
  for (const Item& item : items_) {
    if ((item.*mesh).empty()) continue;
    set_model(item.pose);
    (item.*mesh).draw();
  }
}

void Solids::draw_shadows() const {
  draw(shadow_, &Item::surface);
  set_model({});
  cloth_.draw();
  ropes_.draw();
}

void Solids::draw_opaque() const {
  draw(solid_, &Item::surface);
  set_model({});
  cloth_.draw();
  ropes_.draw();
}

void Solids::draw_glass() const {
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
  glEnable(GL_CULL_FACE);
  glDepthMask(GL_FALSE);
  draw(glass_, &Item::walls);
  glDepthMask(GL_TRUE);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
}

void Solids::draw_edges() const {
  draw(edge_, &Item::edges);
}

}  // namespace meniscus::render
