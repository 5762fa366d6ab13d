// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Builds the triangle mesh of a surface, as launches of the kernels in surface_mesh_kernels.h.
#pragma once

#include "fluid/surface/block_grid.inl"
#include "fluid/surface/surface_mesh.h"
#include "fluid/surface/surface_mesh_kernels.h"
#include "fluid/surface/surface_velocity_kernels.h"

namespace meniscus::fluid {

template <class D>
void SurfaceMesher<D>::build(pbd::View<const Ellipsoid> ellipsoids, pbd::View<const pbd::Vec4> velocities,
                             const SurfaceMembers& members, const SurfaceField& field) {
  vertex_count_ = triangle_count_ = 0;
  if (table_.size() == 0) {
    const std::vector<CubeTriangles> table = pbd::marching_cubes();
    table_.resize_or_stay(table.size());
    table_.write(table);
  }
  sample(ellipsoids, members, field);
  if (blocks_.view().count() == 0) return;
  const auto iso = static_cast<uint32_t>(field.iso / surface_kernels::field_unit);
  count(iso);
  write(iso, field.cell);
  write_velocities(ellipsoids, velocities, members, field, iso);
}

template <class D>
void SurfaceMesher<D>::sample(pbd::View<const Ellipsoid> ellipsoids, const SurfaceMembers& members,
                              const SurfaceField& field) {
  using namespace surface_kernels;
  blocks_.build([&](const BlockTable& table) {
    device_.parallel_for("surface/blocks", ellipsoids.count, MarkBlocks{ellipsoids, members, field, table});
  });
  const size_t nodes = size_t{block_nodes} * blocks_.view().count();
  for (pbd::Buffer<uint32_t>* b : {&values_, &counts_, &vertex_start_, &triangle_start_}) grow(*b, nodes + 1);
  device_.fill(values_.view().data, 0, nodes * sizeof(uint32_t));
  device_.parallel_for("surface/field", ellipsoids.count,
                       AddSplats{{ellipsoids, members, field, blocks_.table()}, values_.view()});
}

template <class D>
void SurfaceMesher<D>::count(uint32_t iso) {
  using namespace surface_kernels;
  const uint32_t nodes = block_nodes * blocks_.view().count();
  const FieldView field{blocks_.view(), values_.view(), iso};
  const pbd::View<uint32_t> counts = counts_.view().first(nodes);
  device_.parallel_for("surface/count vertices", nodes, CountVertices{field, counts});
  device_.exclusive_scan("surface/place vertices", counts, vertex_start_.view());
  device_.parallel_for("surface/count triangles", nodes, CountTriangles{field, table_.view(), counts});
  device_.exclusive_scan("surface/place triangles", counts, triangle_start_.view());
  vertex_start_.read(std::span(&vertex_count_, 1), nodes);
  triangle_start_.read(std::span(&triangle_count_, 1), nodes);
}

template <class D>
void SurfaceMesher<D>::write(uint32_t iso, float cell) {
  using namespace surface_kernels;
  const uint32_t nodes = block_nodes * blocks_.view().count();
  const FieldView field{blocks_.view(), values_.view(), iso};
  grow(vertices_, vertex_count_);
  grow(normals_, vertex_count_);
  grow(triangles_, triangle_count_);
  device_.parallel_for("surface/vertices", nodes,
                       WriteVertices{field, vertex_start_.view(), cell, vertices_.view(), normals_.view()});
  device_.parallel_for(
      "surface/triangles", nodes,
      WriteTriangles{field, table_.view(), vertex_start_.view(), triangle_start_.view(), triangles_.view()});
}

template <class D>
void SurfaceMesher<D>::write_velocities(pbd::View<const Ellipsoid> ellipsoids,
                                        pbd::View<const pbd::Vec4> velocities, const SurfaceMembers& members,
                                        const SurfaceField& field, uint32_t iso) {
  using namespace surface_kernels;
  const uint32_t nodes = block_nodes * blocks_.view().count();
  const FieldView view{blocks_.view(), values_.view(), iso};
  const pbd::View<uint32_t> counts = counts_.view().first(nodes);
  grow(end_start_, size_t{nodes} + 1);
  device_.parallel_for("surface/count ends", nodes, CountEnds{view, counts});
  device_.exclusive_scan("surface/place ends", counts, end_start_.view());
  uint32_t ends = 0;
  end_start_.read(std::span(&ends, 1), nodes);
  grow(momenta_, ends);
  grow(velocities_, vertex_count_);
  device_.fill(momenta_.view().data, 0, ends * sizeof(NodeMomentum));
  device_.parallel_for(
      "surface/momenta", ellipsoids.count,
      AddMomenta{
          {ellipsoids, members, field, blocks_.table()}, velocities, end_start_.view(), momenta_.view()});
  device_.parallel_for(
      "surface/velocities", nodes,
      WriteVelocities{view, vertex_start_.view(), end_start_.view(), momenta_.view(), velocities_.view()});
}

template <class D>
SurfaceMesh SurfaceMesher<D>::read() const {
  return {vertices_.read(vertex_count_), normals_.read(vertex_count_), triangles_.read(triangle_count_),
          velocities_.read(vertex_count_)};
}

}  // namespace meniscus::fluid
