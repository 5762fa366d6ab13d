// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Replaces operator new and aligned_alloc.
#include "tests/faults/failing_memory.h"

#include <execinfo.h>
#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <mutex>
#include <new>

namespace meniscus::tests {

namespace {

constexpr int deepest = 64;  // frames of a call stack that tell it from others
constexpr uint32_t most_stacks = 1u << 16;

std::atomic<bool> armed = false, failed = false;
std::atomic<uint64_t> count = 0;
FailureChoice chosen;
std::mutex mutex;
uint64_t stacks[most_stacks];  // hashes, by open addressing; 0 is free
void* last_stack[deepest];
int last_depth = 0;
thread_local bool inside = false;  // a call stack is being read

/// Notes a call stack. Returns whether it is new.
bool is_new_stack(uint64_t hash) {
  for (uint32_t at = hash % most_stacks;; at = (at + 1) % most_stacks) {
    if (stacks[at] == hash) return false;
    if (stacks[at] != 0) continue;
    stacks[at] = hash;
    return true;
  }
}

bool fails() {
  if (!armed.load(std::memory_order_relaxed) || inside) return false;
  if (failed.load(std::memory_order_relaxed)) return chosen.and_all_after;
  inside = true;
  const std::lock_guard lock(mutex);
  void* stack[deepest];
  const int depth = chosen.number == 0 || chosen.number == count + 1 ? backtrace(stack, deepest) : 0;
  uint64_t hash = 1469598103934665603u;
  for (int k = 0; k < depth; ++k) hash = (hash ^ reinterpret_cast<uint64_t>(stack[k])) * 1099511628211u;
  const bool now = ++count == chosen.number || (chosen.number == 0 && is_new_stack(hash | 1));
  if (now) {
    failed = true;
    last_depth = depth;
    for (int k = 0; k < depth; ++k) last_stack[k] = stack[k];
  }
  inside = false;
  return now;
}

}  // namespace

FailingMemory::FailingMemory(const FailureChoice& choice) {
  void* warm[2];
  backtrace(warm, 2);  // its first call takes memory
  chosen = choice;
  count = 0;
  failed = false;
  armed = true;
}

FailingMemory::~FailingMemory() {
  armed = false;
}

bool FailingMemory::has_failed() const {
  return failed;
}

void forget_stacks() {
  for (uint64_t& stack : stacks) stack = 0;
}

void print_last_stack() {
  backtrace_symbols_fd(last_stack, last_depth, 2);
}

}  // namespace meniscus::tests

namespace {

void* get(std::size_t bytes) {
  return meniscus::tests::fails() ? nullptr : std::malloc(bytes ? bytes : 1);
}

void* get_or_throw(std::size_t bytes) {
  if (void* memory = get(bytes)) return memory;
  throw std::bad_alloc();
}

}  // namespace

// Those with an alignment are left alone: oneTBB's threads may use them.
void* operator new(std::size_t bytes) {
  return get_or_throw(bytes);
}
void* operator new[](std::size_t bytes) {
  return get_or_throw(bytes);
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  return get(bytes);
}
void* operator new[](std::size_t bytes, const std::nothrow_t&) noexcept {
  return get(bytes);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}

/// The CPU device takes its arrays here.
extern "C" void* aligned_alloc(std::size_t alignment, std::size_t bytes) {
  return meniscus::tests::fails() ? nullptr : memalign(alignment, bytes);
}
