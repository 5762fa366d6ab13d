// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A sheet of cloth among solids on one device, with the device's type hidden: what meets in collision/ and
// cloth/, without a World.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "cloth/build/build_constraints.h"
#include "cloth/build/cloth_mesh.h"
#include "collision/body/attachments.h"
#include "collision/contact/shape.h"
#include "collision/mesh/mesh.h"
#include "collision/rigid/rigid_world.h"
#include "pbd/device/device.h"

namespace meniscus::tests {

struct SolidSetup {
  collision::ShapeKind kind = collision::ShapeKind::sphere;
  Vec3 size{0.1f, 0, 0};  ///< as Shape has it
  Pose pose{};
  enum class Motion { fixed, kinematic, dynamic } motion = Motion::fixed;
  float mass = 1;          ///< kg, of dynamic ones
  Vec3 velocity{0, 0, 0};  ///< m/s, of bodies
  float friction = 0.3f;
  float damping = 0;  ///< 1/s, of dynamic bodies' velocities
  bool can_sleep = true;
  std::vector<Keyframe> keyframes;                ///< of kinematic ones, in place of the velocity
  const collision::TriangleMesh* mesh = nullptr;  ///< for kind sdf, not of dynamic ones
};

struct ClothSolidSetup {
  pbd::DeviceKind device = pbd::DeviceKind::cpu;
  int threads = 0;  ///< of the CPU; 0: one a core
  Vec3 gravity{0, -9.81f, 0};
  int substeps = 4, iterations = 4;
  cloth::ClothMesh mesh;  ///< as it lies at first
  cloth::FabricParameters fabric;
  float damping = 0.001f;                              ///< s
  float radius = 0.01f;                                ///< m: vertices stop at this distance from solids
  std::vector<uint32_t> held;                          ///< vertices
  Vec3 velocity{0, 0, 0};                              ///< m/s, of the cloth
  std::vector<SolidSetup> solids;                      ///< fixed ones first
  std::vector<collision::BodyAttachment> attachments;  ///< bodies are numbered as the solids that move
  bool face_points = true;
};

class ClothSolidBench {
 public:
  virtual ~ClothSolidBench() = default;

  virtual void step(float dt) = 0;
  virtual std::vector<Vec3> positions() = 0;
  virtual std::vector<Vec3> velocities() = 0;
  virtual std::vector<Vec3> reactions() = 0;            ///< N·s, of held vertices in the last step
  virtual std::vector<Vec3> attachment_impulses() = 0;  ///< N·s, on the vertices in the last step
  virtual collision::RigidWorld& rigid() = 0;
  virtual uint32_t points_wanted() = 0;
  virtual MemoryUse memory() = 0;
};

std::unique_ptr<ClothSolidBench> make_cpu_cloth_solid_bench(const ClothSolidSetup& setup);
std::unique_ptr<ClothSolidBench> make_cuda_cloth_solid_bench(const ClothSolidSetup& setup);

inline std::unique_ptr<ClothSolidBench> make_cloth_solid_bench(const ClothSolidSetup& setup) {
#if MENISCUS_HAS_CUDA
  if (setup.device == pbd::DeviceKind::cuda) return make_cuda_cloth_solid_bench(setup);
#endif
  return make_cpu_cloth_solid_bench(setup);
}

}  // namespace meniscus::tests
