// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Packs containers into the buffers that shaders read.
#include "sdk/render/passes/vessels.h"

#include <cstring>

#include "sdk/io/box_faces.h"
#include "sdk/render/meshes/mesh.h"

namespace meniscus::render {
namespace {

constexpr std::size_t no_body = ~std::size_t{0};
constexpr GLuint first_binding = 5;  // see shaders/light/vessels.glsl

/// A container as shaders read it (std430).
struct Box {
  Matrix4 to_box;  ///< from the world to a frame with axis-aligned sides
  Float4 half;     ///< m
  /// Bits of its faces: glass walls, floors. Then the begin and end of its openings.
  std::array<GLuint, 4> parts;
};
/// An opening as shaders read it.
struct Hole {
  Float4 low, high;  ///< m; w of low: the face
};
struct Bar {
  Float4 from, to;  ///< m, in the world
};

Matrix4 to_box(const Pose& pose) {
  const Matrix4 m = matrix_of(pose);
  Matrix4 back = Matrix4::Identity();
  back.topLeftCorner<3, 3>() = m.topLeftCorner<3, 3>().transpose();
  back.topRightCorner<3, 1>() = -(back.topLeftCorner<3, 3>() * m.topRightCorner<3, 1>());
  return back;
}

bool is_missing(const ContainerGeometry& container, int face) {
  for (const Opening& opening : container.openings) {
    if (static_cast<int>(opening.face) == face && !opening.region) return true;
  }
  return false;
}

/// Writes the number of elements, in 16 bytes, and the elements.
template <class T>
void write_counted(DataBuffer& buffer, const std::vector<T>& elements) {
  std::vector<std::byte> bytes(16 + sizeof(T) * elements.size());
  const auto count = static_cast<GLuint>(elements.size());
  std::memcpy(bytes.data(), &count, sizeof count);
  if (count > 0) std::memcpy(bytes.data() + 16, elements.data(), sizeof(T) * elements.size());
  buffer.write(std::span<const std::byte>(bytes));
}

void add_bar(std::vector<Bar>& bars, const Pose& pose, Vec3 from, Vec3 to) {
  bars.push_back({float4(to_world(pose, from)), float4(to_world(pose, to))});
}

void add_outline(std::vector<Bar>& bars, const Pose& pose, Vec3 half, const Opening& opening) {
  const int face = static_cast<int>(opening.face), axis = face / 2;
  Vec3 low = max(opening.region->lower, -half), high = min(opening.region->upper, half);
  float Vec3::*const along[] = {&Vec3::x, &Vec3::y, &Vec3::z};
  low.*along[axis] = high.*along[axis] = face % 2 ? half.*along[axis] : -(half.*along[axis]);
  const Vec3 middle = 0.5f * (low + high), size = 0.5f * (high - low);
  const int* corners = io::box_face_corners[face];
  for (int i = 0; i < 4; ++i) {
    add_bar(bars, pose, middle + io::box_corner(size, corners[i]),
            middle + io::box_corner(size, corners[(i + 1) % 4]));
  }
}

void add_bars(std::vector<Bar>& bars, const ContainerGeometry& container, const Pose& pose) {
  const Vec3 half = container.half_extents;
  for (int from = 0; from < 8; ++from) {
    for (const int axis : {1, 2, 4}) {
      if (!(from & axis)) add_bar(bars, pose, io::box_corner(half, from), io::box_corner(half, from | axis));
    }
  }
  for (const Opening& opening : container.openings) {
    if (opening.region) add_outline(bars, pose, half, opening);
  }
}

}  // namespace

Vessels::Vessels(const io::PreviewScene& scene) : up_(normalized_or(-scene.gravity, {0, 1, 0})) {
  const auto add = [&](const Geometry& geometry, const Pose& pose, std::size_t body) {
    if (const auto* container = std::get_if<ContainerGeometry>(&geometry))
      items_.push_back({*container, pose, body});
  };
  for (const ShapeDef& shape : scene.shapes) add(shape.geometry, shape.pose, no_body);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    add(scene.bodies[i].geometry, scene.bodies[i].pose, i);
  write();
}

void Vessels::place(std::span<const BodyState> states) {
  bool moves = false;
  for (Item& item : items_) {
    if (item.body >= states.size()) continue;
    item.pose = states[item.body].pose;
    moves = true;
  }
  if (moves) write();
}

void Vessels::write() {
  std::vector<Box> boxes;
  std::vector<Hole> holes;
  std::vector<Bar> bars;
  for (const auto& [container, pose, body] : items_) {
    Box box{to_box(pose), float4(container.half_extents), {}};
    for (int face = 0; face < 6; ++face) {
      if (is_missing(container, face)) continue;
      box.parts[is_floor(-io::box_face_normals[face], pose, up_)] |= 1u << face;
    }
    box.parts[2] = static_cast<GLuint>(holes.size());
    for (const Opening& opening : container.openings) {
      if (!opening.region) continue;
      holes.push_back(
          {float4(opening.region->lower, static_cast<float>(opening.face)), float4(opening.region->upper)});
    }
    box.parts[3] = static_cast<GLuint>(holes.size());
    boxes.push_back(box);
    add_bars(bars, container, pose);
  }
  write_counted(vessels_, boxes);
  write_counted(openings_, holes);
  write_counted(bars_, bars);
}

void Vessels::bind() const {
  const GLuint buffers[] = {vessels_.name(), openings_.name(), bars_.name()};
  glBindBuffersBase(GL_SHADER_STORAGE_BUFFER, first_binding, 3, buffers);
}

}  // namespace meniscus::render
