// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Functions of MeshFields.
#pragma once

#include <algorithm>
#include <cassert>
#include <utility>

#include "collision/sdf/density_map.h"
#include "collision/sdf/mesh_fields.h"
#include "collision/sdf/sdf_error.h"

namespace meniscus::collision {

template <class D>
Sdf build_field(D& device, const TriangleMesh& mesh, float cell_size, float target_error, float margin,
                float h) {
  const DeviceTriangleBvh tree(device, TriangleBvh(mesh));
  Sdf sdf = target_error > 0 ? build_sdf_to_error(device, mesh, tree, target_error, margin)
                             : build_sdf(device, tree, cell_size, margin);
  build_density_map(device, tree, sdf, h);
  return sdf;
}

template <class D>
uint32_t MeshFields<D>::acquire(D& device, const TriangleMesh& mesh, float cell_size, float target_error,
                                float margin, float h) {
  if (target_error > 0) cell_size = 0;  // because it has no effect
  margin = std::max(margin, h);
  const Key key{hash_of(mesh), cell_size, target_error, margin, h};
  const auto self = std::find_if(fields_.begin(), fields_.end(),
                                 [&](const auto& field) { return field && field->key == key; });
  if (self != fields_.end()) {
    ++(*self)->users;
    return static_cast<uint32_t>(self - fields_.begin());
  }
  Field fresh{key, build_field(device, mesh, cell_size, target_error, margin, h), 1};
  auto place = std::find_if(fields_.begin(), fields_.end(), [](const auto& field) { return !field; });
  if (place == fields_.end()) place = fields_.emplace(place);
  place->emplace(std::move(fresh));
  return static_cast<uint32_t>(place - fields_.begin());
}

template <class D>
void MeshFields<D>::release(uint32_t number) {
  assert(number < fields_.size() && fields_[number]);
  if (--fields_[number]->users == 0) fields_[number].reset();
}

template <class D>
std::vector<SdfView> MeshFields<D>::views() const {
  std::vector<SdfView> views;
  for (const auto& field : fields_) views.push_back(field ? field->sdf.view() : SdfView{});
  return views;
}

}  // namespace meniscus::collision
