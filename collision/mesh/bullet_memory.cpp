// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bullet's allocator and its reserve.
#include "collision/mesh/bullet_memory.h"

#include <LinearMath/btAlignedAllocator.h>

#include <new>
#include <utility>

#include "collision/mesh/tuning.h"

namespace meniscus::collision {

namespace {

thread_local BulletReserve* drawn_on = nullptr;

void* allocate(std::size_t bytes) {
  for (;;) {
    if (void* memory = ::operator new(bytes, std::nothrow)) return memory;
    if (!drawn_on) return nullptr;  // another user of Bullet in this process, who expects this
    if (drawn_on->give_back()) continue;
    drawn_on->note_broken();
    throw std::bad_alloc();
  }
}

void release(void* memory) {
  ::operator delete(memory);
}

void install() {
  // Once in a process. It is as the default, malloc and free, for whoever else uses Bullet.
  static const bool installed = (btAlignedAllocSetCustom(allocate, release), true);
  static_cast<void>(installed);
}

}  // namespace

BulletReserve::~BulletReserve() {
  while (give_back()) {
  }
}

void BulletReserve::refill(std::size_t solids) {
  const std::size_t wanted = bullet_tuning::reserve_blocks + solids / bullet_tuning::solids_a_reserve_block;
  const std::lock_guard lock(mutex_);
  blocks_.reserve(wanted);
  while (blocks_.size() < wanted) blocks_.push_back(::operator new(bullet_tuning::reserve_block));
}

bool BulletReserve::give_back() noexcept {
  const std::lock_guard lock(mutex_);
  if (blocks_.empty()) return false;
  ::operator delete(blocks_.back());
  blocks_.pop_back();
  return true;
}

InBullet::InBullet(BulletReserve& reserve) : before_(drawn_on) {
  install();
  if (reserve.is_broken()) throw std::bad_alloc();
  drawn_on = &reserve;
}

InBullet::InBullet(BulletReserve& reserve, std::size_t solids) : before_(drawn_on) {
  install();
  if (reserve.is_broken()) throw std::bad_alloc();
  reserve.refill(solids);
  drawn_on = &reserve;
}

InBullet::~InBullet() {
  drawn_on = before_;
}

}  // namespace meniscus::collision
