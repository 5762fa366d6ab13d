// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Writes OpenVDB files.
#include "sdk/io/vdb.h"

#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/MeshToVolume.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <sstream>

#include "sdk/files/output_file.h"
#include "sdk/io/mesh_parts.h"

namespace meniscus::io {
namespace {

constexpr float band = 3;            // voxels on either side of the surface
constexpr float velocity_reach = 2;  // spacings

openvdb::FloatGrid::Ptr surface_of(const LiquidFrame& frame, const MeshPart& part, float voxel) {
  std::vector<openvdb::Vec3s> points;
  for (const Vec3 p : part.vertices(frame.vertices)) points.emplace_back(p.x, p.y, p.z);
  std::vector<openvdb::Vec3I> triangles;
  // OpenVDB's triangles are clockwise as seen from outside.
  for (const auto& [a, b, c] : part.triangles(frame.triangles))
    triangles.emplace_back(a - part.first_vertex, c - part.first_vertex, b - part.first_vertex);
  const auto transform = openvdb::math::Transform::createLinearTransform(voxel);
  if (triangles.empty()) return openvdb::createLevelSet<openvdb::FloatGrid>(voxel, band);
  return openvdb::tools::meshToLevelSet<openvdb::FloatGrid>(*transform, points, triangles, band);
}

/// The particles of one fluid, added up in the order of their ids.
class VelocityGrid {
 public:
  explicit VelocityGrid(float spacing)
      : spacing_(spacing), weights_(openvdb::FloatGrid::create()), sums_(openvdb::Vec3SGrid::create()) {}

  void add(const ParticleFrame& frame, uint32_t fluid) {
    auto weights = weights_->getAccessor();
    auto sums = sums_->getAccessor();
    for (std::size_t i = 0; i < frame.size(); ++i) {
      if (frame.fluids[i] != fluid) continue;
      const Vec3 x = frame.positions[i], v = frame.velocities[i];
      const openvdb::Vec3d at = openvdb::Vec3d(x.x, x.y, x.z) / double{spacing_};
      const openvdb::Coord low = openvdb::Coord::ceil(at - openvdb::Vec3d(double{velocity_reach})),
                           high = openvdb::Coord::floor(at + openvdb::Vec3d(double{velocity_reach}));
      for (const openvdb::Coord& node : openvdb::CoordBBox(low, high)) {
        const double u2 = (node.asVec3d() - at).lengthSqr() / double{velocity_reach * velocity_reach};
        if (u2 >= 1) continue;
        const auto weight = static_cast<float>(std::pow(1 - u2, 3));
        weights.setValue(node, weights.getValue(node) + weight);
        sums.setValue(node, sums.getValue(node) + weight * openvdb::Vec3s(v.x, v.y, v.z));
      }
    }
  }

  openvdb::Vec3SGrid::Ptr means() const {
    const auto weights = weights_->getConstAccessor();
    for (auto voxel = sums_->beginValueOn(); voxel; ++voxel)
      voxel.setValue(voxel.getValue() / weights.getValue(voxel.getCoord()));
    sums_->setTransform(openvdb::math::Transform::createLinearTransform(spacing_));
    sums_->setVectorType(openvdb::VEC_CONTRAVARIANT_RELATIVE);
    return sums_;
  }

 private:
  float spacing_;
  openvdb::FloatGrid::Ptr weights_;
  openvdb::Vec3SGrid::Ptr sums_;
};

openvdb::GridPtrVec grids_of(const LiquidFrame& liquid, const ParticleFrame& particles, float spacing) {
  const std::vector<MeshPart> parts = parts_of(liquid);
  openvdb::GridPtrVec grids;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string ending = parts.size() > 1 ? "_" + liquid.names[i] : "";
    const openvdb::FloatGrid::Ptr surface = surface_of(liquid, parts[i], 0.5f * spacing);
    surface->setName("surface" + ending);
    VelocityGrid sums(spacing);
    sums.add(particles, static_cast<uint32_t>(i));
    const openvdb::Vec3SGrid::Ptr velocity = sums.means();
    velocity->setName("velocity" + ending);
    grids.push_back(surface);
    grids.push_back(velocity);
  }
  return grids;
}

}  // namespace

void require_vdb() {}

void write_vdb(const std::filesystem::path& path, const LiquidFrame& liquid, const ParticleFrame& particles,
               float spacing) {
  openvdb::initialize();
  openvdb::MetaMap about;
  about.insertMeta("time", openvdb::DoubleMetadata(liquid.time));
  about.insertMeta("creator", openvdb::StringMetadata("Meniscus; metres, metres a second"));
  std::ostringstream bytes(std::ios::binary);
  // On this thread alone: the others are for the simulation.
  tbb::task_arena(1).execute(
      [&] { openvdb::io::Stream(bytes).write(grids_of(liquid, particles, spacing), about); });
  OutputFile file(path);
  file.write(bytes.view());
  file.commit();
}

}  // namespace meniscus::io
