// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The simulation on one device: how the modules of a world are put together and stepped.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "cloth/rods/rod_set.h"
#include "cloth/rods/rope_set.h"
#include "cloth/self_contact/self_contacts.h"
#include "collision/body/attachments.h"
#include "collision/body/body_set.h"
#include "collision/body/body_zones.h"
#include "collision/body/effective_mass.h"
#include "collision/body/face_points.h"
#include "collision/body/stick_anchors.h"
#include "collision/contact/contact_set.h"
#include "collision/contact/shape_contacts.h"
#include "collision/film/film_set.h"
#include "collision/fluid_cloth/fluid_cloth_set.h"
#include "collision/grains/grain_set.h"
#include "collision/sdf/mesh_fields.h"
#include "collision/sdf/mesh_sampling.h"
#include "fluid/forces/smoothing_pass.h"
#include "fluid/forces/surface_tension_set.h"
#include "fluid/forces/viscosity_set.h"
#include "fluid/surface/anisotropy.h"
#include "pbd/device/access.h"
#include "pbd/pipeline.h"
#include "pbd/removal.h"
#include "sdk/engine/diffuse_walls.h"
#include "sdk/engine/driven_surfaces.h"
#include "sdk/engine/engine.h"
#include "sdk/engine/engine_kernels.h"
#include "sdk/engine/force_fields/force_fields.h"
#include "sdk/engine/free_room.h"
#include "sdk/engine/jets.h"
#include "sdk/engine/particle_items.h"
#include "sdk/engine/phases.h"
#include "sdk/engine/pistons.h"
#include "sdk/engine/rank_calls.h"
#include "sdk/engine/sinks.h"

namespace meniscus {

/// The simulation on device D: the solver, and the phases that a world registers with it.
template <class D>
class DeviceEngine final : public Engine {
 public:
  template <class... Args>
  explicit DeviceEngine(const EngineDef& def, Args... device_arguments)
      : device_(device_arguments...),
        def_(def),
        solver_(device_, particles_, def.solver),
        contacts_(device_, particles_, def.solver.support_radius, def.solver.contact_radius),
        bodies_(device_, *def.rigid, contacts_),
        forces_(device_, *def.rigid, bodies_),
        driven_(device_, *def.rigid),
        attachments_(device_, bodies_),
        films_(device_, {def.particle_spacing, def.solver.contact_radius, def.solver.support_radius},
               contacts_, bodies_),
        effective_mass_(device_, bodies_),
        stick_anchors_(device_, bodies_),
        density_(device_, def.kernel, def.density),
        cloth_(device_, def.cloth),
        rods_(device_),
        ropes_(device_),
        tree_(device_),
        self_contacts_(device_, tree_),
        contact_set_(device_),
        grains_(device_, def.particle_spacing, contact_set_),
        face_points_(device_, particles_, contacts_, bodies_, contact_set_),
        body_zones_(device_, contacts_, bodies_),
        fluid_cloth_contacts_(device_, particles_, def.solver.support_radius),
        fluid_cloth_(device_, particles_, fluid_cloth_contacts_),
        tension_(device_, def.kernel, def.particle_spacing),
        viscosity_(device_, def.kernel, def.particle_spacing),
        smoothing_(device_, def.kernel, &density_),
        probes_(device_, density_, def.particle_spacing, def.solver.periodic),
        mesher_(device_),
        removal_(device_),
        sinks_(device_),
        jets_(device_),
        pistons_(device_, density_),
        free_room_(device_, def.particle_spacing, def.solver.contact_radius) {
    films_.set_fluid([this](const pbd::Substep<D>& substep) -> collision::FluidMultipliers {
      density_.refresh_multipliers(substep.ghosts);
      using Multiplier = fluid::density_kernels::Multiplier;
      return {&density_.multipliers().data->value, sizeof(Multiplier) / sizeof(float),
              def_.kernel.particle_volume};
    });
    viscosity_.set_vertex_means(fluid_cloth_);
    assemble();
    if (def.diffuse) add_diffuse(*def.diffuse);
    reserve(0, 1);
  }

  pbd::Device& device() override { return device_; }
  int ordinal() const override { return pbd::DeviceAccess<D>::ordinal(device_); }
  void* stream() override { return pbd::DeviceAccess<D>::stream(device_); }
  std::shared_ptr<void> allocate_lasting(size_t bytes) override;
  uint32_t particle_count() const override {
    if (held_) return static_cast<uint32_t>(held_->position.size());
    return ranks_ ? all_particles_ : particles_.sorted();
  }

  void set_solvers(const EngineDef& def) override;
  void set_materials(std::span<const ParticleMaterial> materials) override;
  uint32_t add_sdf(const collision::TriangleMesh& mesh, float cell_size, float max_error,
                   float margin) override;
  uint32_t add_height_field(uint32_t columns, uint32_t rows, float cell_size,
                            std::span<const float> heights) override;
  void remove_sdf(uint32_t number) override { mesh_fields_.release(number); }
  std::size_t sdf_nodes(uint32_t number) const override { return mesh_fields_.views()[number].nodes.count(); }
  void remove_height_field(uint32_t number) override { height_samples_[number].reset(); }
  void set_shapes(const SolidShapes& solids) override;
  void place_bodies() override;
  std::span<const collision::RigidImpulse> body_forces() const override { return bodies_.mean_forces(); }
  std::vector<ContactReadout> read_contacts() override;
  void forget_contacts(uint32_t solid, TouchedKind kind) override;
  void visit_state(pbd::StateVisitor& v) override;
  void set_sinks(std::span<const Sink> sinks) override;
  std::vector<bool> take_sinks(std::span<uint32_t> taken, std::vector<uint32_t>& takers) override;
  void set_force_fields(std::span<const ForceFieldModel> fields, std::span<const float> body_densities,
                        const VertexVolumes& volumes) override {
    forces_.set(fields, body_densities, volumes);
  }
  void set_probes(std::span<const fluid::Probe> probes) override;
  void read_probes(std::span<fluid::ProbeSum> means) override;

  std::vector<Vec3> fill_mesh(const collision::TriangleMesh& mesh, float spacing) override;
  std::vector<float> solid_distances(std::span<const Vec3> points, float reach,
                                     const CollisionFilter& filter) override;
  std::optional<NearestSolid> nearest_solid(Vec3 point, float reach) override;

  void set_cloth(const EngineCloth& cloth) override { set_cloth(cloth, 1); }
  void set_wind(const cloth::Wind& wind) override { cloth_.set_wind(wind); }
  void read_vertices(std::span<Vec3> positions, std::span<Vec3> velocities) override;
  std::vector<cloth::SegmentState> read_segments() override { return rods_.states(0, rods_.segment_count()); }
  std::vector<Vec3> read_reactions() override { return cloth_.read_reactions(); }
  std::vector<Vec3> read_attachment_impulses() override { return attachments_.read_impulses(); }
  std::vector<collision::WettingTouch> read_wetting() override {
    return fluid_cloth_contacts_.read_wetting(solver_.contacts().contacts);
  }
  void weigh_vertices(uint32_t first, std::span<const float> inverse_masses,
                      std::span<const Vec3> velocities) override;
  bool found_tears() override { return cloth_.found_tears(); }
  const std::vector<float>& bending_fractions() const override { return cloth_.bending_fractions(); }

  void make_room(uint32_t more) override;
  void find_room(std::span<const Arrival> arrivals, std::vector<uint8_t>& has_room) override;
  void append(const ParticleBatch& batch) override;
  void set_pistons(std::span<const Piston> pistons, std::span<const PistonParticle> particles) override;
  void keep(const std::vector<bool>& keep) override;
  void begin_step(float dt, int iterations) override;
  EngineStep end_step() override;
  void set_hooks(const HookCalls& calls) override;
  void relax(float dt, int iterations) override {
    fetch_contacts();
    solver_.relax(dt, iterations);
    if (iterations > 0) rods_.stop();
  }
  void relax_from(uint32_t slot, float dt, int iterations) override {
    release();
    fetch_contacts();
    solver_.relax_from(slot, dt, iterations);
  }

  collision::RigidWorlds& rigid_worlds() override { return bodies_.worlds(); }
  void make_worlds(const SolidShapes& solids, const EngineCloth& cloth,
                   const VertexNumbers& numbers) override;
  LastSubsteps last_substeps() const override;
  void continue_from(const LastSubsteps& last) override;
  void find_substeps(float dt, std::span<int> out) override;
  void place_worlds(std::span<const uint32_t> chosen) override;
  void set_gravities(std::span<const Vec3> gravities) override;
  void reset_worlds(std::span<const uint32_t> chosen) override;
  void undo_worlds(std::span<const uint32_t> chosen) override;
  void count_non_finite(std::span<uint32_t> counts) override;
  void hash_worlds(std::span<uint64_t> hashes) override;
  void visit_worlds(pbd::StateVisitor& v) override;
  EngineWorld read_world(uint32_t world) override;
  void write_world(uint32_t world, const EngineWorld& state) override;
  bool any_crowd() const override { return (held_ && held_->may_crowd) || density_.any_crowd(); }
  void write_vectors(Vec3* positions, Vec3* velocities) override;
  void write_vertices(Vec3* positions, Vec3* velocities) override;

  void push_particles(std::span<const uint32_t> slots, std::span<const Vec3> impulses) override;
  void place_particles(std::span<const uint32_t> slots, std::span<const Vec3> positions) override;
  void set_particle_velocities(std::span<const uint32_t> slots, std::span<const Vec3> velocities) override;
  void push_vertices(std::span<const uint32_t> vertices, std::span<const Vec3> impulses) override;

  void read_positions(std::span<Vec3> out) override {
    if (held_) return copy_held(out);
    together({RankCall::positions}, [&] { read_vector(particles_.position.current.view(), out); });
  }
  void read_velocities(std::span<Vec3> out) override {
    together({RankCall::velocities}, [&] { read_vector(particles_.velocity.current.view(), out); });
  }
  void read_fluids(std::span<uint32_t> out) override;
  uint64_t hash_particles() override;
  void read_pressures(std::span<float> out, float dt) override;
  EngineMeasure read_density_errors(std::span<float> error, std::span<float> full) override;
  void read_ellipsoids(std::span<Ellipsoid> out) override;
  void write_particles(const ParticleArrays& arrays) override;
  void write_arrays(const EngineArrays& arrays, std::span<const ParticleId> ids) override;
  SurfaceMesh read_surface(const fluid::SurfaceField& field, std::optional<uint32_t> group) override;
  uint32_t diffuse_count() const override { return diffuse_ ? diffuse_->count() : 0; }
  uint32_t diffuse_refused() const override { return diffuse_ ? diffuse_->refused() : 0; }
  void read_diffuse(std::span<DiffuseParticle> out) override;
  Diagnostics measure(Vec3 gravity) override;

  void hold_back() override {
    if (particles_.count() == 0) held_.emplace();
  }
  void release() override;
  void share(pbd::Ranks& ranks, const pbd::CutPolicy& policy) override;
  uint32_t own_particles() const override { return particles_.sorted(); }
  std::vector<uint32_t> particles_by_rank() override;
  OwnParticles read_own_particles() override;
  std::vector<uint64_t> write_particle_items(const std::string& file,
                                             std::span<const uint64_t> offsets) override;
  bool follow() override;
  void pause_following() override {
    guarded(ranks_, [&] { announce({RankCall::pause}); });
  }
  void end_following() override;

 private:
  /// Registers all phases with the solver; throws std::logic_error if a phase is missing or registered twice.
  void assemble();
  void add_diffuse(const fluid::DiffuseParameters& parameters);
  void set_cloth(const EngineCloth& cloth, uint32_t worlds);
  void number_vertices(uint32_t each);
  void read_vertices_of(uint32_t world, EngineWorld& state);
  void write_vertices_of(uint32_t world, const EngineWorld& state);
  void visit_parts_of(uint32_t world, pbd::StateVisitor& v);
  void set_cloth_with_fluid(const EngineCloth& cloth, uint32_t worlds, float heaviest);
  void note_overlapping();
  void note_overlapping(pbd::View<const uint32_t> chosen_worlds);
  void reserve(uint32_t fluid, uint32_t vertices);
  void reserve_more(uint32_t more);
  void reserve_readouts(uint32_t fluid);
  void release_readouts();
  template <class Kernel>
  void push(uint32_t count, std::span<const uint32_t> who, std::span<const Vec3> impulses);
  void read_vector(pbd::View<const pbd::Vec4> from, std::span<Vec3> out);
  EngineMeasure measure_density(std::span<float> error, std::span<float> full);
  engine_kernels::StateSum sum_states(Vec3 gravity);
  std::vector<uint32_t> remove_marked(uint32_t kept);
  void fetch_contacts();
  void keep_contacts(std::span<const uint32_t> stays, std::span<uint32_t> place);
  Overflows overflows() const;  // of the last step
  void follow(const RankCommand& command);
  void announce(const RankCommand& command);
  struct Taken {
    uint32_t slot, sink;
  };
  std::vector<Taken> take_own(std::span<uint32_t> taken, uint32_t& kept);
  std::vector<bool> take_sinks_among_ranks(std::span<uint32_t> taken, std::vector<uint32_t>& takers);
  void note_waiting(std::span<const Arrival> arrivals);
  void find_room_among_ranks(std::span<const Arrival> arrivals, std::vector<uint8_t>& has_room);
  void append_among_ranks(const ParticleBatch& batch);
  void hold(const ParticleBatch& batch);
  void keep_held(const std::vector<bool>& keep);
  void copy_held(std::span<Vec3> out) const;
  void share_held(pbd::Ranks& ranks, const pbd::CutPolicy& policy);
  void keep_among_ranks(const std::vector<bool>& keep);
  void remove_among_ranks(std::span<const uint32_t> gone, uint32_t kept);
  std::vector<DiffuseParticle> gather_diffuse();
  std::pair<bool, std::vector<uint64_t>> write_own_items(const std::string& file,
                                                         std::span<const uint64_t> offsets);
  template <class Work>
  decltype(auto) guarded(pbd::Ranks* ranks, const Work& work);
  template <class Work>
  decltype(auto) together(const RankCommand& command, const Work& work);
  pbd::View<const uint32_t> readout_places();
  std::vector<uint32_t> slots_by_place();
  template <class T>
  void deliver(const pbd::Buffer<T>& values, const std::vector<uint32_t>& slots, std::span<T> out);

  template <class T>
  static void replace(pbd::Buffer<T>& buffer, std::span<const T> values) {
    buffer.resize_discard(static_cast<uint32_t>(values.size()));
    buffer.write(values);
  }

  D device_;
  EngineDef def_;
  pbd::Particles particles_{device_};
  pbd::Solver<D> solver_;
  collision::ShapeContacts<D> contacts_;
  collision::BodySet<D> bodies_;
  ForceFields<D> forces_;
  DrivenSurfaces<D> driven_;
  collision::BodyAttachments<D> attachments_;
  collision::FilmSet<D> films_;
  collision::EffectiveMass<D> effective_mass_;
  collision::StickAnchors<D> stick_anchors_;
  fluid::DensitySet<D> density_;
  cloth::ClothSet<D> cloth_;
  cloth::RodSet<D> rods_;
  cloth::RopeSet<D> ropes_;
  pbd::SurfaceTree<D> tree_;
  cloth::SelfContacts<D> self_contacts_;
  collision::ContactSet<D> contact_set_;
  collision::GrainSet<D> grains_;
  collision::FacePoints<D> face_points_;
  collision::BodyZones<D> body_zones_;
  collision::FluidClothContacts<D> fluid_cloth_contacts_;
  collision::FluidClothSet<D> fluid_cloth_;
  fluid::SurfaceTensionSet<D> tension_;
  fluid::ViscositySet<D> viscosity_;
  fluid::SmoothingPass<D> smoothing_;
  fluid::Probes<D> probes_;
  fluid::SurfaceMesher<D> mesher_;
  std::optional<fluid::Diffuse<D>> diffuse_;
  pbd::Removal<D> removal_;
  Sinks<D> sinks_;
  Jets<D> jets_;
  Pistons<D> pistons_;
  FreeRoom<D> free_room_;

  pbd::Ranks* ranks_ = nullptr;        // of a shared world
  uint32_t all_particles_ = 0;         // of all ranks, in a shared world
  std::optional<ParticleBatch> held_;  // until the world is shared

  float last_substep_ = 0;  // s
  float begun_step_ = 0;    // s, of the step that was begun
  int begun_iterations_ = 0;
  uint32_t fluid_capacity_ = 0, vertex_capacity_ = 0;
  std::vector<ContactReadout> fetched_contacts_;
  std::vector<std::pair<uint32_t, TouchedKind>> forgotten_;  // solids of the last step that are gone
  bool contacts_fetched_ = true;
  bool any_overlapping_ = true;  // since the last step began: see note_overlapping()
  uint32_t sorted_in_step_ = 0;  // fluid particles in the last step; particles added since have no contacts
  collision::ShapeSet shape_set_;
  collision::MeshFields<D> mesh_fields_;
  std::vector<std::optional<pbd::Buffer<float>>> height_samples_;
  std::vector<collision::HeightFieldView> height_views_;
  pbd::Buffer<collision::Shape> shapes_{device_, "shapes"};
  pbd::Buffer<collision::PlaneOpening> openings_{device_, "openings"};
  pbd::Buffer<collision::SdfView> sdfs_{device_, "distance fields"};
  pbd::Buffer<collision::HeightFieldView> height_fields_{device_, "height fields"};

  pbd::Buffer<uint32_t> places_{device_, "places"};  // of a shared world: 0, 1, 2, …
  pbd::Buffer<Vec3> vector_out_{device_, "read-out"};
  pbd::Buffer<float> scalar_out_{device_, "read-out"};
  pbd::Buffer<float> full_out_{device_, "read-out"};
  pbd::Buffer<uint32_t> index_out_{device_, "read-out"};
  pbd::Buffer<Ellipsoid> ellipsoid_out_{device_, "read-out"};
  pbd::Buffer<uint64_t> count_out_{device_, "totals"};
  pbd::Buffer<engine_kernels::StateSum> state_sum_{device_, "state sum"};

  // Of a batch, by world.
  pbd::Buffer<uint32_t> chosen_worlds_{device_, "chosen worlds"}, bad_worlds_{device_, "failed worlds"};
  pbd::Buffer<int64_t> world_hashes_{device_, "world hashes"};
  pbd::Buffer<pbd::Vec4> world_gravities_{device_, "world gravities"};
  pbd::Buffer<uint64_t> vertex_numbers_{device_, "vertex numbers"};  // of one world
  uint32_t pieces_of_world_ = 0;
};

}  // namespace meniscus

#include "sdk/engine/engine_access.inl"
#include "sdk/engine/engine_assembly.inl"
#include "sdk/engine/engine_cloth.inl"
#include "sdk/engine/engine_held.inl"
#include "sdk/engine/engine_particles.inl"
#include "sdk/engine/engine_rank_flow.inl"
#include "sdk/engine/engine_ranks.inl"
#include "sdk/engine/engine_readout.inl"
#include "sdk/engine/engine_setters.inl"
#include "sdk/engine/engine_shapes.inl"
#include "sdk/engine/engine_state.inl"
#include "sdk/engine/engine_worlds.inl"
