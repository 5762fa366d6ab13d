// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Calls of the user within a substep, with the arrays of the device.
#pragma once

#include <cstdint>
#include <functional>

namespace meniscus {

/// A point of a substep, in the order in which they are reached (docs/architecture.md).
enum class Hook : uint32_t {
  predicted,         ///< positions are predicted and sorted; neighbours and contacts are not found yet
  contacts_found,    ///< neighbours and contacts are known; before the first iteration
  iterated,          ///< at the end of each iteration
  solved,            ///< positions are final; velocities are not known yet
  velocities_known,  ///< velocities are final, before read-outs of the substep
};

/// The number of hooks.
inline constexpr uint32_t hook_count = 5;

/// The particles of a substep, in the memory of the device. Sorted particles of fluids and grains come first,
/// then the vertices of cloth and ropes by number. Vectors have four floats each. All pointers are valid
/// within the call alone, and for work that it puts on the stream.
struct SubstepView {
  Hook hook;                        ///< the point of the substep
  bool on_cuda = false;             ///< whether the arrays are those of a GPU
  int device = 0;                   ///< CUDA ordinal; 0 on the CPU
  void* stream = nullptr;           ///< cudaStream_t; null on the CPU
  float dt = 0;                     ///< s, of the substep
  int iteration = 0;                ///< of `iterated`, from 0
  bool is_last = false;             ///< whether it is the last substep of its step
  uint32_t particles = 0;           ///< of fluids and grains
  uint32_t vertices = 0;            ///< of cloth and ropes, behind the particles
  float* positions = nullptr;       ///< m, and the inverse mass in 1/kg, which is 0 of held vertices
  const float* previous = nullptr;  ///< m, at the start of the substep; not at velocities_known
  /// m, and a word of the solver: what constraints have moved so far. Whoever moves a position adds the same
  /// here, since velocities follow from it. Not at velocities_known.
  float* corrections = nullptr;
  float* velocities = nullptr;  ///< m/s, and a word of the solver
  /// Low 16 bits: FluidId::index, or the number of the piece of cloth. Bit 16: fluid, 17: vertex, 19: grain.
  const uint32_t* phases = nullptr;
  const uint32_t* slots = nullptr;  ///< of particles: the index in World::ids(); of vertices: 2³¹ + number
};

/// A call within a substep. On a GPU it puts its work on the stream and must not wait for it. On the CPU it
/// works at once. It must use no call of its world but cancel(). An exception ends the step, and the state is
/// then that before the step.
using SubstepCall = std::function<void(const SubstepView&)>;

/// Names a call that World::add_hook added. Opaque; never used again.
enum class HookId : uint64_t {};

}  // namespace meniscus
