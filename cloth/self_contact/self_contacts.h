// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The constraint set of contacts between cloth and cloth.
#pragma once

#include <algorithm>
#include <span>

#include "cloth/self_contact/contact_piece.h"
#include "cloth/self_contact/folds.h"
#include "cloth/self_contact/frames.h"
#include "cloth/self_contact/tuning.h"
#include "pbd/device/shared_buffer.h"
#include "pbd/substep.h"
#include "pbd/surface_tree/surface_tree.h"

namespace meniscus::cloth {

/// Keeps cloth from passing through cloth, by contacts of vertices with triangles and of edges with edges.
///
///   project    runs after cloth's own constraints. At first it finds pairs of features that come within the
///              thickness, and the side on which each stays. Then it pushes them apart, with friction;
///   fail-safe  (ccd_failsafe()) ensures at the end that nothing has passed through. Where the solve did not
///              suffice, it unites vertices in impact zones.
///
/// Both use the same list of pairs, which is kept over several substeps. Each vertex has a motion bound, a
/// sphere that moves with the vertex's frame, in which it is to stay. Pairs are searched for again at the
/// start of a step, and when a vertex would leave its motion bound.
///
/// This set should come after cloth's own constraints, and the fail-safe after everything else that moves
/// vertices. At the start of a substep no cloth may have passed through cloth. Overlap by thickness alone is
/// opened slowly. Cloth that only prescribed motion brings together is not kept apart.
template <class D>
class SelfContacts final : public pbd::ConstraintSet<D> {
 public:
  /// Nothing else may fit the boxes of the tree.
  SelfContacts(D& device, pbd::SurfaceTree<D>& tree) : device_(device), tree_(tree), ccd_failsafe_(*this) {}

  pbd::ConstraintSet<D>& ccd_failsafe() { return ccd_failsafe_; }

  /// Replaces all cloth. A triangle's piece is an element of `pieces`. `rest` (m, by vertex) is the shape
  /// without strain. All these are of one world, of which there are so many. `device_rest` is `rest` of all
  /// worlds in the device's memory, and must stay valid. `heaviest` is the mass of the heaviest vertex, kg.
  void set_surface(std::span<const pbd::SurfaceTriangle> triangles, std::span<const Vec3> rest,
                   pbd::View<const Vec3> device_rest, std::span<const ContactPiece> pieces, float heaviest,
                   uint32_t worlds = 1);

  void project(pbd::Substep<D>& substep, int iteration) override;

  void start_step() override;
  void clear(uint32_t /*first*/, uint32_t /*count*/) override { anew_ = true; }
  bool had_room() const override;
  void make_room() override;
  void save() override;
  void restore() override;
  /// Lists of pairs are no state: each step begins with a search.
  void visit_state(pbd::StateVisitor& v) {
    learn();
    visit(v, 0, worlds_);
    if (v.restores()) anew_ = true;
  }
  void keep_world(uint32_t each) override;
  void reset_worlds(const pbd::ChosenWorlds& worlds) override;
  void undo_worlds(const pbd::ChosenWorlds& worlds) override;
  /// Visits one world of a batch as visit_state() would visit it alone.
  void visit_world(pbd::StateVisitor& v, uint32_t world) {
    learn();
    visit(v, world, 1);
  }

  // In a batch, of the world that has most.
  /// The greatest number of contacts in any substep of the last step.
  uint32_t most_contacts() const { return found(self_contact_kernels::contacts); }
  /// The greatest number of pairs of features listed in any substep of the last step.
  uint32_t most_candidates() const { return found(self_contact_kernels::candidates); }
  /// The number of searches for pairs in the last step.
  uint32_t listings() const { return found(self_contact_kernels::listings); }
  /// The number of these searches that were made for one substep only.
  uint32_t one_substep_listings() const { return found(self_contact_kernels::one_substep_listings); }
  /// The greatest number of pairs in any substep of the last step that would have passed through one another.
  uint32_t most_crossings() const { return found(self_contact_kernels::crossings); }
  /// The number of substeps of the last step in which no number of rounds of the fail-safe sufficed. All
  /// cloth stayed where it was in these.
  uint32_t given_up() const { return found(self_contact_kernels::given_up); }

 private:
  struct CcdFailsafe final : pbd::ConstraintSet<D> {
    explicit CcdFailsafe(SelfContacts& owner) : contacts(owner) {}
    void project(pbd::Substep<D>&, int) override {}
    void settle(pbd::Substep<D>& substep) override { contacts.join_crossings(substep); }
    SelfContacts& contacts;
  };

  static constexpr uint32_t most_threads = 1u << 19;  // of a launch over a list: they fill a GPU
  static constexpr uint32_t threads_together = 128;   // in a group of them

  uint32_t found(uint32_t counter) const { return found_.host().empty() ? 0 : found_.host()[counter]; }
  /// The number of groups of threads for all groups of triangles, of which each takes Scratch::groups.
  template <class Scratch>
  uint32_t blocks_of() const {
    return worlds_ * ((of_world_.groups + Scratch::groups - 1) / Scratch::groups);
  }
  uint32_t used_rounds() const;
  bool ran_short() const { return used_rounds() == rounds_; }
  bool lists_had_room() const;
  void learn();
  void visit(pbd::StateVisitor& v, uint32_t first_world, uint32_t worlds);
  void forget_found();
  uint32_t more_rounds() const { return std::min(2 * rounds_, self_contact_kernels::most_rounds); }
  static bool any_meet(std::span<const ContactPiece> pieces);
  bool idle() const { return tree_.places() == 0; }
  void set_pieces(std::span<const ContactPiece> pieces, std::span<const float> fineness);
  void reserve_contacts(uint32_t capacity);
  void sum_surroundings(pbd::Substep<D>& substep);
  void list_pairs(pbd::Substep<D>& substep);
  void find_pairs(pbd::Substep<D>& substep);
  void join_crossings(pbd::Substep<D>& substep);
  self_contact_kernels::ClothState cloth(const pbd::Substep<D>& substep);
  self_contact_kernels::Frames frames();
  self_contact_kernels::Surroundings surroundings();
  void set_frames(size_t pieces);
  self_contact_kernels::GroupPairs pairs();
  self_contact_kernels::SheetViews sheets();
  self_contact_kernels::ImpactZones impact_zones();
  self_contact_kernels::OwnMotion own_motion();
  self_contact_kernels::PieceSums piece_sums();
  self_contact_kernels::Folds folds();
  self_contact_kernels::ContactList list();
  uint32_t launched(uint32_t counter, size_t capacity);
  uint32_t room_of_world(size_t capacity) const { return static_cast<uint32_t>(capacity / worlds_); }

  D& device_;
  pbd::SurfaceTree<D>& tree_;
  CcdFailsafe ccd_failsafe_;
  pbd::View<const Vec3> rest_;
  uint32_t vertices_ = 0, groups_ = 0, rounds_ = self_contact_tuning::first_rounds;  // of all worlds
  uint32_t worlds_ = 1;
  self_contact_kernels::OfWorld of_world_;
  float least_distance_ = 0;  // m: see FindCrossings
  float unit_ = 0;            // kg·m, of the integers that sum up pushes
  bool anew_ = true;          // search for pairs in any case
  bool learned_ = true;       // from what is found: nothing is left to learn

  pbd::Buffer<self_contact_kernels::PieceProperties> pieces_{device_, "cloth contact pieces"};
  pbd::Buffer<uint16_t> features_{device_, "cloth features"};
  pbd::Buffer<uint32_t> vertex_piece_{device_, "pieces of cloth vertices"};
  pbd::Buffer<uint32_t> neighbour_start_{device_, "cloth neighbourhoods"};
  pbd::Buffer<uint32_t> neighbours_{device_, "cloth neighbourhoods"};
  pbd::Buffer<pbd::Vec4> cones_{device_, "cloth normal cones"};
  pbd::Buffer<pbd::Vec4> kept_{device_, "places of cloth vertices"},
      wide_{device_, "places of cloth vertices"};
  pbd::Buffer<pbd::Vec4> foreseen_{device_, "foreseen cloth"};  // after the solve: see RolledBack
  pbd::Buffer<pbd::Vec4> frames_{device_, "frames of cloth"};
  pbd::Buffer<uint32_t> frame_of_{device_, "frames of cloth"}, cell_of_{device_, "frames of cloth"};
  pbd::Buffer<int64_t> displacement_sums_{device_, "frames of cloth"};
  pbd::Buffer<uint32_t> immovable_{device_, "frames of cloth"}, movable_{device_, "frames of cloth"};
  pbd::Buffer<float> strayed_{device_, "strayed cloth"}, saved_strayed_{device_, "strayed cloth"};
  pbd::Buffer<uint32_t> impact_zone_label_{device_, "cloth zones"}, impact_zone_mark_{device_, "cloth zones"},
      impact_zone_anchor_{device_, "cloth zones"};
  pbd::Buffer<int64_t> impact_zone_mass_{device_, "cloth zones"};
  pbd::Buffer<pbd::Vec4> solved_{device_, "solved cloth"};
  pbd::Buffer<uint32_t> safe_fraction_{device_, "solved cloth"};
  pbd::Buffer<int64_t> piece_sums_{device_, "momentum of cloth rolled back"};
  pbd::Buffer<uint32_t> rough_{device_, "cloth group flags"}, smooth_{device_, "cloth group flags"};
  pbd::Buffer<uint32_t> fold_state_{device_, "cloth folds"}, fold_noted_{device_, "cloth folds"},
      fold_list_{device_, "cloth folds"};
  pbd::Buffer<self_contact_kernels::GroupPair> group_pairs_{device_, "cloth group pairs"};
  pbd::Buffer<self_contact_kernels::FeatureCode> candidates_{device_, "cloth contact candidates"};
  pbd::Buffer<self_contact_kernels::Corners> corners_{device_, "cloth contact vertices"};
  pbd::Buffer<pbd::Vec4> plane_{device_, "cloth contact planes"};
  pbd::Buffer<pbd::Vec4> multiplier_{device_, "cloth contact multipliers"};
  pbd::Buffer<self_contact_kernels::ContactWeights> weights_{device_, "cloth contact weights"};
  pbd::Buffer<uint32_t> entries_{device_, "contacts of cloth vertices"};
  pbd::Buffer<int64_t> push_sums_{device_, "cloth contact pushes"};
  pbd::Buffer<uint32_t> counters_{device_, "cloth contact counters"};
  pbd::SharedBuffer<uint32_t> found_{device_, "cloth contact counts"};  // of the world with most
  pbd::Buffer<uint32_t> found_by_world_{device_, "cloth contact counts"},
      most_found_{device_, "cloth contact counts"};
  // By world: whether most lists of the last step were made for one substep only; whether all pieces have one
  // frame, as long as some that move differently are near.
  pbd::Buffer<uint8_t> lasts_one_substep_{device_, "cloth contact flags"},
      one_frame_{device_, "cloth contact flags"};

  // Of a batch: what worlds are reset to.
  pbd::Buffer<float> kept_strayed_{device_, "kept strayed cloth"};
  pbd::Buffer<uint8_t> kept_lasts_one_substep_{device_, "kept flags"}, kept_one_frame_{device_, "kept flags"};
};

}  // namespace meniscus::cloth
