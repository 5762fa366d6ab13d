// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Solves isometric bending as one block, once a substep.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "cloth/build/cloth_model.h"
#include "cloth/solve/bending_block_kernels.h"
#include "pbd/device/buffer.h"
#include "pbd/repeated.h"
#include "pbd/substep.h"

namespace meniscus::cloth {

/// Moves all vertices to where their inertia and bending balance, with the constant matrix Q of isometric
/// bending and positional impulses P:
///
///   P = −h² Q (x + γ (x − x₀)),  x = x̃ + M⁻¹ P        or  (1 + h² (1 + γ) Q M⁻¹) P = −h² Q (x̃ + γ (x̃ − x₀))
///
/// Held vertices have M⁻¹ = 0, and their P is their reaction. The eigenvalues of this matrix lie between 1
/// and 1 + h² (1 + γ) times the fastest rate of bending. So a fixed polynomial of it solves the equation: no
/// sums over vertices, the same bits for any number of threads, and each step conserves momentum.
template <class D>
class BendingSolver {
 public:
  explicit BendingSolver(D& device) : device_(device) {}

  /// `one`: the model of one world, without the constraints that chains and clusters took. `all`: of all
  /// worlds.
  void set_model(const ClothModel& one, const ClothModel& all);
  /// `pieces`: the same as the model's.
  void solve(pbd::Substep<D>& substep, const VertexState& vertices);
  /// By piece of a world, the least part of its bending stiffness that substeps have resolved since the model
  /// was set.
  const std::vector<float>& fractions() const { return fractions_; }
  void visit_state(pbd::StateVisitor& v) {
    v.value("counted_dt", counted_dt_);
    v.value("count", count_);
    v.list("fractions", fractions_);
  }

 private:
  template <class T>
  static void upload(pbd::Buffer<T>& buffer, const std::vector<T>& values) {
    buffer.resize_discard(values.size());
    buffer.write(values);
  }
  uint32_t count_steps(float dt);

  D& device_;
  uint32_t vertex_count_ = 0;  // 0: nothing bends
  std::vector<BendingRate> rates_;
  std::vector<float> fractions_;
  float counted_dt_ = 0;  // s, that of the last count
  uint32_t count_ = 0;
  pbd::Buffer<BendingRate> device_rates_{device_, "bending matrix"};
  pbd::Buffer<uint32_t> slice_start_{device_, "bending matrix"}, column_{device_, "bending matrix"};
  pbd::Buffer<float> value_{device_, "bending matrix"};
  pbd::Buffer<bending_block_kernels::Step> steps_{device_, "bending solve"};
  pbd::Buffer<bending_block_kernels::PieceBending> pieces_{device_, "bending solve"};
  pbd::Buffer<Vec4> right_{device_, "bending solve"}, impulse_{device_, "bending solve"},
      other_impulse_{device_, "bending solve"};
};

template <class D>
void BendingSolver<D>::set_model(const ClothModel& one, const ClothModel& all) {
  const auto& hinges = one.constraints.isometric;
  const std::vector<float>& masses = one.constraints.masses;
  rates_ = bending_rates(bending_matrix(hinges, masses), hinges, masses, one.pieces);
  const BendingMatrix matrix = bending_matrix(all.constraints.isometric, all.constraints.masses);
  fractions_.assign(rates_.size(), 1);
  counted_dt_ = 0;
  vertex_count_ = hinges.empty() ? 0 : static_cast<uint32_t>(all.constraints.masses.size());
  upload(slice_start_, matrix.slice_start);
  upload(column_, matrix.column);
  upload(value_, matrix.value);
  const auto worlds = static_cast<uint32_t>(one.pieces.empty() ? 1 : all.pieces.size() / one.pieces.size());
  pbd::write_repeated(device_rates_, std::span<const BendingRate>(rates_), worlds);
  const size_t pieces = vertex_count_ > 0 ? device_rates_.size() : 0;
  pieces_.resize_discard(pieces);
  steps_.resize_discard(pieces * cloth_tuning::most_bending_steps);
  for (auto* buffer : {&right_, &impulse_, &other_impulse_}) buffer->resize_discard(vertex_count_);
}

template <class D>
void BendingSolver<D>::solve(pbd::Substep<D>& substep, const VertexState& vertices) {
  using namespace bending_block_kernels;
  if (vertex_count_ == 0) return;
  const uint32_t count = count_steps(substep.dt);
  device_.parallel_for("cloth/plan bending", static_cast<uint32_t>(device_rates_.size()),
                       Plan{device_rates_.view(), substep.dt, count, steps_.view(), pieces_.view()});
  const Block block{{slice_start_.view(), column_.view(), value_.view()},
                    vertices,
                    steps_.view(),
                    pieces_.view(),
                    right_.view()};
  View<Vec4> from = impulse_.view(), next = other_impulse_.view();
  device_.parallel_for("cloth/bend", vertex_count_, Start{block, from});
  for (uint32_t k = 1; k < count; ++k) {
    device_.parallel_for("cloth/bend", vertex_count_, Continue{block, from, next, k, k + 1 == count});
    std::swap(from, next);
  }
}

/// Steps for the piece that needs most.
template <class D>
uint32_t BendingSolver<D>::count_steps(float dt) {
  using namespace bending_block_kernels;
  if (dt == counted_dt_) return count_;
  uint32_t count = 2;
  for (const BendingRate& rate : rates_) {
    const float last = fastest_of(rate, dt);
    while (count < cloth_tuning::most_bending_steps && !Polynomial(last, count).holds_all) ++count;
  }
  for (size_t p = 0; p < rates_.size(); ++p)
    fractions_[p] = std::min(fractions_[p], Polynomial(fastest_of(rates_[p], dt), count).fraction());
  counted_dt_ = dt;
  return count_ = count;
}

}  // namespace meniscus::cloth
