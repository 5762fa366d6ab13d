// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Snapshot files whose hashes are right, and whose contents are not.
#include <cstring>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

#include "sdk/world/state/chunk_format.h"
#include "tests/expect_error.h"
#include "tests/unit/sdk/world/snapshot/cases.h"
#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

using chunk_format::Json;
using chunk_format::Prefix;

/// A snapshot file in parts.
struct Parts {
  Json header;
  std::vector<std::string> chunks;

  explicit Parts(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(file), {}};
    Prefix prefix{};
    std::memcpy(&prefix, whole.data(), sizeof prefix);
    header = Json::parse(whole.substr(sizeof prefix, prefix.header_bytes));
    size_t at = sizeof prefix + prefix.header_bytes;
    for (const Json& chunk : header["chunks"]) {
      chunks.push_back(whole.substr(at, chunk["element_bytes"].get<size_t>() * chunk["count"].get<size_t>()));
      at += chunks.back().size();
    }
  }
  Json definitions() const { return Json::parse(header["definitions"].get<std::string>()); }
  size_t place_of(const std::string& name) const {
    for (size_t k = 0; k < chunks.size(); ++k) {
      if (header["chunks"][k]["name"] == name) return k;
    }
    throw std::runtime_error("no chunk " + name);
  }
  template <class T>
  void edit(const std::string& name, const std::function<void(std::vector<T>&)>& change) {
    const size_t k = place_of(name);
    std::vector<T> values(chunks[k].size() / sizeof(T));
    std::memcpy(values.data(), chunks[k].data(), chunks[k].size());
    change(values);
    chunks[k].assign(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    header["chunks"][k]["count"] = values.size();
    header["chunks"][k]["xxh3"] = XXH3_64bits(chunks[k].data(), chunks[k].size());
  }
  void drop(const std::string& name) {
    const size_t k = place_of(name);
    header["chunks"].erase(k);
    chunks.erase(chunks.begin() + static_cast<std::ptrdiff_t>(k));
  }
  void write(const std::string& path) const {
    const std::string text = header.dump();
    Prefix prefix{{},
                  chunk_format::format_version,
                  static_cast<uint32_t>(text.size()),
                  XXH3_64bits(text.data(), text.size())};
    std::memcpy(prefix.magic, chunk_format::magic, sizeof prefix.magic);
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(&prefix), sizeof prefix);
    file << text;
    for (const std::string& chunk : chunks) file << chunk;
  }
};

class CraftedSnapshotTest : public OnDevice {
 protected:
  /// A driven sheet of 2 × 2 vertices.
  World driven() const {
    World world(world_def(GetParam(), 0.1f));
    DrivenTriangles motion;
    motion.triangles = {0, 1, 2, 1, 3, 2};
    for (const float t : {0.0f, 1.0f})
      motion.keyframes.push_back({t, {{0, t, 0}, {0, t, 1}, {1, t, 0}, {1, t, 1}}});
    ClothDef def;
    def.geometry = motion;
    world.create_cloth(def);
    return world;
  }
  std::string path() const { return folder_.write("world.menisnap", ""); }
  template <class T>
  void expect_refused(const char* why, const char* chunk,
                      const std::function<void(std::vector<T>&)>& change) const {
    const std::string file = path();
    driven().save(file);
    Parts parts(file);
    parts.edit(std::string("world/cloth/0/") + chunk, change);
    parts.write(file);
    expect_error(ErrorCode::io, why, [&] { World::load(file); });
  }

  TemporaryFolder folder_;
};

TEST_P(CraftedSnapshotTest, TracksMustFitTheirSurface) {
  using Times = std::vector<double>;
  using Places = std::vector<Vec3>;
  expect_refused<double>("no times", "track_time", [](Times& t) { t.clear(); });
  expect_refused<double>("do not increase", "track_time", [](Times& t) { t[1] = t[0]; });
  expect_refused<double>("not finite", "track_time", [](Times& t) { t[1] = INFINITY; });
  expect_refused<double>("for 3 times", "track_time", [](Times& t) { t.push_back(2); });
  expect_refused<Vec3>("has 7 positions", "track_position", [](Places& x) { x.pop_back(); });
  expect_refused<Vec3>("has 4 positions", "track_position", [](Places& x) { x.resize(4); });
  expect_refused<Vec3>("has 0 positions", "track_position", [](Places& x) { x.clear(); });
}

TEST_P(CraftedSnapshotTest, CountsMustBeWholeNumbers) {
  const std::string file = path();
  driven().save(file);
  const Parts parts(file);
  for (const char* member : {"version", "element_bytes", "count", "xxh3"}) {
    for (const Json& wrong : {Json(3.2e20), Json(-1), Json(0.5), Json("1")}) {
      Parts edited = parts;
      edited.header["chunks"][0][member] = wrong;
      edited.write(file);
      expect_error(ErrorCode::io, member, [&] { World::load(file); });
    }
  }
}

TEST_P(CraftedSnapshotTest, KeyframesAreInTheFileOnce) {
  const std::string file = path();
  World world = driven();
  world.save(file);
  Parts parts(file);
  Json definitions = parts.definitions();
  EXPECT_TRUE(definitions["cloths"][0]["geometry"]["keyframes"].empty());
  // As earlier versions wrote them:
  definitions["cloths"][0]["geometry"]["keyframes"] = {{{"time", 0}, {"vertices", {{0, 0, 0}}}}};
  parts.header["definitions"] = definitions.dump();
  parts.write(file);
  World loaded = World::load(file);
  EXPECT_EQ(future_of(loaded, 3), future_of(world, 3));
  loaded.save(file);
  EXPECT_TRUE(Parts(file).definitions()["cloths"][0]["geometry"]["keyframes"].empty());
}

/// As a file of 0.2 does.
TEST_P(CraftedSnapshotTest, ATextureThatIsMissingIsReadFromItsFile) {
  const char* text = "v 0 0 0\nv 1 0 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 3/3 2/2\n";
  const char* other = "v 0 0 0\nv 2 0 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 3/3 2/2\n";
  const std::string file = path();
  World world(world_def(GetParam(), 0.1f));
  ClothDef def;
  def.geometry = ClothFile{folder_.write("flag.obj", text), 1};
  world.create_cloth(def);
  world.save(file);
  Parts parts(file);
  parts.drop("world/cloth/0/texture");
  parts.write(file);
  const World loaded = World::load(file);
  const ClothId id = loaded.cloth_ids().at(0);
  folder_.write("flag.obj", other);
  expect_error(ErrorCode::mesh, "has changed since", [&] { loaded.cloth_texture(id); });
  loaded.save(file);
  folder_.write("flag.obj", text);
  EXPECT_EQ(loaded.cloth_texture(id).size(), 3u);
  const World again = World::load(file);
  EXPECT_EQ(again.cloth_texture(again.cloth_ids().at(0)).size(), 3u);
}

TEST(SnapshotHeaderTest, MustFitItsLength) {
  EXPECT_EQ(chunk_format::header_length(0xffffffff), 0xffffffffu);
  expect_error(ErrorCode::capacity, "4294967296 bytes", [] { chunk_format::header_length(0x100000000); });
}

MENISCUS_ON_EACH_DEVICE(CraftedSnapshotTest);

}  // namespace
}  // namespace meniscus::tests
