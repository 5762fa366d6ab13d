// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Contacts among solids on a device.
#pragma once

#include <memory>

#include "collision/rigid_contact/bearing_kernels.h"
#include "collision/rigid_contact/ground_buffers.h"
#include "collision/rigid_contact/hull_buffers.h"
#include "collision/rigid_contact/solve_kernels.h"
#include "pbd/device/buffer.h"
#include "pbd/device/shared_buffer.h"

namespace meniscus::collision {

/// Finds and solves contacts among solids in a device's kernels. A step
///
///   find_pairs     lists the pairs of parts whose boxes overlap;
///   find_contacts  finds up to four points for each, with the impulses of the last step;
///   colour         so that contacts of one colour share no body that moves;
///   prepare        sorts contacts by colour;
///   solve          advances in small steps (soft TGS, Catto 2024).
///
/// The first three are find(), the others advance(), which may be repeated with other forces.
///
/// What a step starts from stays on the device. The host reads a pair of numbers a contact after a step. It
/// reads all contacts when bodies fall asleep, and reads and writes them when islands wake. Otherwise it
/// reads them only if it is asked for them.
///
/// All orders follow from the order of the parts, so results do not depend on the number of threads.
template <class D>
class RigidContactSet final : public RigidContacts {
 public:
  explicit RigidContactSet(D& device) : device_(device) {}

  void set_parts(const ContactSolid& all) override;
  void find(std::span<const ContactBody> bodies, float dt) override;
  std::vector<ContactBodies> found() override;
  void advance(std::span<const ContactBody> bodies, const ContactStep& step,
               std::span<ContactMotion> out) override;
  void accept() override;
  std::vector<TouchingParts> touching() override;
  void keep() override;
  void take_back() override;
  std::vector<SavedContact> save() override;
  void restore(std::span<const SavedContact> saved) override;

  /// Lets contacts bear pushes on bodies within a substep of dt (s), from the last advance() on.
  void start_bearing(float dt);
  /// Visits each contact once.
  void bear(pbd::View<HeldBody> bodies);
  /// The next advance() starts from what contacts bear.
  void store_bearing(float dt);

 private:
  /// What a step leaves for the next one, in the order of pairs.
  struct Memory {
    explicit Memory(D& device)
        : contacts{device, "solid contacts"},
          starts{device, "solid contacts"},
          touching{device, "solid contacts"} {}
    void make_room(uint32_t contact_count);
    void swap(Memory& other);

    uint32_t count = 0;
    pbd::Buffer<rigid_contact_kernels::ContactMemory> contacts;
    pbd::Buffer<uint32_t> starts;  // of each part's
    pbd::Buffer<rigid_contact_kernels::PartPair> touching;
  };

  void load(std::span<const ContactBody> bodies);
  void place_parts(float dt);
  rigid_contact_kernels::PairSearch search() const;
  void find_pairs();
  void find_contacts();
  void colour();
  void sort_by_colour();
  void prepare(float h);
  void solve(const ContactStep& step);
  template <class Solve>
  void solve_once(const char* name, const Solve& solve);
  template <class Visit>
  void visit_colours(const char* name, Visit visit);
  uint32_t part_count() const { return static_cast<uint32_t>(host_parts_.size()); }

  D& device_;
  std::vector<ContactPart> host_parts_;
  rigid_contact_kernels::CellGrid grid_{1, 1};
  uint32_t bodies_count_ = 0, pair_count_ = 0, contact_count_ = 0;
  float step_ = 0, small_step_ = 0;  // s, of the last advance()
  bool any_bounces_ = false;
  std::vector<uint32_t> colour_starts_;

  pbd::Buffer<ContactPart> parts_{device_, "solid parts"};
  HullBuffers hulls_{device_};
  GroundBuffers grounds_{device_};
  pbd::Buffer<uint32_t> is_large_{device_, "large parts"}, large_{device_, "large parts"};
  pbd::SharedBuffer<ContactBody> start_{device_, "bodies of contacts"};
  pbd::SharedBuffer<ContactMotion> motion_{device_, "bodies of contacts"};
  pbd::Buffer<rigid_contact_kernels::MovingBody> bodies_{device_, "bodies of contacts"};
  pbd::Buffer<Quat> turn_{device_, "bodies of contacts"};
  pbd::Buffer<rigid_contact_kernels::PlacedPart> placed_{device_, "solid parts"};
  pbd::Buffer<uint32_t> bucket_{device_, "solid cells"}, sorted_bucket_{device_, "solid cells"};
  pbd::Buffer<uint32_t> number_{device_, "solid cells"}, sorted_{device_, "solid cells"};
  pbd::Buffer<uint32_t> bucket_starts_{device_, "solid cells"};
  pbd::Buffer<uint32_t> partners_{device_, "solid pairs"}, pair_starts_{device_, "solid pairs"};
  pbd::Buffer<rigid_contact_kernels::PartPair> pairs_{device_, "solid pairs"};
  pbd::Buffer<rigid_contact_kernels::FoundContact> found_{device_, "solid pairs"};
  pbd::Buffer<uint32_t> touches_{device_, "solid pairs"}, place_{device_, "solid pairs"};
  pbd::Buffer<uint32_t> contacts_{device_, "solid contacts"};
  pbd::Buffer<rigid_contact_kernels::TwoBodies> two_bodies_{device_, "solid contacts"};
  pbd::Buffer<ContactBodies> contact_bodies_{device_, "solid contacts"};
  pbd::Buffer<uint32_t> colour_{device_, "solid colours"}, sorted_colour_{device_, "solid colours"};
  pbd::Buffer<uint32_t> contact_number_{device_, "solid colours"}, order_{device_, "solid colours"};
  pbd::Buffer<uint32_t> claims_{device_, "solid colours"};
  pbd::Buffer<uint64_t> used_{device_, "solid colours"};
  pbd::Buffer<uint32_t> starts_{device_, "solid colours"};
  pbd::Buffer<rigid_contact_kernels::SolverContact> solver_{device_, "solid contacts"};
  pbd::Buffer<rigid_contact_kernels::Bearing> bearing_{device_, "solid contacts"};
  Memory memory_{device_}, kept_{device_};
  pbd::Buffer<uint32_t> contact_start_{device_, "solid contacts"};  // of each part's, among those found
};

}  // namespace meniscus::collision
