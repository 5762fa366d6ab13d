// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The input is a scene file. It is read, and a small scene is built and stepped twice. Only Error may be
// thrown.
#include <meniscus/error.h>

#include <algorithm>
#include <cmath>

#include <meniscus/scene.h>
#include "pbd/math/vec.h"
#include "sdk/scene/scene_file.h"
#include "tests/fuzz/bytes.h"

namespace meniscus::fuzz {
namespace {

/// About how much a scene costs, in particles. What the fuzzer makes dear is not built: see reliability.md.
class Cost {
 public:
  double all = 0;

  explicit Cost(const Scene& scene) : spacing_(scene.world.particle_spacing) {
    for (const SceneVolume& v : scene.volumes) std::visit(*this, v.def.region);
    for (const ShapeDef& s : scene.shapes) std::visit(*this, s.geometry);
    for (const BodyDef& b : small(scene) ? bodies_of(scene) : std::vector<BodyDef>{}) {
      all += 50;
      std::visit(*this, b.geometry);
    }
    for (const ClothDef& c : scene.cloths) std::visit(*this, c.geometry);
    for (const RopeDef& r : scene.ropes) all += double(r.segments) + double(r.points.size());
    for (const SceneEmitter& e : scene.emitters) {
      std::visit(*this, e.def.opening);
      all += double{e.def.speed} * double{scene.frame_time} / spacing_ * 100;
    }
    all *= 1 + double(scene.world.substeps) * scene.world.iterations / 40;
    if (scene.world.cfl_number > 0) all *= scene.world.max_substeps;
    if (scene.world.diffuse) all += scene.world.diffuse->capacity;
  }

  void operator()(const BoxRegion& r) { add(r.upper - r.lower); }
  void operator()(const BallRegion& r) { add({2 * r.radius, 2 * r.radius, 2 * r.radius}); }
  void operator()(const HullGeometry& g) {
    Vec3 lower = g.points.front(), upper = lower;
    for (const Vec3 p : g.points) lower = min(lower, p), upper = max(upper, p);
    add(2.0f * (upper - lower));
  }
  void operator()(const CompoundGeometry& g) {
    for (const CompoundPart& part : g.parts) std::visit(*this, part.geometry);
  }
  void operator()(const SheetGeometry& g) { all += double(g.columns) * g.rows; }
  void operator()(const DiscOpening& o) { all += std::pow(double{o.radius} / spacing_, 2) * 4; }
  void operator()(const RectangleOpening& o) { all += double{o.width} * o.depth / spacing_ / spacing_; }
  void operator()(const ClothSphere&) { all += 1e9; }
  void operator()(const ClothTube&) { all += 1e9; }
  template <class Other>
  void operator()(const Other&) {
    all += 10;
  }

 private:
  static double copies_in(const SceneCopies& copies) {
    double all = 1;
    for (const int n : copies.count) all *= n;
    return all;
  }
  bool small(const Scene& scene) {
    double bodies = 0;
    for (const SceneBody& b : scene.bodies) {
      bodies += b.copies ? copies_in(*b.copies) : 1;
    }
    if (bodies >= 100) all += 1e9;
    return bodies < 100;
  }
  void add(Vec3 size) {
    const double s = spacing_;
    all += (size.x / s + 4) * (size.y / s + 4) * (size.z / s + 4);
  }

  double spacing_;
};

void run(const std::uint8_t* data, std::size_t size) {
  const MemoryFile file({data, size});
  Scene scene = read_scene(file.path());
  if (!(Cost(scene).all < 20000)) return;
  scene.world.device = DeviceChoice::cpu;
  scene.world.threads = 1;
  scene.relax_iterations = std::min(scene.relax_iterations, 2);
  BuiltScene built = build_scene(scene);
  for (int k = 0; k < 2; ++k) built.world.step(scene.frame_time);
  built.world.diagnostics();
}

}  // namespace
}  // namespace meniscus::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    meniscus::fuzz::run(data, size);
  } catch (const meniscus::Error&) {
  }
  return 0;
}
