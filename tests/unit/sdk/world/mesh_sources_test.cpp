// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Meshes from memory, and from files that a program reads itself, give what files give, and the same errors.
#include <meniscus/scene.h>

#include <map>

#include "tests/cloth_worlds.h"
#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0},
                                {0, 0, 3}, {1, 0, 3}, {1, 2, 3}, {0, 2, 3}};
/// brick_obj, with each quadrilateral cut as its reader cuts it.
const std::vector<uint32_t> faces{0, 3, 2, 0, 2, 1, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                  2, 3, 7, 2, 7, 6, 1, 2, 6, 1, 6, 5, 0, 4, 7, 0, 7, 3};

/// The brick in memory.
template <class Def>
Def brick(float scale = 0.1f) {
  Def def{};
  def.scale = scale;
  def.vertices = corners;
  def.triangles = faces;
  return def;
}

class MeshSourcesTest : public OnDevice {
 protected:
  /// What solids, particles and emitters make of three definitions.
  template <class Fill>
  uint64_t result_of(const WorldDef& def, const Fill& fill) {
    World world(def);
    const FluidId water = world.create_fluid({});
    fill(world, water);
    for (int k = 0; k < 5; ++k) world.step(0.01f);
    return world.state_hash();
  }

  static void fill(World& world, FluidId water, const MeshGeometry& solid, const MeshRegion& region,
                   const MeshOpening& opening) {
    world.create_shape(shape(solid, {1, 0, 0}));
    world.create_body(body(solid, {1.02f, 0.4f, 0}));
    FluidVolumeDef volume;
    volume.fluid = water;
    volume.region = region;
    EXPECT_GT(world.add_fluid(volume), 8u);
    volume.seeding = Seeding::disordered;
    volume.pose.position = {-1, 0, 0};
    EXPECT_GT(world.add_fluid(volume), 8u);
    EmitterDef emitter;
    emitter.fluid = water;
    emitter.opening = opening;
    emitter.pose.position = {0, 3, 0};
    world.create_emitter(emitter);
  }

  WorldDef def_ = world_def(GetParam(), 0.05f);
  TemporaryFolder folder_;
};

TEST_P(MeshSourcesTest, MemoryAndFilesGiveTheSame) {
  const std::string file = folder_.write("brick.obj", brick_obj);
  const uint64_t from_file = result_of(def_, [&](World& world, FluidId water) {
    fill(world, water, {file, 0.1f}, {file, 0.1f}, {file, 0.1f});
  });
  const uint64_t from_memory = result_of(def_, [&](World& world, FluidId water) {
    fill(world, water, brick<MeshGeometry>(), brick<MeshRegion>(), brick<MeshOpening>());
  });
  EXPECT_EQ(from_memory, from_file);
  std::vector<std::string> asked;
  def_.read_file = [&](const std::string& name) -> std::optional<std::string> {
    asked.push_back(name);
    if (name != "models/brick.obj") return std::nullopt;
    return brick_obj;
  };
  const std::string name = "models/brick.obj";
  const uint64_t from_reader = result_of(def_, [&](World& world, FluidId water) {
    fill(world, water, {name, 0.1f}, {name, 0.1f}, {name, 0.1f});
  });
  EXPECT_EQ(from_reader, from_file);
  EXPECT_EQ(asked, std::vector<std::string>(5, name)) << "once for each mesh";
}

TEST_P(MeshSourcesTest, ClothFilesOfAReader) {
  const char* quad = "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nf 1 2 3 4\n";
  ClothDef cloth;
  cloth.geometry = ClothFile{folder_.write("quad.obj", quad)};
  World world(def_);
  const ClothId from_file = world.create_cloth(cloth);
  def_.read_file = [&](const std::string&) { return quad; };
  World other(def_);
  cloth.geometry = ClothFile{"x.obj"};
  const ClothId from_reader = other.create_cloth(cloth);
  EXPECT_EQ(copy_of(other.cloth_positions(from_reader)), copy_of(world.cloth_positions(from_file)));
}

/// Each defect, in a file and in memory: the same code, and the same words but for the name.
TEST_P(MeshSourcesTest, TheErrorsAreTheSame) {
  World world(def_);
  const auto text_of = [&](const MeshGeometry& mesh, ErrorCode code) {
    try {
      world.create_body(body(mesh, {0, 0, 0}));
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), code) << error.what();
      std::string text = error.what();
      for (const std::string& name : {"mesh file '" + mesh.file + "'", std::string("mesh in memory")})
        if (const size_t at = text.find(name); at != std::string::npos) text.replace(at, name.size(), "MESH");
      return text;
    }
    return std::string();
  };
  MeshGeometry open = brick<MeshGeometry>();
  open.triangles.resize(30);
  const MeshGeometry open_file{folder_.write("open.obj", open_brick_obj), 0.1f};
  EXPECT_EQ(text_of(open, ErrorCode::mesh), text_of(open_file, ErrorCode::mesh));
  EXPECT_EQ(text_of(brick<MeshGeometry>(1e-9f), ErrorCode::mesh),
            text_of({folder_.write("brick.obj", brick_obj), 1e-9f}, ErrorCode::mesh));
  MeshGeometry flat = brick<MeshGeometry>();
  flat.triangles = {0, 0, 1};
  EXPECT_EQ(text_of(flat, ErrorCode::mesh),
            text_of({folder_.write("flat.obj", "v 0 0 0\nv 1 0 0\nf 1 1 2\n"), 0.1f}, ErrorCode::mesh));
  EXPECT_EQ(world.body_ids().size(), 0u);
}

TEST_P(MeshSourcesTest, RefusesListsThatDoNotFit) {
  World world(def_);
  const auto refuse = [&](ErrorCode code, const char* named, const auto& change) {
    MeshGeometry mesh = brick<MeshGeometry>();
    change(mesh);
    expect_error(code, named, [&] { world.create_shape(shape(mesh)); });
    EXPECT_TRUE(world.shape_ids().empty());
  };
  constexpr ErrorCode invalid = ErrorCode::invalid_argument;
  refuse(invalid, "mesh in memory: vertices are missing", [](MeshGeometry& m) { m.vertices.clear(); });
  refuse(invalid, "mesh 'crate' in memory: triangles must hold three", [](MeshGeometry& m) {
    m.file = "crate";
    m.triangles.pop_back();
  });
  refuse(ErrorCode::mesh, "no triangle", [](MeshGeometry& m) { m.triangles.clear(); });
  refuse(invalid, "MeshGeometry::vertices[7]", [](MeshGeometry& m) { m.vertices[7].x = not_a_number; });
  refuse(ErrorCode::mesh, "names a vertex it lacks", [](MeshGeometry& m) { m.triangles[3] = 8; });
  refuse(ErrorCode::io, "mesh file ''", [](MeshGeometry& m) { m = {}; });
}

/// A snapshot file has meshes from memory in it. What a reader reads, it must be given again.
TEST_P(MeshSourcesTest, AreInSnapshots) {
  def_.read_file = [](const std::string&) { return brick_obj; };
  World world(def_);
  world.create_shape(shape(brick<MeshGeometry>()));
  world.create_body(body(MeshGeometry{"brick.obj", 0.1f}, {0.02f, 0.6f, 0}));
  for (int k = 0; k < 5; ++k) world.step(0.01f);
  const std::string file = folder_.write("world.menisnap", "");
  world.save(file);
  expect_error(ErrorCode::io, "brick.obj", [&] { World::load(file); });
  LoadDef with_reader;
  with_reader.read_file = def_.read_file;
  World loaded = World::load(file, with_reader), clone = world.clone();
  for (World* w : {&world, &loaded, &clone}) w->step(0.01f);
  EXPECT_EQ(loaded.state_hash(), world.state_hash());
  EXPECT_EQ(clone.state_hash(), world.state_hash());
}

TEST_P(MeshSourcesTest, OfScenes) {
  const std::string text =
      R"({"name": "bricks", "world": {"particle_spacing": 0.05}, "fluids": [{"name": "water"}],
    "shapes": [{"name": "a", "geometry": {"type": "mesh", "file": "brick.obj", "scale": 0.1}},
               {"name": "b", "geometry": {"type": "mesh", "vertices": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]],
                             "triangles": [0,2,1, 0,1,3, 0,3,2, 1,2,3]}, "pose": {"position": [9,0,0]}}],
    "volumes": [{"fluid": "water", "region": {"type": "mesh", "file": "sub/brick.obj", "scale": 0.1},
                 "pose": {"position": [-1,0,0]}}]})";
  std::map<std::string, int> asked;
  const FileReader reader = [&](const std::string& name) -> std::optional<std::string> {
    ++asked[name];
    if (name.find("brick") == std::string::npos) return std::nullopt;
    return brick_obj;
  };
  Scene scene = read_scene_text(text, "pack", "scene", reader);
  scene.world.device = choice_of(GetParam());
  BuiltScene built = build_scene(scene);
  EXPECT_GT(built.volumes.at(0), 8u);
  EXPECT_EQ(asked.size(), 2u);
  EXPECT_TRUE(asked.contains("pack/brick.obj") && asked.contains("pack/sub/brick.obj"));
  const FileReader nothing = [](const std::string&) { return std::nullopt; };
  expect_error(ErrorCode::io, "cannot read mesh file \"pack/brick.obj\"",
               [&] { read_scene_text(text, "pack", "scene", nothing); });
}

/// What a reader throws comes out of the call, and the world is as before.
TEST_P(MeshSourcesTest, AReaderMayThrow) {
  def_.read_file = [](const std::string&) -> std::optional<std::string> {
    throw std::range_error("archive");
  };
  World world(def_);
  EXPECT_THROW(world.create_shape(shape(MeshGeometry{"x.obj"})), std::range_error);
  EXPECT_TRUE(world.shape_ids().empty());
  world.step(0.01f);
}

MENISCUS_ON_EACH_DEVICE(MeshSourcesTest);

}  // namespace
}  // namespace meniscus::tests
