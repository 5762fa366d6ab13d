// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bullet's allocator and its reserve.
#include "collision/mesh/bullet_memory.h"

#include <LinearMath/btAlignedAllocator.h>

#include <atomic>
#include <functional>
#include <new>

#include "collision/mesh/tuning.h"

namespace meniscus::collision {

namespace {

thread_local BulletReserve* drawn_on = nullptr;

/// The head of a block of a reserve from which allocations were served. It lives as long as one of them does.
struct alignas(16) ServedBlock {
  ServedBlock* next;
  std::size_t used, live;  ///< bytes with this head; allocations

  bool holds(const void* memory) const {
    const char* begin = reinterpret_cast<const char*>(this);
    return std::less_equal<>{}(begin, static_cast<const char*>(memory)) &&
           std::less<>{}(static_cast<const char*>(memory), begin + bullet_tuning::reserve_block);
  }
};

std::mutex served_mutex;
ServedBlock* served = nullptr;  // the one that serves first
std::atomic<std::size_t> served_blocks = 0;

/// Memory of the first served block, or null if it has no room.
void* serve(std::size_t bytes) {
  if (!served || served->used + bytes > bullet_tuning::reserve_block) return nullptr;
  void* memory = reinterpret_cast<char*>(served) + served->used;
  served->used += bytes;
  ++served->live;
  return memory;
}

/// The same, with another block of the reserve if need be.
void* serve_from(BulletReserve& reserve, std::size_t bytes) {
  bytes = (bytes + 15) / 16 * 16;
  if (bytes + sizeof(ServedBlock) > bullet_tuning::reserve_block) return nullptr;
  const std::lock_guard lock(served_mutex);
  if (void* memory = serve(bytes)) return memory;
  void* block = reserve.take();
  if (!block) return nullptr;
  served = new (block) ServedBlock{served, sizeof(ServedBlock), 0};
  ++served_blocks;
  return serve(bytes);
}

/// Whether the memory was of a served block.
bool is_returned(void* memory) {
  if (served_blocks.load() == 0) return false;
  const std::lock_guard lock(served_mutex);
  for (ServedBlock** at = &served; *at; at = &(*at)->next) {
    ServedBlock* block = *at;
    if (!block->holds(memory)) continue;
    if (--block->live == 0) {
      *at = block->next;
      --served_blocks;
      ::operator delete(static_cast<void*>(block));
    }
    return true;
  }
  return false;
}

void* allocate(std::size_t bytes) {
  for (;;) {
    if (void* memory = ::operator new(bytes, std::nothrow)) return memory;
    if (!drawn_on) return nullptr;  // another user of Bullet in this process, who expects this
    if (void* memory = serve_from(*drawn_on, bytes)) return memory;
    void* block = drawn_on->take();
    if (!block) break;
    ::operator delete(block);  // the heap may then have room for a large request
  }
  drawn_on->note_broken();
  throw std::bad_alloc();
}

void release(void* memory) {
  if (!is_returned(memory)) ::operator delete(memory);
}

void install() {
  // Once in a process. It is as the default, malloc and free, for whoever else uses Bullet.
  static const bool installed = (btAlignedAllocSetCustom(allocate, release), true);
  static_cast<void>(installed);
}

}  // namespace

BulletReserve::~BulletReserve() {
  while (void* block = take()) ::operator delete(block);
}

void BulletReserve::refill(std::size_t solids) {
  const std::size_t wanted = bullet_tuning::reserve_blocks + solids / bullet_tuning::solids_a_reserve_block;
  const std::lock_guard lock(mutex_);
  blocks_.reserve(wanted);
  while (blocks_.size() < wanted) blocks_.push_back(::operator new(bullet_tuning::reserve_block));
}

void* BulletReserve::take() noexcept {
  const std::lock_guard lock(mutex_);
  if (blocks_.empty()) return nullptr;
  void* block = blocks_.back();
  blocks_.pop_back();
  return block;
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
