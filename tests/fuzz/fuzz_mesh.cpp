// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The first byte chooses a format, the second a role, the third options; the rest is a mesh file. It is used
// in that role in a world. Only Error may be thrown.
#include <meniscus/meniscus.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "collision/mesh/inspect.h"
#include "collision/mesh/mesh.h"
#include "collision/sdf/repair.h"
#include "pbd/math/vec.h"
#include "tests/fuzz/bytes.h"

namespace meniscus::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr const char* extensions[] = {"obj", "ply", "stl", "gltf", "glb", "fbx", "dae", "3ds"};

/// A folder of this process, removed at its end.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "meniscus_fuzz_XXXXXX").string();
    if (!mkdtemp(name.data())) std::abort();
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  fs::path path_;
};

MeshGeometry geometry(const std::string& file, float scale, std::uint8_t options) {
  MeshGeometry mesh{file};
  mesh.scale = scale;
  mesh.convex_parts = options & 2 ? 4 : 1;
  if (options & 4) mesh.max_error = 0.05f;
  return mesh;
}

void use(World& world, FluidId water, const std::string& file, float scale, std::uint32_t role,
         std::uint8_t options) {
  switch (role) {
    case 0:
      world.create_shape({.name = "it", .geometry = geometry(file, scale, options)});
      break;
    case 1: {
      BodyDef def;
      def.geometry = geometry(file, scale, options);
      world.create_body(def);
      break;
    }
    case 2: {
      BodyDef def;
      def.geometry = HullGeometry{collision::load_mesh(file, scale).vertices};
      world.create_body(def);
      break;
    }
    case 3:
      world.add_fluid({.fluid = water, .region = MeshRegion{file, scale}});
      break;
    case 4: {
      EmitterDef def;
      def.fluid = water;
      def.opening = MeshOpening{file, scale};
      world.create_emitter(def);
      break;
    }
    case 5: {
      ClothDef def;
      def.geometry = ClothFile{file, scale};
      world.create_cloth(def);
      break;
    }
    default:
      collision::inspect_mesh(file, scale);
      if (options & 1) collision::repair_mesh(collision::load_mesh(file, scale), 0.15f, "it");
  }
}

void run(Bytes bytes) {
  static const Folder folder;
  const std::string file =
      (folder.path_ / (std::string("it.") + extensions[bytes.below(std::size(extensions))])).string();
  const std::uint32_t role = bytes.below(7);
  const std::uint8_t options = bytes.byte();
  const auto rest = bytes.rest();
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(rest.data()), static_cast<std::streamsize>(rest.size()));
  const collision::TriangleMesh mesh = collision::load_mesh(file, 1);
  const Aabb box = collision::bounds(mesh);
  const float longest = max_component(box.upper - box.lower);
  World world(
      {.device = DeviceChoice::cpu, .threads = 1, .particle_spacing = 0.2f, .substeps = 1, .iterations = 2});
  const FluidId water = world.create_fluid({});
  use(world, water, file, 1 / longest, role, options);
  for (int k = 0; k < 2; ++k) world.step(0.01f);
}

}  // namespace
}  // namespace meniscus::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    meniscus::fuzz::run({data, size});
  } catch (const meniscus::Error&) {
  }
  return 0;
}
