// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Each member of each definition can be set from C and be read back. Members come from fields(), so that a
// new one is tested without an edit here.
#include <gtest/gtest.h>
#include <meniscus/meniscus_c.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace meniscus::tests {
namespace {

struct Destroy {
  void operator()(MeniscusDef* def) const { meniscus_def_destroy(def); }
};
using Def = std::unique_ptr<MeniscusDef, Destroy>;

Def make_def(int kind) {
  MeniscusDef* def = nullptr;
  EXPECT_EQ(meniscus_def_create(static_cast<MeniscusDefKind>(kind), &def), MENISCUS_OK);
  return Def(def);
}

/// The parts of a list, each of which ends with the mark; the last one need not.
std::vector<std::string> split(const std::string& text, char mark) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(mark, at), text.size());
    parts.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

/// Makes the lists on a path as long as the path needs.
void make_items(MeniscusDef* def, const std::string& path) {
  for (std::size_t at = path.find("[0]"); at != std::string::npos; at = path.find("[0]", at + 1)) {
    const std::string list = path.substr(0, at);
    std::size_t count = 0;
    ASSERT_EQ(meniscus_def_get_count(def, list.c_str(), &count), MENISCUS_OK) << meniscus_last_error();
    if (count > 0) continue;
    ASSERT_EQ(meniscus_def_resize(def, list.c_str(), 1), MENISCUS_OK) << meniscus_last_error();
  }
}

/// Sets the words that a member needs, so that it exists.
void prepare(MeniscusDef* def, const MeniscusMember& member) {
  for (const std::string& need : split(member.needs, ';')) {
    const std::size_t equals = need.find('=');
    const std::string path = need.substr(0, equals);
    make_items(def, path);
    ASSERT_EQ(meniscus_def_set_text(def, path.c_str(), need.substr(equals + 1).c_str()), MENISCUS_OK)
        << meniscus_last_error();
  }
  make_items(def, member.path);
}

#define EXPECT_OK(call) EXPECT_EQ(call, MENISCUS_OK) << meniscus_last_error()

void try_number(MeniscusDef* def, const MeniscusMember& m) {
  double value = 3, read = 0;
  if (std::isfinite(m.low)) value = std::ceil(m.low) + 1;
  EXPECT_OK(meniscus_def_set_number(def, m.path, value));
  EXPECT_OK(meniscus_def_get_number(def, m.path, &read));
  EXPECT_EQ(read, value);
  const MeniscusStatus half = meniscus_def_set_number(def, m.path, 0.5);
  EXPECT_EQ(half, m.type == MENISCUS_NUMBER ? MENISCUS_OK : MENISCUS_INVALID_ARGUMENT);
  EXPECT_EQ(meniscus_def_set_number(def, m.path, 1e300), MENISCUS_INVALID_ARGUMENT);
}

void try_words(MeniscusDef* def, const MeniscusMember& m) {
  const std::vector<std::string> words = split(m.words, ',');
  ASSERT_GT(words.size(), 1u);
  for (const std::string& word : words) {
    const char* read = nullptr;
    EXPECT_OK(meniscus_def_set_text(def, m.path, word.c_str()));
    EXPECT_OK(meniscus_def_get_text(def, m.path, &read));
    EXPECT_EQ(read, word);
  }
  EXPECT_EQ(meniscus_def_set_text(def, m.path, "no such word"), MENISCUS_INVALID_ARGUMENT);
}

void try_vector(MeniscusDef* def, const MeniscusMember& m) {
  MeniscusVec3 v{};
  EXPECT_OK(meniscus_def_set_vector(def, m.path, {1, 2, 3}));
  EXPECT_OK(meniscus_def_get_vector(def, m.path, &v));
  EXPECT_TRUE(v.x == 1 && v.y == 2 && v.z == 3);
}

void try_rotation(MeniscusDef* def, const MeniscusMember& m) {
  MeniscusQuat q{};
  EXPECT_OK(meniscus_def_set_rotation(def, m.path, {0, 1, 0, 0}));
  EXPECT_OK(meniscus_def_get_rotation(def, m.path, &q));
  EXPECT_TRUE(q.x == 0 && q.y == 1 && q.z == 0 && q.w == 0);
}

void try_id(MeniscusDef* def, const MeniscusMember& m) {
  int accepted = 0;
  for (uint32_t kind = MENISCUS_NONE; kind <= MENISCUS_PROBE; ++kind) {
    if (meniscus_def_set_id(def, m.path, {kind, 7, 9}) != MENISCUS_OK) continue;
    ++accepted;
    MeniscusId id{};
    EXPECT_OK(meniscus_def_get_id(def, m.path, &id));
    EXPECT_TRUE(id.kind == kind && id.index == 7 && id.generation == 9);
  }
  EXPECT_EQ(accepted, 1) << "an id fits one kind alone";
}

void try_lists(MeniscusDef* def, const MeniscusMember& m) {
  std::size_t count = 0;
  const float numbers[] = {1, 2};
  const float* read_numbers = nullptr;
  const MeniscusVec3 vectors[] = {{1, 2, 3}, {4, 5, 6}};
  const MeniscusVec3* read_vectors = nullptr;
  const uint32_t indices[] = {3, 4};
  const uint32_t* read_indices = nullptr;
  if (m.type == MENISCUS_NUMBERS) {
    EXPECT_OK(meniscus_def_set_numbers(def, m.path, numbers, 2));
    EXPECT_OK(meniscus_def_get_numbers(def, m.path, &read_numbers, &count));
    EXPECT_EQ(std::memcmp(read_numbers, numbers, sizeof numbers), 0);
  } else if (m.type == MENISCUS_VECTORS) {
    EXPECT_OK(meniscus_def_set_vectors(def, m.path, vectors, 2));
    EXPECT_OK(meniscus_def_get_vectors(def, m.path, &read_vectors, &count));
    EXPECT_EQ(std::memcmp(read_vectors, vectors, sizeof vectors), 0);
  } else {
    EXPECT_OK(meniscus_def_set_indices(def, m.path, indices, 2));
    EXPECT_OK(meniscus_def_get_indices(def, m.path, &read_indices, &count));
    EXPECT_EQ(std::memcmp(read_indices, indices, sizeof indices), 0);
  }
  EXPECT_EQ(count, 2u);
}

void try_rest(MeniscusDef* def, const MeniscusMember& m) {
  if (m.type == MENISCUS_FLAG) {
    for (const int value : {0, 1}) {
      int read = 2;
      EXPECT_OK(meniscus_def_set_flag(def, m.path, value));
      EXPECT_OK(meniscus_def_get_flag(def, m.path, &read));
      EXPECT_EQ(read, value);
    }
  } else if (m.type == MENISCUS_TEXT) {
    const char* read = nullptr;
    EXPECT_OK(meniscus_def_set_text(def, m.path, "some text"));
    EXPECT_OK(meniscus_def_get_text(def, m.path, &read));
    EXPECT_STREQ(read, "some text");
  } else {
    ASSERT_EQ(m.type, uint32_t{MENISCUS_LIST});
    EXPECT_OK(meniscus_def_resize(def, m.path, 0));
    EXPECT_OK(meniscus_def_resize(def, m.path, 1));
  }
}

void try_member(MeniscusDef* def, const MeniscusMember& m) {
  switch (m.type) {
    case MENISCUS_NUMBER:
    case MENISCUS_WHOLE_NUMBER:
      return try_number(def, m);
    case MENISCUS_WORD:
    case MENISCUS_CHOICE:
      return try_words(def, m);
    case MENISCUS_VECTOR:
      return try_vector(def, m);
    case MENISCUS_ROTATION:
      return try_rotation(def, m);
    case MENISCUS_ID:
      return try_id(def, m);
    case MENISCUS_NUMBERS:
    case MENISCUS_VECTORS:
    case MENISCUS_INDICES:
      return try_lists(def, m);
    default:
      return try_rest(def, m);
  }
}

struct Tally {
  int kind = 0;
  std::set<std::string> paths;
  int optional = 0;
};

void try_one(const MeniscusMember* member, void* user) {
  auto& tally = *static_cast<Tally*>(user);
  SCOPED_TRACE(std::string(member->path) + " of kind " + std::to_string(tally.kind) + " " + member->needs);
  tally.paths.insert(member->path);
  const Def def = make_def(tally.kind);
  prepare(def.get(), *member);
  if (testing::Test::HasFatalFailure()) return;
  if (member->is_optional) {
    ++tally.optional;
    EXPECT_OK(meniscus_def_resize(def.get(), member->path, 1));
    EXPECT_OK(meniscus_def_resize(def.get(), member->path, 0));
    std::size_t count = 1;
    EXPECT_OK(meniscus_def_get_count(def.get(), member->path, &count));
    EXPECT_EQ(count, 0u);
  }
  try_member(def.get(), *member);
}

Tally try_all(int kind) {
  Tally tally{kind, {}, 0};
  EXPECT_OK(meniscus_def_members(static_cast<MeniscusDefKind>(kind), try_one, &tally));
  return tally;
}

TEST(CDefs, EachMemberIsSetAndRead) {
  std::size_t all = 0;
  for (int kind = 0; kind <= MENISCUS_SURFACE_MESH_DEF; ++kind) {
    const Tally tally = try_all(kind);
    EXPECT_GT(tally.paths.size(), 2u) << kind;
    all += tally.paths.size();
  }
  EXPECT_GT(all, 200u);
  const Tally world = try_all(MENISCUS_WORLD_DEF);
  for (const char* path :
       {"density.artificial_pressure.exponent", "diffuse.air.low", "periodic.x.high", "kernel"})
    EXPECT_TRUE(world.paths.count(path)) << path;
  EXPECT_GT(world.optional, 0);
  EXPECT_TRUE(try_all(MENISCUS_SHAPE_DEF).paths.count("geometry.openings[0].region.lower"));
  EXPECT_TRUE(try_all(MENISCUS_BODY_DEF).paths.count("geometry.parts[0].geometry.radius"));
  EXPECT_TRUE(try_all(MENISCUS_PROBE_DEF).paths.count("patch.upper"));
}

TEST(CDefs, AFailedSetterGivesNoOptionalMember) {
  const Def def = make_def(MENISCUS_WORLD_DEF);
  std::size_t count = 1;
  EXPECT_EQ(meniscus_def_set_number(def.get(), "diffuse.capacity", 0.5), MENISCUS_INVALID_ARGUMENT);
  EXPECT_EQ(meniscus_def_set_number(def.get(), "diffuse.capacty", 1), MENISCUS_NOT_FOUND);
  EXPECT_STREQ(meniscus_last_error(),
               "diffuse.capacty: there is no member \"capacty\"; did you mean \"capacity\"?");
  EXPECT_OK(meniscus_def_get_count(def.get(), "diffuse", &count));
  EXPECT_EQ(count, 0u);
  double value = 0;
  EXPECT_EQ(meniscus_def_get_number(def.get(), "diffuse.capacity", &value), MENISCUS_NOT_FOUND);
  EXPECT_OK(meniscus_def_set_number(def.get(), "diffuse.capacity", 5));
  EXPECT_OK(meniscus_def_get_number(def.get(), "diffuse.capacity", &value));
  EXPECT_EQ(value, 5);
}

TEST(CDefs, InfinityHasItsMeaning) {
  const Def def = make_def(MENISCUS_EMITTER_DEF);
  double stop = 0;
  EXPECT_OK(meniscus_def_set_number(def.get(), "stop", 2));
  EXPECT_OK(meniscus_def_set_number(def.get(), "stop", std::numeric_limits<double>::infinity()));
  EXPECT_OK(meniscus_def_get_number(def.get(), "stop", &stop));
  EXPECT_EQ(stop, std::numeric_limits<double>::infinity());
}

TEST(CDefs, PathsThatDoNotFitAreRefused) {
  const Def def = make_def(MENISCUS_SHAPE_DEF);
  for (const char* path : {"geometry.half_extents", "geometry.openings", "geometry.openings[0]", "nme",
                           "name.x", "pose[0]", "pose..position"})
    EXPECT_EQ(meniscus_def_set_number(def.get(), path, 1), MENISCUS_NOT_FOUND) << path;
  EXPECT_OK(meniscus_def_set_text(def.get(), "geometry", "container"));
  for (const char* path : {"", "pose", "geometry", "geometry.openings", "geometry.openings[",
                           "geometry.openings[x]", "geometry.openings.face", "name"})
    EXPECT_EQ(meniscus_def_set_number(def.get(), path, 1), MENISCUS_INVALID_ARGUMENT) << path;
  EXPECT_EQ(meniscus_def_set_text(def.get(), "geometry.openings[0].face", "x_low"), MENISCUS_NOT_FOUND);
}

}  // namespace
}  // namespace meniscus::tests
