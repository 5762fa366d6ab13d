// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The harness of cloth on bodies, for one device.
#pragma once

#include "cloth/solve/cloth_set.h"
#include "collision/body/attachments.h"
#include "collision/body/body_set.h"
#include "collision/body/face_points.h"
#include "collision/sdf/mesh_fields.h"
#include "pbd/solver.h"
#include "tests/bench/harness/cloth_solid_bench.h"
#include "tests/bench/harness/cloth_solid_parts.h"

namespace meniscus::tests {

template <class D>
class ClothSolidBenchOn final : public ClothSolidBench {
 public:
  template <class... Args>
  explicit ClothSolidBenchOn(const ClothSolidSetup& setup, Args... args)
      : device_(args...), rigid_({setup.gravity, 1, 10}), solver_(device_, particles_, parameters(setup)) {
    solver_.add(static_cast<pbd::ContactSource<D>&>(attachments_));
    solver_.add(shapes_);
    solver_.add(static_cast<pbd::ConstraintSet<D>&>(attachments_));
    solver_.add(static_cast<pbd::ConstraintSet<D>&>(cloth_));
    if (setup.face_points)
      solver_.add(faces_);
    else
      solver_.add(contacts_);
    solver_.add(attachments_.release());
    solver_.add(bodies_);
    solver_.add(static_cast<pbd::Observer<D>&>(cloth_));
    solver_.add(static_cast<pbd::Observer<D>&>(attachments_));
    add_cloth(setup);
    add_solids(setup);
    attachments_.set_attachments(setup.attachments);
    shapes_.set_attached_bodies(attachments_.attached_bodies());
  }

  void step(float dt) override { solver_.step(dt); }
  std::vector<Vec3> positions() override { return read(particles_.position.current); }
  std::vector<Vec3> velocities() override { return read(particles_.velocity.current); }
  std::vector<Vec3> reactions() override { return cloth_.read_reactions(); }
  std::vector<Vec3> attachment_impulses() override { return attachments_.read_impulses(); }
  collision::RigidWorld& rigid() override { return rigid_; }
  uint32_t points_wanted() override { return faces_.wanted(); }
  MemoryUse memory() override { return device_.memory(); }

 private:
  static pbd::SolverParameters parameters(const ClothSolidSetup& setup) {
    pbd::SolverParameters p;
    p.gravity = setup.gravity;
    p.support_radius = 0.1f;
    p.contact_radius = 0.025f;
    p.substeps = setup.substeps;
    p.iterations = setup.iterations;
    return p;
  }

  void add_cloth(const ClothSolidSetup& setup) {
    const cloth::ClothModel model = cloth_model(setup);
    std::vector<pbd::Vec4> position, velocity;
    for (Vec3 v : setup.mesh.vertices) {
      position.push_back(pbd::with_w(v, 1 / model.constraints.masses[position.size()]));
      velocity.push_back(pbd::with_w(setup.velocity, 0));
    }
    for (uint32_t v : setup.held) position[v].w = velocity[v].x = velocity[v].y = velocity[v].z = 0;
    const auto vertices = static_cast<uint32_t>(position.size());
    solver_.reserve(0, vertices);
    particles_.set_vertices(position, velocity, std::vector<pbd::Phase>(vertices, pbd::phase_vertex));
    cloth_.set_model(model);
    const collision::Touch touch{{}, setup.radius};
    shapes_.set_pieces({&touch, 1});
    faces_.set_surface(cloth_.surface());
    solver_.particles_changed(0, vertices);
  }

  void add_solids(const ClothSolidSetup& setup) {
    std::vector<collision::Shape> shapes;
    std::vector<collision::CarriedShape> carried;
    uint32_t fixed = 0;
    for (const SolidSetup& solid : setup.solids) {
      collision::Shape shape = shape_of(solid);
      if (solid.mesh) shape.table = fields_.acquire(device_, *solid.mesh, 0.015f, 0, 0.1f, 0.1f);
      if (solid.motion == SolidSetup::Motion::fixed) {
        shape.bounds = collision::world_box(solid.pose, local_bounds(solid));
        ++fixed;
      } else {
        const uint32_t body = rigid_.add_body(body_of(solid));
        shape.owner = shape.body = body;
        carried.push_back({static_cast<uint32_t>(shapes.size()), body, inverse(rigid_.mass(body).principal),
                           local_bounds(solid)});
      }
      shapes.push_back(shape);
    }
    const std::vector<collision::SdfView> fields = fields_.views();
    shape_buffer_.resize_discard(shapes.size());
    shape_buffer_.write(shapes);
    field_buffer_.resize_discard(fields.size());
    field_buffer_.write(fields);
    shapes_.set_shapes({shape_buffer_.view(), fixed, {}, field_buffer_.view(), {}}, shapes.empty());
    bodies_.set_shapes(carried, shape_buffer_.view());
  }

  std::vector<Vec3> read(const pbd::Buffer<pbd::Vec4>& from) {
    std::vector<Vec3> out;
    for (const pbd::Vec4& v : from.read(particles_.count())) out.push_back(v.xyz());
    return out;
  }

  D device_;
  collision::RigidWorld rigid_;
  pbd::Particles particles_{device_};
  pbd::Solver<D> solver_;
  collision::ShapeContacts<D> shapes_{device_, particles_, 0.1f, 0.025f};
  collision::BodySet<D> bodies_{device_, rigid_, shapes_};
  collision::ContactSet<D> contacts_{device_};
  collision::FacePoints<D> faces_{device_, particles_, shapes_, bodies_, contacts_};
  collision::BodyAttachments<D> attachments_{device_, bodies_};
  cloth::ClothSet<D> cloth_{device_, {}};
  collision::MeshFields<D> fields_;
  pbd::Buffer<collision::Shape> shape_buffer_{device_, "shapes"};
  pbd::Buffer<collision::SdfView> field_buffer_{device_, "fields"};
};

}  // namespace meniscus::tests
