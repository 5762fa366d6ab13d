// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The distance fields and density maps of a world's meshes, shared by equal meshes.
#pragma once

#include <optional>
#include <vector>

#include "collision/mesh/hash.h"
#include "collision/sdf/build.h"

namespace meniscus::collision {

/// Owns the distance fields and density maps of a world's meshes on a device. Equal meshes with equal
/// settings share one. A field keeps its number and its memory until it has been released as often as
/// acquired.
template <class D>
class MeshFields {
 public:
  /// Returns the number of the mesh's field, and builds the field if there is none. Cells are cell_size (m)
  /// wide, or as target_error (m) demands where that is positive (build_sdf_to_error). The grid reaches at
  /// least h and `margin` (m) beyond the mesh; h (m) is the density map's support radius. Throws what
  /// build_sdf, build_sdf_to_error and build_density_map throw, and Error(out_of_memory). Nothing is added
  /// then.
  uint32_t acquire(D& device, const TriangleMesh& mesh, float cell_size, float target_error, float margin,
                   float h);

  /// Releases one acquisition of a field. No kernel may be using the field.
  void release(uint32_t number);

  /// By number; an empty view where there is no field.
  std::vector<SdfView> views() const;

 private:
  struct Key {
    MeshHash mesh;
    float cell_size, target_error, margin, h;

    bool operator==(const Key&) const = default;
  };
  struct Field {
    Key key;
    Sdf sdf;
    uint32_t users;
  };

  std::vector<std::optional<Field>> fields_;
};

}  // namespace meniscus::collision
