// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Ids of another world, of what was removed, and that no call gave are refused by each call that takes one,
// alone or in a definition. The world is as before.
#include <gtest/gtest.h>

#include <functional>

#include "tests/unit/sdk/world/misuse/defs.h"
#include "tests/unit/sdk/world/misuse/id_walk.h"

namespace meniscus::tests {
namespace {

/// Calls that take an id of one kind, and the ids that they must refuse.
template <class Id>
struct Bad {
  std::vector<Id> ids;
  const char* kind;  ///< as errors call it
  MisuseWorld& w;
  const Sight before = Sight(w);

  void calls(const std::vector<std::function<void(Id)>>& all) const {
    for (std::size_t k = 0; k < all.size(); ++k) {
      SCOPED_TRACE(std::string(kind) + ", call " + std::to_string(k));
      for (const Id id : ids) {
        expect_error(ErrorCode::not_found, std::string("no ") + kind, [&] { all[k](id); });
        EXPECT_TRUE(Sight(w) == before);
      }
    }
  }
};

class MisuseIdsTest : public OnDevice {
 protected:
  MisuseWorld w_{GetParam()}, other_{GetParam()};

  /// `removed` was destroyed; `foreign` is of the other world; `mine` is one that exists.
  template <class Id>
  Bad<Id> bad(const char* kind, Id removed, Id foreign, Id mine) {
    return {{removed, foreign, Id{}, {mine.index, 0}, {mine.index + 99, mine.generation}}, kind, w_};
  }
};

TEST_P(MisuseIdsTest, OfFluidsAndShapes) {
  const std::vector<Vec3> one{{0, 2, 0}};
  const ShapeId gone = w_.world.create_shape(shape(BoxGeometry{}, {0, -9, 0}));
  w_.world.destroy_shape(gone);
  World& w = w_.world;
  bad("fluid", FluidId{77, 1}, other_.water, w_.water)
      .calls({[&](FluidId id) { w.particle_mass(id); }, [&](FluidId id) { w.set_fluid(id, {}); },
              [&](FluidId id) { w.add_particles(id, one); }, [&](FluidId id) { w.set_positions(id, one); },
              [&](FluidId id) { w.set_velocities(id, one); }, [&](FluidId id) { w.set_filter(id, {}); }});
  bad("shape", gone, other_.vessel, w_.vessel)
      .calls({[&](ShapeId id) { w.destroy_shape(id); }, [&](ShapeId id) { w.set_shape_pose(id, {}); },
              [&](ShapeId id) { w.set_filter(id, {}); }, [&](ShapeId id) { w.set_surface(id, {}); }});
}

TEST_P(MisuseIdsTest, OfFlowAndProbes) {
  World& w = w_.world;
  const EmitterId emitter = w.create_emitter(emitter_defs(w_).front());
  const SinkId sink = w.create_sink({});
  const ProbeId probe = w.create_probe({});
  const ForceFieldId field = w.create_force_field({});
  w.destroy_emitter(emitter), w.destroy_sink(sink), w.destroy_probe(probe), w.destroy_force_field(field);
  bad("emitter", emitter, other_.emitter, w_.emitter)
      .calls({[&](EmitterId id) { w.destroy_emitter(id); }, [&](EmitterId id) { w.emitter_count(id); }});
  bad("sink", sink, other_.sink, w_.sink)
      .calls({[&](SinkId id) { w.destroy_sink(id); }, [&](SinkId id) { w.sink_count(id); }});
  bad("probe", probe, other_.probe, w_.probe)
      .calls({[&](ProbeId id) { w.destroy_probe(id); }, [&](ProbeId id) { w.probe(id); }});
  bad("force field", field, other_.field, w_.field)
      .calls({[&](ForceFieldId id) { w.destroy_force_field(id); },
              [&](ForceFieldId id) { w.set_force_field(id, {}); }});
}

TEST_P(MisuseIdsTest, OfBodiesAndJoints) {
  World& w = w_.world;
  const BodyId gone = w.create_body(body(BoxGeometry{}, {0, 9, 0}));
  const JointId joint_of_gone = w.create_joint(joint(BallJoint{}, gone));
  const JointId destroyed = w.create_joint(joint(BallJoint{}, w_.other_box));
  w.destroy_joint(destroyed);
  w.destroy_body(gone);  // and its joint
  bad("body", gone, other_.box, w_.box)
      .calls({[&](BodyId id) { w.destroy_body(id); }, [&](BodyId id) { w.body_state(id); },
              [&](BodyId id) { w.body_mass(id); }, [&](BodyId id) { w.set_body_pose(id, {}); },
              [&](BodyId id) { w.set_body_velocity(id, {}, {}); },
              [&](BodyId id) { w.apply_force(id, {}, {}); }, [&](BodyId id) { w.apply_torque(id, {}); },
              [&](BodyId id) { w.apply_impulse(id, {}, {}); }, [&](BodyId id) { w.move_body(id, {}, 1); },
              [&](BodyId id) { w.set_filter(id, {}); }, [&](BodyId id) { w.set_surface(id, {}); }});
  for (const JointId joint : {destroyed, joint_of_gone})
    bad("joint", joint, other_.hinge, w_.hinge)
        .calls({[&](JointId id) { w.destroy_joint(id); }, [&](JointId id) { w.hinge_angle(id); }});
}

TEST_P(MisuseIdsTest, OfClothAndRopes) {
  World& w = w_.world;
  const ClothId cloth = w.create_cloth(sheet(1, 1, 3, 3, {0, 5, 0}));
  const AttachmentId held = w.create_attachment(attach(cloth, {0}));
  const RopeId rope_id = w.create_rope(rope({{0, 5, 0}, {1, 5, 0}}, 3));
  w.destroy_cloth(cloth), w.destroy_rope(rope_id);
  const std::vector<uint32_t> vertex{0};
  const std::vector<Vec3> impulse{{0, 0, 0}};
  bad("cloth", cloth, other_.cloth, w_.cloth)
      .calls({[&](ClothId id) { w.destroy_cloth(id); }, [&](ClothId id) { w.cloth_positions(id); },
              [&](ClothId id) { w.cloth_velocities(id); }, [&](ClothId id) { w.cloth_normals(id); },
              [&](ClothId id) { w.cloth_triangles(id); }, [&](ClothId id) { w.cloth_welded_vertices(id); },
              [&](ClothId id) { w.cloth_bending_fraction(id); }, [&](ClothId id) { w.cloth_strains(id); },
              [&](ClothId id) { w.cloth_texture(id); }, [&](ClothId id) { w.cloth_wetness(id); },
              [&](ClothId id) { w.cloth_state(id); },
              [&](ClothId id) { w.apply_impulses(id, vertex, impulse); },
              [&](ClothId id) { w.set_cloth_positions(id, impulse); },
              [&](ClothId id) { w.set_cloth_velocities(id, impulse); },
              [&](ClothId id) { w.set_filter(id, {}); }});
  bad("rope", rope_id, other_.string, w_.string)
      .calls({[&](RopeId id) { w.destroy_rope(id); }, [&](RopeId id) { w.rope_positions(id); },
              [&](RopeId id) { w.rope_velocities(id); }, [&](RopeId id) { w.rope_frames(id); },
              [&](RopeId id) { w.apply_impulses(id, vertex, impulse); },
              [&](RopeId id) { w.set_rope_positions(id, impulse); },
              [&](RopeId id) { w.set_rope_velocities(id, impulse); },
              [&](RopeId id) { w.set_filter(id, {}); }});
  bad("attachment", held, other_.held, w_.held)
      .calls({[&](AttachmentId id) { w.destroy_attachment(id); },
              [&](AttachmentId id) { w.attachment_force(id); },
              [&](AttachmentId id) { w.attachment_vertices(id); }});
}

template <class Def>
std::size_t id_count(Def def) {
  return ids_of(def).size();
}

/// Each id of each definition, as fields() lists them.
TEST_P(MisuseIdsTest, OfDefinitions) {
  const Sight before(w_);
  int tried = 0;
  for_each_def_call([&](const char* name, auto defs_of, auto call) {
    if (std::string_view(name) == "World") return;
    const auto defs = defs_of(w_);
    for (std::size_t d = 0; d < defs.size(); ++d) {
      for (std::size_t k = 0; k < id_count(defs[d]); ++k) {
        const auto try_id = [&](uint32_t index, uint32_t generation) {
          auto spoiled = defs[d];
          const IdMember member = ids_of(spoiled)[k];
          SCOPED_TRACE(std::string(name) + ", " + member.name);
          if (std::is_same_v<decltype(spoiled), ProbeDef> && d == 0) return;  // it needs no shape
          member.set(index, generation);
          expect_error(ErrorCode::not_found, "no ", [&] { call(w_, spoiled); });
          EXPECT_TRUE(Sight(w_) == before);
          ++tried;
        };
        try_id(0, 0);
        try_id(0, other_.water.generation);  // its first of each kind
        try_id(99, w_.water.generation);
        try_id(FluidId{}.index, FluidId{}.generation);
      }
    }
  });
  EXPECT_GT(tried, 40);
}

MENISCUS_ON_EACH_DEVICE(MisuseIdsTest);

}  // namespace
}  // namespace meniscus::tests
