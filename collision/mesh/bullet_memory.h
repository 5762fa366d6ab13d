// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Memory for Bullet, which does not check whether it got any.
#pragma once

#include <cstddef>
#include <mutex>
#include <vector>

namespace meniscus::collision {

/// Memory held back for calls into Bullet: blocks that serve the allocations which fail in such a call. What
/// is larger than a block gets their memory by way of the heap. If none is left, the allocation throws
/// std::bad_alloc through Bullet, whose objects are then broken for good: they may be neither used nor
/// destroyed. In a destructor of Bullet this would end the process, which the size of the reserve prevents.
class BulletReserve {
 public:
  BulletReserve() = default;
  ~BulletReserve();
  BulletReserve(const BulletReserve&) = delete;
  BulletReserve& operator=(const BulletReserve&) = delete;

  /// Takes what a call needs in a world of so many solids. Throws std::bad_alloc; nothing is broken then.
  void refill(std::size_t solids);
  /// Takes a block, or null if none is left. The caller frees it by operator delete.
  void* take() noexcept;
  void note_broken() noexcept { broken_ = true; }
  bool is_broken() const noexcept { return broken_; }

 private:
  std::mutex mutex_;  // two threads may be inside Bullet
  std::vector<void*> blocks_;
  bool broken_ = false;
};

/// While this lives, the thread is inside Bullet and draws on a reserve. Throws std::bad_alloc, before Bullet
/// is entered, if the reserve cannot be refilled or is broken.
class InBullet {
 public:
  InBullet(BulletReserve& reserve, std::size_t solids);
  /// Without a refill: for work that must be done with what is left.
  explicit InBullet(BulletReserve& reserve);
  ~InBullet();
  InBullet(const InBullet&) = delete;
  InBullet& operator=(const InBullet&) = delete;

 private:
  BulletReserve* before_;
};

}  // namespace meniscus::collision
