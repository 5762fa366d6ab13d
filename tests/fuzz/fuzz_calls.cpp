// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The input is a sequence of calls to a small world. It is made on one thread and on two. Only Error may be
// thrown, by the same calls, and the states must be equal after each step.
#include <meniscus/meniscus.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "tests/fuzz/bytes.h"

namespace meniscus::fuzz {
namespace {

constexpr int most_calls = 40, most_steps = 12, most_substeps = 60;
constexpr std::size_t most_particles = 3000;

/// What a sequence did: a hash of the state after each call, or the code of its error.
using Trace = std::vector<std::uint64_t>;

/// A world, and the ids that its calls returned, some of them stale.
class Caller {
 public:
  Caller(Bytes bytes, int threads) : bytes_(bytes), world_(definition(bytes_, threads)) {
    fluids_.push_back(world_.create_fluid({}));
    world_.create_shape({.name = "tank", .geometry = ContainerGeometry{.half_extents = {1, 1, 1}}});
  }

  Trace run() {
    for (int call = 0; call < most_calls && !bytes_.at_end(); ++call) {
      try {
        make_call();
        trace_.push_back(world_.state_hash());
      } catch (const Error& error) {
        trace_.push_back(static_cast<std::uint64_t>(error.code()));
        trace_.push_back(world_.state_hash());
      }
    }
    return std::move(trace_);
  }

 private:
  static WorldDef definition(Bytes& bytes, int threads) {
    WorldDef def{.device = DeviceChoice::cpu, .threads = threads, .particle_spacing = 0.2f};
    def.substeps = 1 + static_cast<int>(bytes.below(3));
    def.iterations = 1 + static_cast<int>(bytes.below(4));
    if (bytes.flag()) def.cfl_number = 0.5f;
    def.max_substeps = 4;
    if (bytes.flag()) def.diffuse = DiffuseDef{.capacity = 200};
    return def;
  }

  template <class Id>
  Id pick(const std::vector<Id>& ids) {
    return ids.empty() ? Id{} : ids[bytes_.below(static_cast<std::uint32_t>(ids.size()))];
  }

  Pose pose() {
    Pose pose{bytes_.vector(-1.2f, 1.2f), {0, 0, 0, 1}};
    if (bytes_.flag()) pose.rotation = {0, 0.6f, 0, 0.8f};
    return pose;
  }

  Geometry geometry() {
    switch (bytes_.below(8)) {
      case 0:
        return BoxGeometry{bytes_.vector(0.05f, 0.4f)};
      case 1:
        return SphereGeometry{bytes_.number(0.05f, 0.4f)};
      case 2:
        return CapsuleGeometry{bytes_.number(0.05f, 0.3f), bytes_.number(0, 0.3f)};
      case 3:
        return CylinderGeometry{bytes_.number(0.05f, 0.3f), bytes_.number(0.05f, 0.3f)};
      case 4: {
        HullGeometry hull;
        for (int k = 0; k < 6; ++k) hull.points.push_back({step(), step(), step()});
        return hull;
      }
      case 5:
        return PlaneGeometry{bytes_.vector(-1, 1), bytes_.number(-1, 1)};
      case 6:
        return CompoundGeometry{{{BoxGeometry{{0.3f, 0.05f, 0.1f}}, {}}, {SphereGeometry{0.1f}, pose()}}};
      default:
        return ContainerGeometry{{1, 1, 1}, {}};
    }
  }

  /// A coordinate of a hull, whose field must stay small.
  float step() { return 0.05f * static_cast<float>(bytes_.below(9)) - 0.2f; }

  void create_body() {
    BodyDef def;
    def.geometry = geometry();
    def.pose = pose();
    if (bytes_.flag())
      def.motion = BodyMotion::kinematic;
    else
      def.velocity = bytes_.vector(-3, 3);
    def.density = bytes_.number(100, 3000);
    const float speed = std::hypot(def.velocity.x, def.velocity.y, def.velocity.z);
    if (std::isfinite(speed) && speed > 1000) return;  // a step has up to 256 substeps if it is near cloth
    bodies_.push_back(world_.create_body(def));
  }

  void create_cloth() {
    ClothDef def;
    const int n = 2 + static_cast<int>(bytes_.below(8));
    def.geometry = SheetGeometry{bytes_.number(0.3f, 1), bytes_.number(0.3f, 1), n, n + 1};
    def.pose = pose();
    def.velocity = bytes_.vector(-2, 2);
    if (bytes_.flag()) def.fabric.tear_strain = 0.1f;
    if (bytes_.flag()) def.fabric.absorbency = 0.5f;
    cloths_.push_back(world_.create_cloth(def));
  }

  void create_rope() {
    RopeDef def;
    def.points = {{-0.5f, 0, 0}, {0.5f, bytes_.number(-0.5f, 0.5f), 0}};
    def.segments = static_cast<int>(bytes_.below(12));
    def.pose = pose();
    def.radius = 0.02f;
    def.bends_and_twists = bytes_.flag();
    ropes_.push_back(world_.create_rope(def));
  }

  void attach() {
    AttachmentDef def;
    if (bytes_.flag())
      def.cloth = pick(cloths_);
    else
      def.rope = pick(ropes_);
    def.vertices = {bytes_.below(12), bytes_.below(70)};
    if (bytes_.flag()) def.region = Aabb{{-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f}};
    if (bytes_.flag()) def.body = pick(bodies_);
    if (bytes_.below(4) == 0) def.other_cloth = pick(cloths_);
    attachments_.push_back(world_.create_attachment(def));
  }

  void create_joint() {
    JointDef def;
    def.a = pick(bodies_);
    if (bytes_.flag()) def.b = pick(bodies_);
    def.frame = pose();
    switch (bytes_.below(5)) {
      case 0:
        def.kind = FixedJoint{};
        break;
      case 1:
        def.kind = HingeJoint{.motor_speed = bytes_.number(-5, 5), .motor_torque = bytes_.number(0, 5)};
        break;
      case 2:
        def.kind = SliderJoint{.motor_speed = bytes_.number(-1, 1), .motor_force = bytes_.number(0, 50)};
        break;
      case 3:
        def.kind = BallJoint{};
        break;
      default:
        def.kind = SpringJoint{bytes_.vector(0, 100), bytes_.vector(0, 10), {}, {}};
    }
    joints_.push_back(world_.create_joint(def));
  }

  void create_emitter() {
    EmitterDef def;
    def.fluid = pick(fluids_);
    def.opening = RectangleOpening{bytes_.number(0.1f, 0.6f), bytes_.number(0.1f, 0.6f)};
    if (std::get<RectangleOpening>(def.opening).width > 1 ||
        std::get<RectangleOpening>(def.opening).depth > 1)
      return;
    def.pose = pose();
    def.speed = bytes_.number(0.1f, 4);
    if (bytes_.flag()) def.body = pick(bodies_);
    def.most_particles = 200;
    if (def.speed > 100) return;  // so many arrivals a step are dear
    emitters_.push_back(world_.create_emitter(def));
  }

  void create_sink() {
    SinkDef def;
    def.region = BoxRegion{{-0.3f, -0.3f, -0.3f}, bytes_.vector(-0.2f, 0.5f)};
    def.pose = pose();
    if (bytes_.flag()) def.body = pick(bodies_);
    sinks_.push_back(world_.create_sink(def));
  }

  void add_fluid() {
    if (world_.particle_count() > most_particles) return;
    FluidVolumeDef def;
    def.fluid = pick(fluids_);
    const Vec3 lower = bytes_.vector(-1, 0.5f), size = bytes_.vector(0, 0.8f);
    if (!(size.x < 2 && size.y < 2 && size.z < 2)) return;
    def.region = BoxRegion{lower, {lower.x + size.x, lower.y + size.y, lower.z + size.z}};
    def.velocity = bytes_.vector(-2, 2);
    world_.add_fluid(def);
  }

  void step_world() {
    if (++steps_ > most_steps || substeps_ > most_substeps) return;
    constexpr float lengths[] = {1.0f / 60, 1e-4f, 0.1f, 0.004f, 0, -1};
    substeps_ += world_.step(lengths[bytes_.below(6)]).substeps;
  }

  void destroy() {
    switch (bytes_.below(7)) {
      case 0:
        return world_.destroy_body(pick(bodies_));
      case 1:
        return world_.destroy_cloth(pick(cloths_));
      case 2:
        return world_.destroy_rope(pick(ropes_));
      case 3:
        return world_.destroy_joint(pick(joints_));
      case 4:
        return world_.destroy_attachment(pick(attachments_));
      case 5:
        return world_.destroy_emitter(pick(emitters_));
      default:
        return world_.destroy_sink(pick(sinks_));
    }
  }

  void act() {
    const BodyId body = pick(bodies_);
    switch (bytes_.below(7)) {
      case 0:
        return world_.apply_impulse(body, bytes_.vector(-5, 5), bytes_.vector(-1, 1));
      case 1:
        return world_.apply_force(body, bytes_.vector(-50, 50), bytes_.vector(-1, 1));
      case 2:
        return world_.set_body_velocity(body, bytes_.vector(-5, 5), bytes_.vector(-5, 5));
      case 3:
        return world_.set_body_pose(body, pose());
      case 4:
        return world_.move_body(body, pose(), bytes_.number(0, 1));
      case 5:
        return world_.apply_torque(body, bytes_.vector(-5, 5));
      default: {
        const std::array vertices{bytes_.below(20), bytes_.below(20)};
        const std::array impulses{bytes_.vector(-0.1f, 0.1f), Vec3{0, 0, 0}};
        return world_.apply_impulses(pick(cloths_), vertices, impulses);
      }
    }
  }

  void look() {
    switch (bytes_.below(6)) {
      case 0:
        trace_.push_back(world_.cast_ray(bytes_.vector(-2, 2), bytes_.vector(-2, 2)).has_value());
        break;
      case 1: {
        const Overlaps found = world_.overlap_ball(bytes_.vector(-1, 1), bytes_.number(0.1f, 1));
        trace_.push_back(found.bodies.size() + 1000 * found.particles.size());
        break;
      }
      case 2:
        trace_.push_back(world_.diagnostics().contacts);
        break;
      case 3:
        trace_.push_back(world_.ellipsoids().size() + world_.pressures().size());
        break;
      case 4:
        trace_.push_back(world_.surface_mesh().triangles.size());
        break;
      default:
        trace_.push_back(world_.particle_contacts().size() + world_.solid_contacts().size());
    }
  }

  void make_call() {
    switch (bytes_.below(16)) {
      case 0:
      case 1:
        return create_body();
      case 2:
        return create_cloth();
      case 3:
        return create_rope();
      case 4:
        return attach();
      case 5:
        return create_joint();
      case 6:
        return create_emitter();
      case 7:
        return create_sink();
      case 8:
        return add_fluid();
      case 9: {
        FluidDef def;
        def.dynamic_viscosity = bytes_.number(0, 1000);
        def.surface_tension = bytes_.number(0, 1);
        fluids_.push_back(world_.create_fluid(def));
        return;
      }
      case 10:
        return destroy();
      case 11:
        return act();
      case 12:
        return look();
      case 13: {
        const std::span<const ParticleId> ids = world_.ids();
        if (ids.empty()) return;
        const std::array gone{ids[bytes_.byte() % ids.size()]};
        return world_.remove_particles(gone);
      }
      default:
        return step_world();
    }
  }

  Bytes bytes_;
  World world_;
  Trace trace_;
  int steps_ = 0, substeps_ = 0;
  std::vector<FluidId> fluids_;
  std::vector<BodyId> bodies_;
  std::vector<ClothId> cloths_;
  std::vector<RopeId> ropes_;
  std::vector<JointId> joints_;
  std::vector<AttachmentId> attachments_;
  std::vector<EmitterId> emitters_;
  std::vector<SinkId> sinks_;
};

}  // namespace
}  // namespace meniscus::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace meniscus::fuzz;
  const Trace one = Caller({data, size}, 1).run(), two = Caller({data, size}, 2).run();
  if (one == two) return 0;
  std::size_t at = 0;
  while (at < one.size() && at < two.size() && one[at] == two[at]) ++at;
  std::fprintf(stderr, "one thread and two differ at %zu of %zu and %zu\n", at, one.size(), two.size());
  std::abort();
}
