// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A scene as a USD stage, and the values of its frames.
#pragma once

#include <meniscus/scene.h>

#include <optional>
#include <string>
#include <vector>

#include "sdk/io/mesh_parts.h"
#include "sdk/io/scene_frame.h"
#include "sdk/io/surface_frame.h"
#include "sdk/io/usd/usd_materials.h"
#include "sdk/io/usd/usd_stage.h"

namespace meniscus::io {

/// Each kind of thing is a child of /scene, with a child for each object in the order of the scene:
/// particles, surface, bodies, shapes, cloth, ropes. /scene/diffuse is one set of points. Materials are in
/// /scene/materials.
class UsdScene {
 public:
  /// `first` is the first frame: meshes that keep their topology have it from there.
  UsdScene(const Scene& scene, const ExportContents& contents, const BodySurfaces* bodies,
           const SceneFrame& first);

  const UsdStage& stage() const { return stage_; }
  /// The value of each attribute of the stage that has one a frame.
  std::vector<std::string> values(const SceneFrame& frame) const;

 private:
  using Values = std::vector<std::string>;

  struct PointNumbers {
    std::size_t points, velocities, ids, extent;
  };
  struct DiffuseNumbers {
    std::size_t points, velocities, life, kind, extent;
  };
  struct BodyNumbers {
    std::size_t place, turn, velocity, spin;
  };
  struct MeshNumbers {
    std::size_t points, velocities, normals, extent;
    std::optional<std::size_t> counts, corners;  ///< none: the topology stays
  };
  struct RopeNumbers {
    std::size_t points, velocities, extent;
  };

  UsdPrim& add_group(const char* name);
  void add_particles(const Scene& scene);
  void add_diffuse();
  void add_surface(const Scene& scene);
  void add_bodies(const Scene& scene, const BodySurfaces& bodies);
  void add_shapes(const Scene& scene);
  void add_cloth(const Scene& scene, const ClothFrame& first);
  void add_ropes(const Scene& scene, const RopeFrame& first);
  /// The prim of a mesh with a value a frame for its points, and for its topology unless that stays.
  UsdPrim moving_mesh(const std::string& name, bool topology_stays, MeshNumbers& numbers);

  void set_particles(const SceneFrame& frame, Values& values) const;
  void set_diffuse(const SceneFrame& frame, Values& values) const;
  void set_bodies(const SceneFrame& frame, Values& values) const;
  void set_surface(const LiquidFrame& frame, Values& values) const;
  void set_cloth(const ClothFrame& frame, Values& values) const;
  void set_ropes(const RopeFrame& frame, Values& values) const;
  template <class Frame>
  static void set_mesh(const MeshNumbers& at, const MeshPart& part, const Frame& frame, Values& values);

  UsdStage stage_;
  UsdMaterials materials_;
  float spacing_;  // m, of particles
  std::vector<PointNumbers> particles_;
  std::optional<DiffuseNumbers> diffuse_;
  std::vector<BodyNumbers> bodies_;
  std::vector<MeshNumbers> surface_, cloth_;
  std::vector<RopeNumbers> ropes_;
  std::vector<float> rope_radii_;
};

}  // namespace meniscus::io
