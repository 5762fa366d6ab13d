// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The harness of cloth that collides with itself, for one device.
#pragma once

#include <algorithm>
#include <cmath>

#include "pbd/solver.h"
#include "pbd/surface_tree/surface_tree.inl"
#include "tests/bench/harness/self_contact_bench.h"

namespace meniscus::tests {

namespace bench_kernels {

/// For each box, a row of flags by place in the tree.
struct MarkOverlaps {
  pbd::SurfaceTreeView tree;
  pbd::View<const Aabb> boxes;
  pbd::View<uint32_t> marks;

  MENISCUS_HD void operator()(uint32_t i) const {
    const uint32_t places = tree.triangles.count;
    pbd::for_each_overlap(tree, 0, boxes[i], 0, 0, [&](uint32_t place) { ++marks[i * places + place]; });
  }
};

/// The same by a warp a box.
struct MarkOverlapsInWarps {
  MarkOverlaps marked;

  MENISCUS_HD void operator()(uint32_t i) const {
    const uint32_t places = marked.tree.triangles.count;
    pbd::for_each_overlap_in_warp(
        marked.tree, 0, marked.boxes[i], [](uint32_t) { return true; },
        [&](uint32_t place) { ++marked.marks[i * places + place]; });
  }
};

}  // namespace bench_kernels

/// Edges at their lengths at rest, one after the other, on the host: slow, but it needs no colours.
template <class D>
class HostEdges final : public pbd::ConstraintSet<D> {
 public:
  explicit HostEdges(const ClothCase& cloth) {
    for (const pbd::SurfaceTriangle& t : cloth.triangles)
      for (const auto& [a, b] : {std::minmax(t.a, t.b), std::minmax(t.b, t.c), std::minmax(t.c, t.a)})
        edges_.push_back({a, b, length(cloth.rest[a] - cloth.rest[b])});
    const auto key = [](const Edge& e) { return std::pair(e.a, e.b); };
    std::sort(edges_.begin(), edges_.end(), [&](const Edge& e, const Edge& f) { return key(e) < key(f); });
    edges_.erase(std::unique(edges_.begin(), edges_.end(),
                             [&](const Edge& e, const Edge& f) { return key(e) == key(f); }),
                 edges_.end());
    x_.resize(cloth.vertices.size());
    moved_.resize(cloth.vertices.size());
  }

  void project(pbd::Substep<D>& s, int) override {
    const size_t bytes = x_.size() * sizeof(pbd::Vec4);
    s.device.copy_out(x_.data(), s.particles.position.data + s.particles.sorted, bytes);
    s.device.copy_out(moved_.data(), s.particles.accumulated_delta.data + s.particles.sorted, bytes);
    for (const Edge& e : edges_) {
      const Vec3 way = x_[e.b].xyz() - x_[e.a].xyz();
      const float l = length(way), w = x_[e.a].w + x_[e.b].w;
      if (w == 0 || l == 0) continue;
      const Vec3 impulse = (l - e.length) / (l * w) * way;
      move(e.a, impulse);
      move(e.b, -impulse);
    }
    s.device.copy_in(s.particles.position.data + s.particles.sorted, x_.data(), bytes);
    s.device.copy_in(s.particles.accumulated_delta.data + s.particles.sorted, moved_.data(), bytes);
  }

 private:
  struct Edge {
    uint32_t a, b;
    float length;
  };

  void move(uint32_t v, Vec3 impulse) {
    const Vec3 step = x_[v].w * impulse;
    x_[v] = pbd::with_w(x_[v].xyz() + step, x_[v].w);
    moved_[v] = pbd::with_w(moved_[v].xyz() + step, 0);
  }

  std::vector<Edge> edges_;
  std::vector<pbd::Vec4> x_, moved_;
};

template <class D>
class SelfContactBenchOn final : public SelfContactBench {
 public:
  template <class... Args>
  explicit SelfContactBenchOn(const ClothCase& cloth, Args... device_arguments)
      : device_(device_arguments...), solver_(device_, particles_, parameters(cloth)), edges_(cloth) {
    if (cloth.keeps_edges) solver_.add(edges_);
    solver_.add(contacts_);
    solver_.add(contacts_.ccd_failsafe());
    const auto count = static_cast<uint32_t>(cloth.vertices.size());
    solver_.reserve(count);
    std::vector<pbd::Vec4> velocities;
    for (Vec3 v : cloth.velocities) velocities.push_back(pbd::with_w(v, 0));
    const std::vector<pbd::Phase> phases(count, pbd::phase_vertex);
    particles_.set_vertices(cloth.vertices, velocities, phases);
    solver_.particles_changed(0, count);

    rest_.resize_discard(count);
    rest_.write(cloth.rest);
    float least = 1e30f;
    for (const pbd::Vec4& x : cloth.vertices)
      if (x.w > 0) least = std::min(least, x.w);
    contacts_.set_surface(cloth.triangles, cloth.rest, rest_.view(), cloth.pieces, 1 / least);
  }

  void step(float dt) override { solver_.step(dt); }
  std::vector<Vec3> positions() override { return fetched(particles_.position.current); }
  std::vector<Vec3> velocities() override { return fetched(particles_.velocity.current); }
  uint32_t most_candidates() override { return contacts_.most_candidates(); }
  uint32_t most_contacts() override { return contacts_.most_contacts(); }
  uint32_t most_crossings() override { return contacts_.most_crossings(); }
  uint32_t given_up() override { return contacts_.given_up(); }
  uint32_t listings() override { return contacts_.listings(); }
  uint32_t one_substep_listings() override { return contacts_.one_substep_listings(); }

  std::vector<std::vector<uint32_t>> overlaps(std::span<const pbd::Vec4> from, std::span<const pbd::Vec4> to,
                                              float reach, std::span<const Aabb> boxes,
                                              bool in_warps) override {
    pbd::Buffer<pbd::Vec4> previous = filled(from), position = filled(to);
    pbd::Buffer<Aabb> box = filled(boxes);
    pbd::ParticleView particles{};
    particles.previous = previous.view();
    particles.position = position.view();
    tree_.refit(pbd::PathBoxes(particles, reach));
    pbd::Buffer<uint32_t> marks(device_, "marks");
    marks.resize_discard(boxes.size() * tree_.places());
    marks.fill(0);
    const bench_kernels::MarkOverlaps kernel{tree_.view(), box.view(), marks.view()};
    const auto count = static_cast<uint32_t>(boxes.size());
    if (in_warps)
      pbd::parallel_for_teams<pbd::SearchTeam>(device_, "overlaps", count,
                                               bench_kernels::MarkOverlapsInWarps{kernel});
    else
      device_.parallel_for("overlaps", count, kernel);
    const std::vector<uint32_t> all = marks.read(marks.size());
    std::vector<std::vector<uint32_t>> found(boxes.size());
    for (size_t n = 0; n < all.size(); ++n)
      found[n / tree_.places()].insert(found[n / tree_.places()].end(), all[n],
                                       tree_.order()[n % tree_.places()]);
    for (std::vector<uint32_t>& row : found) std::sort(row.begin(), row.end());
    return found;
  }

 private:
  static pbd::SolverParameters parameters(const ClothCase& cloth) {
    pbd::SolverParameters p;
    p.gravity = cloth.gravity;
    p.substeps = cloth.substeps;
    p.iterations = cloth.iterations;
    return p;
  }

  template <class T>
  pbd::Buffer<T> filled(std::span<const T> values) {
    pbd::Buffer<T> buffer(device_, "bench");
    buffer.resize_discard(values.size());
    buffer.write(values);
    return buffer;
  }

  std::vector<Vec3> fetched(const pbd::Buffer<pbd::Vec4>& buffer) {
    std::vector<Vec3> values;
    for (const pbd::Vec4& v : buffer.read(particles_.count())) values.push_back(v.xyz());
    return values;
  }

  D device_;
  pbd::Particles particles_{device_};
  pbd::Solver<D> solver_;
  HostEdges<D> edges_;
  pbd::Buffer<Vec3> rest_{device_, "rest"};
  pbd::SurfaceTree<D> tree_{device_};
  cloth::SelfContacts<D> contacts_{device_, tree_};
};

}  // namespace meniscus::tests
