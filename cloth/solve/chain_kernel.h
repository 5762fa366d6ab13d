// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernel that solves for all edges of a chain at once.
#pragma once

#include "cloth/solve/chains_at_once.h"
#include "cloth/solve/edge_compliance.h"
#include "cloth/solve/load_kernels.h"
#include "cloth/solve/tuning.h"
#include "cloth/solve/vertex_state.h"

namespace meniscus::cloth {

using pbd::gather_words;
using pbd::inverse_sqrt;
using pbd::max;
using pbd::scatter;
using pbd::square_root;
using pbd::Vec3Of;
using pbd::Vec4Of;

/// What a solve of chains continues from.
enum class ChainStage : uint32_t {
  absorbs_pending,    ///< no multipliers; pushes are pending
  starts,             ///< no multipliers
  follows_absorbing,  ///< the pushes that absorbed the pending ones. These stand in the multiplier beside λ
                      ///< of the last substep, which serves only as the tension of the chain.
  continues,          ///< the last solve of the substep
};

/// XPBD for all edges of a chain at once (the direct solve of Deul et al. 2018, for points), with the
/// geometric stiffness of taut edges (Tournier et al. 2015). An edge with multiplier λ and length l that
/// turns by Δd across itself pushes with λ Δd/l. Without this term a taut chain flies to the sides wherever
/// λ/(m l) is not small. A light vertex between heavy ones would then seem to yield to any pull.
///
/// 1. Lengths. n are the directions of the edges, and t is the direction of the chain at a vertex. With
///    W = w (t tᵀ + s (1 − t tᵀ)) and s = 1/(1 + w Σ|λ|/l) from the last λ, row k of (J W Jᵀ + A) Δλ = −C − A
///    λ is
///
///      −n_k₋₁ᵀ W_k n_k Δλ_k₋₁ + (n_kᵀ (W_k + W_k₊₁) n_k + α̃) Δλ_k − n_kᵀ W_k₊₁ n_k₊₁ Δλ_k₊₁ = −C_k − α̃ λ_k
///
///    with damping as in xpbd_step.
/// 2. Lateral displacements y: (1 + w G) y = w f. f is the part of the vertices' pushes across the chain,
///    which results from the turning of λ. G is the Laplacian of |λ|/l. Edges then push with λ n − |λ|/l Δy.
///    They push in pairs, so that momentum is conserved. An effective mass m behind a vertex
///    (Substep::effective_mass) resists as well. It is added to Σ|λ|/l in s, the row of y is
///    (1 + w G + w m) y = w f, and the mass gets m y.
/// 3. Bound. Both steps hold only while edges turn by little. A light vertex between heavy ones might move
///    further than its edge is long. The whole chain then takes the fraction of its step that moves the
///    vertex by exactly that length.
///
/// Pushes may be pending (ClothSet::start_from_last). The chain then absorbs what they would do to its
/// lengths, and no more. Its own pushes are added to them, and nothing moves. Other errors of length are left
/// to the next solve, which turns edges as well. Without turning, a taut chain under a heavy body flies to
/// the sides.
///
/// Compressed edges are lengthened in full, just as stretched edges are shortened. If only one of the two
/// were corrected, small oscillations would leave a net change of length.
struct SolveChains {
  template <class Group>
  using Scratch = ChainScratch<Group>;
  // Many short steps, one after the other; see CudaDevice.
  static constexpr uint32_t group_threads = 256, resident_blocks = 4;

  View<const Chain> chains;
  View<const EdgeConstraint> edges;
  View<Vec4> multiplier;  ///< kg·m: the positional impulse that an edge pushes with, and λ
  VertexState all;
  View<Vec4> pending;         ///< kg·m, by vertex; if the stage absorbs them
  View<Vec4> effective_mass;  ///< see Substep::effective_mass
  /// By piece, see load_kernels::Load; empty if no piece may be loaded. Chains of loaded pieces absorb
  /// nothing that is pending, and start without the multipliers of the last substep. If this view is empty,
  /// all chains start without them.
  View<const uint32_t> loaded;
  ChainStage stage;
  uint32_t first, end;  ///< chains of the layer

  /// Loads constants: the rest lengths of edges, and their compliances into the diagonal.
  template <class Group>
  MENISCUS_HD void prepare(const Group& group, Scratch<Group>& scratch, uint32_t number) const {
    if constexpr (!Group::is_one_thread) {
      const Chain chain = chains[first + number];
      auto* const rows = scratch.template first_rows<typename Scratch<Group>::Length>();
      group.for_each(chain.count, [&](uint32_t k) {
        const EdgeConstraint e = load(edges, chain.first + k);
        if (k == 0) {
          scratch.chain = chain;
          scratch.vertex[0] = e.a;
        }
        scratch.vertex[k + 1] = e.b;
        scratch.rest_length[k] = e.rest_length;
        rows[k].diagonal = e.compliance;
      });
    }
  }
  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch<Group>& scratch, uint32_t number) const;
};

/// Saves λ of edges.
struct KeepMultipliers {
  View<const Vec4> multiplier;
  View<float> kept;

  MENISCUS_HD void operator()(uint32_t k) const { kept[k] = multiplier[k].w; }
};
struct RestoreMultipliers {
  View<const float> kept;
  View<Vec4> multiplier;

  MENISCUS_HD void operator()(uint32_t k) const { multiplier[k] = {0, 0, 0, kept[k]}; }
};

/// The same for as many chains as a thread of the group has lanes.
template <class Group>
class SolveChainsAtOnce {
  using D = typename Group::Device;

 public:
  using Scratch = ChainScratch<Group>;

  MENISCUS_HD SolveChainsAtOnce(const SolveChains& solve, Scratch& scratch, const ChainsAtOnce<D>& chains)
      : s_(solve),
        scratch_(scratch),
        chains_(chains),
        loaded_(starts() && any_loaded() ? loaded_by_lane() : Real(0)),
        kept_(kept()) {}

  MENISCUS_HD void run(const Group& group) const {
    const uint32_t edges = chains_.most, vertices = edges + 1;
    Length* lengths = scratch_.template first_rows<Length>();
    group.for_each(edges + 2, [&](uint32_t k) { linearize(lengths, k); });
    group.for_each(edges, [&](uint32_t k) { couple(lengths, k); });
    solve_tridiagonal<Coupling::tight>(group, lengths, scratch_.template other_rows<Length>(), edges);
    group.for_each(edges, [&](uint32_t k) { take(lengths[k].right, k); });
    if (absorbs_pending()) {
      group.for_each(vertices, [&](uint32_t k) { add_pending(k); });
      return group.for_each(edges, [&](uint32_t k) { note_pending(k); });
    }

    Lateral* lateral = scratch_.template first_rows<Lateral>();
    group.for_each(vertices, [&](uint32_t k) { write_whole(lateral, k, turn(k)); });
    solve_tridiagonal<Coupling::loose>(group, lateral, scratch_.template other_rows<Lateral>(), vertices);
    const Real furthest = greatest_from_one(group, scratch_.template other_rows<Real>(), vertices,
                                            [&](uint32_t k) { return reach(lateral, k); });
    const Real fraction = Real(1) / furthest;
    group.for_each(vertices, [&](uint32_t k) { move(k, fraction); });
    if (has_effective_mass()) group.for_each(vertices, [&](uint32_t k) { press(lateral, k, fraction); });
    group.for_each(edges, [&](uint32_t k) { note(lateral, k, fraction); });
  }

 private:
  using Real = typename D::Real;
  using Vector = Vec3Of<Real>;
  using Places = pbd::Places<D>;
  using Length = typename Scratch::Length;
  using Lateral = typename Scratch::Lateral;
  using Edge = typename Scratch::Edge;

  /// The direction of the chain at a vertex. Where the chain folds back, it is the direction of both
  /// branches: displacements across them shorten nothing.
  MENISCUS_HD static Vector direction(const Vector& before, const Vector& after) {
    const Real turned = select_less(dot(before, after), Real(0), Real(-1), Real(1));
    const Vector sum = after + turned * before;
    const Real square = dot(sum, sum);
    return select_less(Real(1e-30f), square, inverse_sqrt(square), Real(0)) * sum;
  }

  /// The mobility of a vertex, 1/kg.
  struct Mobility {
    Vector along;
    Real w, lateral;

    MENISCUS_HD Mobility(const Vector& before, const Vector& after, const Real& weight, const Real& stiffness)
        : along(direction(before, after)), w(weight), lateral(Real(1) / (Real(1) + weight * stiffness)) {}
    MENISCUS_HD Real operator()(const Vector& p, const Vector& q) const {
      return w * ((Real(1) - lateral) * dot(p, along) * dot(q, along) + lateral * dot(p, q));
    }
  };

  /// The effective mass behind a vertex, kg.
  MENISCUS_HD Real mass_behind(uint32_t k) const {
    return has_effective_mass() ? gather(s_.effective_mass, vertex(k).index()).w : Real(0);
  }
  MENISCUS_HD bool has_effective_mass() const { return s_.effective_mass.count > 0; }
  MENISCUS_HD bool absorbs_pending() const { return s_.stage == ChainStage::absorbs_pending; }
  MENISCUS_HD bool follows_absorbing() const { return s_.stage == ChainStage::follows_absorbing; }
  /// Whether chains start without the multipliers of the last substep, or those of loaded pieces do.
  MENISCUS_HD bool starts() const {
    return follows_absorbing() ? any_loaded() : s_.stage != ChainStage::continues;
  }
  MENISCUS_HD bool any_loaded() const { return s_.loaded.count > 0; }
  MENISCUS_HD Real loaded_by_lane() const {
    const Places starts = start_of(0);
    return pbd::by_lane<D>([&](uint32_t lane) {
      return s_.loaded[s_.all.piece_number(starts.at[lane])] == load_kernels::nothing ? 0.0f : 1.0f;
    });
  }
  MENISCUS_HD Real kept() const {
    if (!starts()) return Real(1);
    return any_loaded() && !absorbs_pending() ? Real(1) - loaded_ : Real(0);
  }
  MENISCUS_HD Vector pending(const Places& v) const { return gather(s_.pending, v.index()).xyz(); }

  /// Edge k is stored at k + 1, after an edge that does not exist.
  MENISCUS_HD Edge edge(uint32_t k) const { return read_whole(scratch_.edges, k + 1); }
  MENISCUS_HD Real& stiffness(uint32_t k) const { return scratch_.stiffness[k + 1]; }

  /// kg: how much an edge with a multiplier resists turning.
  MENISCUS_HD static Real resistance(const Real& lambda, const Real& rest_length) {
    return select_less(Real(0), rest_length, max(lambda, -lambda) / rest_length, Real(0));
  }
  MENISCUS_HD auto positions() const { return s_.all.particles.position.from(s_.all.particles.sorted); }
  MENISCUS_HD auto moves() const { return s_.all.particles.accumulated_delta.from(s_.all.particles.sorted); }
  MENISCUS_HD auto previous() const { return s_.all.particles.previous.from(s_.all.particles.sorted); }
  MENISCUS_HD Places start_of(uint32_t k) const {
    Places vertices, at = chains_.edge(k);
    for (uint32_t lane = 0; lane < D::lane_count; ++lane)
      vertices.at[lane] = Group::is_one_thread ? s_.edges[at.at[lane]].a : scratch_.vertex[k];
    return vertices;
  }
  MENISCUS_HD Places end_of(uint32_t k) const {
    Places vertices, at = chains_.edge(k);
    for (uint32_t lane = 0; lane < D::lane_count; ++lane)
      vertices.at[lane] = Group::is_one_thread ? s_.edges[at.at[lane]].b : scratch_.vertex[k + 1];
    return vertices;
  }
  struct Constants {
    Real rest_length, compliance;
  };
  MENISCUS_HD Constants constants(const Length* rows, uint32_t k) const {
    if constexpr (Group::is_one_thread) {
      const Vec4Of<Real> e = gather_words(s_.edges, chains_.edge(k).index());
      return {e.z, e.w};
    } else {
      return {scratch_.rest_length[k], rows[k].diagonal};
    }
  }

  /// Writes the row of edge slot − 1, without the terms from the mobilities of its ends. The inverse masses
  /// of the ends stand beside the diagonal.
  MENISCUS_HD void linearize(Length* rows, uint32_t slot) const {
    const Real zero(0);
    const uint32_t k = slot - 1;
    if (slot == 0 || slot > chains_.most) {
      write_whole(scratch_.edges, slot, {{zero, zero, zero}, zero});
      stiffness(k) = zero;
      return;
    }
    const Places at = chains_.edge(k), from = start_of(k), to = end_of(k);
    const Vec4Of<Real> a = gather(positions(), from.index()), b = gather(positions(), to.index());
    const auto [rest, soft] = constants(rows, k);
    const Vec4Of<Real> multiplier = gather(s_.multiplier, at.index());
    const Real last = chains_.if_edge(k, multiplier.w);
    const Vector d = b.xyz() - a.xyz();
    const Vector then = gather(previous(), to.index()).xyz() - gather(previous(), from.index()).xyz();
    const Real l = square_root(dot(d, d)), weight = a.w + b.w;
    Real error = l - rest;
    const auto was = [&] { return square_root(dot(then, then)); };
    const Real compliance = edge_compliance(soft, rest, error, weight, s_.all.inverse_dt,
                                            Real(cloth_tuning::recovery_rate / s_.all.inverse_dt), was);
    const Vector n = (Real(1) / l) * d;
    const Real before = kept_ * (follows_absorbing() ? chains_.if_edge(k, along(multiplier.xyz(), n)) : last);
    Real rate = dot(n, d - then);
    if (absorbs_pending()) {
      error = dot(n, b.w * pending(to) - a.w * pending(from));
      rate = zero;
    }
    const Real gamma = damping_of(from) * compliance / (compliance + weight);
    // An edge without a direction, or one that cannot yield at all, is left unchanged.
    const Real live = chains_.if_edge(k, select_less(l, Real(1e-12f), zero, weight + compliance));
    const auto if_live = [&](const Real& x, const Real& otherwise) {
      return select_less(zero, live, x, otherwise);
    };
    write_whole(scratch_.edges, slot, {{if_live(n.x, zero), if_live(n.y, zero), if_live(n.z, zero)}, before});
    write_whole(
        rows, k,
        {if_live((Real(1) + gamma) * a.w, zero),
         if_live(compliance + Real(cloth_tuning::chain_regularisation) * weight, Real(1)),
         if_live((Real(1) + gamma) * b.w, zero), if_live(-error - compliance * before - gamma * rate, zero)});
    stiffness(k) = resistance(last, rest);
    scratch_.rest_length[k] = rest;
    scratch_.weight[k + 1] = b.w;
    if (k == 0) scratch_.weight[0] = a.w;
  }
  MENISCUS_HD Real damping_of(const Places& vertices) const {
    return s_.all.stretch_damping_by_lane<D>([&](uint32_t lane) { return vertices.at[lane]; });
  }

  MENISCUS_HD void couple(Length* rows, uint32_t k) const {
    const Vector before = edge(k - 1).n, n = edge(k).n, after = edge(k + 1).n;
    Length row = read_whole(rows, k);
    const Mobility a(before, n, row.lower, stiffness(k - 1) + stiffness(k) + mass_behind(k));
    const Mobility b(n, after, row.upper, stiffness(k) + stiffness(k + 1) + mass_behind(k + 1));
    row.diagonal += a(n, n) + b(n, n);
    row.lower = -a(before, n);
    row.upper = -b(n, after);
    write_whole(rows, k, row);
  }
  MENISCUS_HD void take(const Real& step, uint32_t k) const {
    const Real lambda = scratch_.edges[k + 1].lambda = chains_.if_edge(k, edge(k).lambda + step);
    stiffness(k) = resistance(lambda, scratch_.rest_length[k]);
  }

  /// kg·m, and λ: what edge k has pushed its end with so far in this substep.
  MENISCUS_HD Vec4Of<Real> given(uint32_t k) const {
    if (starts() && !any_loaded()) return {Real(0), Real(0), Real(0), Real(0)};
    const Vec4Of<Real> v = gather(s_.multiplier, chains_.edge(k).index());
    const Real kept = chains_.if_edge(k, kept_),
               lambda = follows_absorbing() ? along(v.xyz(), edge(k).n) : v.w;
    return {kept * v.x, kept * v.y, kept * v.z, kept * lambda};
  }
  /// λ of an edge that pushes along itself, in either direction.
  MENISCUS_HD static Real along(const Vector& push, const Vector& n) {
    const Real size = square_root(dot(push, push));
    return select_less(dot(push, n), Real(0), -size, size);
  }
  /// The change of an edge's push beyond what it has already given, kg·m.
  struct Change {
    Vector whole, straight;  ///< the part of it that belongs to λ

    MENISCUS_HD Change operator-() const { return {-whole, -straight}; }
    MENISCUS_HD friend Change operator-(const Change& a, const Change& b) {
      return {a.whole - b.whole, a.straight - b.straight};
    }
  };
  /// In a taut edge the whole push is to point as the edge does now. In a compressed edge the earlier push
  /// stays as released_push() has turned it.
  MENISCUS_HD Change change(const Edge& e, const Vec4Of<Real>& before) const {
    const Vector straight = (e.lambda - before.w) * e.n, taut = e.lambda * e.n - before.xyz();
    const auto either = [&](const Real& x, const Real& y) { return select_less(Real(0), e.lambda, x, y); };
    return {{either(straight.x, taut.x), either(straight.y, taut.y), either(straight.z, taut.z)}, straight};
  }
  MENISCUS_HD Change change(uint32_t k) const { return change(edge(k), given(k)); }
  /// The change of push that both edges at vertex k exert on it.
  MENISCUS_HD Change changes_on(uint32_t k) const {
    if (k == 0) return -change(0);
    return k < chains_.most ? change(k - 1) - change(k) : change(k - 1);
  }
  /// The row of the lateral displacement of vertex k, m. The push from turning λ belongs to it along the
  /// chain as well, since the lengths do not contain it. Where a chain folds, that push would throw a light
  /// vertex between heavy ones. Stores the push of the edges on the vertex.
  MENISCUS_HD Lateral turn(uint32_t k) const {
    const Real w = scratch_.weight[k], lower = w * stiffness(k - 1), upper = w * stiffness(k);
    const Vector along = direction(edge(k - 1).n, edge(k).n);
    const Change on_it = changes_on(k);
    scratch_.push[k] = on_it.whole;
    return {-lower, Real(1) + lower + upper + w * mass_behind(k), -upper,
            w * (on_it.whole - dot(on_it.straight, along) * along)};
  }

  /// kg·m: the part of its push that edge k releases as it turns.
  MENISCUS_HD Vector released_push(const Lateral* lateral, uint32_t k) const {
    return stiffness(k) * (lateral[k + 1].right - lateral[k].right);
  }
  /// kg·m: the resulting push of both edges on vertex k.
  MENISCUS_HD Vector push_on(const Lateral* lateral, uint32_t k) const {
    Vector push = scratch_.push[k];
    if (k > 0) push = push - released_push(lateral, k - 1);
    if (k < chains_.most) push += released_push(lateral, k);
    return has_effective_mass() ? push - mass_behind(k) * lateral[k].right : push;
  }
  /// How far that push would move the vertex, in edge lengths. Stores the push.
  MENISCUS_HD Real reach(const Lateral* lateral, uint32_t k) const {
    const Vector push = scratch_.push[k] = push_on(lateral, k);
    const Real rest = scratch_.rest_length[k < chains_.most ? k : k - 1];
    return select_less(Real(0), rest, scratch_.weight[k] * square_root(dot(push, push)) / rest, Real(0));
  }
  /// Adds only the pushes of lengths to the pending ones. Nothing has moved yet that could turn, and the next
  /// solve uses the positions that the chain then has.
  MENISCUS_HD void add_pending(uint32_t k) const {
    const Places at = vertex(k);
    const Vector now = pending(at) + changes_on(k).whole;
    scatter(s_.pending, at.index(), {now.x, now.y, now.z, Real(0)}, chains_.have_edge(k == 0 ? 0 : k - 1));
  }
  MENISCUS_HD void note_pending(uint32_t k) const {
    const Vector push = change(k).whole;
    const Real last = gather(s_.multiplier, chains_.edge(k).index()).w;
    scatter(s_.multiplier, chains_.edge(k).index(), {push.x, push.y, push.z, last},
            chains_.have_edge(k) & ~less_mask(Real(0), loaded_));
  }
  /// Vertices that do not exist get no push.
  MENISCUS_HD void move(uint32_t k, const Real& fraction) const {
    const Places at = vertex(k);
    LaneVertex<D> vertex{gather(positions(), at.index()), gather(moves(), at.index())};
    vertex.x.w = scratch_.weight[k];
    push_side_by_side(positions(), moves(), at, vertex, Real(1), fraction * scratch_.push[k]);
  }
  MENISCUS_HD void press(const Lateral* lateral, uint32_t k, const Real& fraction) const {
    const Places at = vertex(k);
    const Vec4Of<Real> before = gather(s_.effective_mass, at.index());
    const Vector now = before.xyz() + fraction * before.w * lateral[k].right;
    scatter(s_.effective_mass, at.index(), {now.x, now.y, now.z, before.w},
            chains_.have_edge(k == 0 ? 0 : k - 1));
  }
  MENISCUS_HD Places vertex(uint32_t k) const { return k == 0 ? start_of(0) : end_of(k - 1); }
  MENISCUS_HD void note(const Lateral* lateral, uint32_t k, const Real& fraction) const {
    const Edge e = edge(k);
    const Vec4Of<Real> last = given(k);
    const Vector push = last.xyz() + fraction * (change(e, last).whole - released_push(lateral, k));
    scatter(s_.multiplier, chains_.edge(k).index(),
            {push.x, push.y, push.z, last.w + fraction * (e.lambda - last.w)}, chains_.have_edge(k));
  }

  const SolveChains& s_;
  Scratch& scratch_;
  const ChainsAtOnce<D> chains_;
  const Real loaded_;  ///< 1 in lanes whose chains belong to loaded pieces, where that matters; else 0
  const Real kept_;    ///< 1 in lanes that continue from their earlier pushes, else 0
};

template <class Group>
MENISCUS_HD void SolveChains::operator()(const Group& group, Scratch<Group>& scratch, uint32_t number) const {
  using D = typename Group::Device;
  const uint32_t begin = first + number * D::lane_count;
  const bool is_near = !Group::is_one_thread;
  const ChainsAtOnce<D> together(is_near ? View<const Chain>{&scratch.chain, 1} : chains, is_near ? 0 : begin,
                                 is_near ? 1 : end);
  SolveChainsAtOnce<Group>(*this, scratch, together).run(group);
}

}  // namespace meniscus::cloth
