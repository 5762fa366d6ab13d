// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// DeviceEngine's calls that give others its arrays: read-outs on the device, and hooks within a substep.
#pragma once

#include "sdk/engine/engine.inl"

namespace meniscus {

template <class D>
void DeviceEngine<D>::write_arrays(const EngineArrays& arrays, std::span<const ParticleId> ids) {
  const uint32_t count = particles_.sorted();
  const pbd::ParticleView p = particles_.view();
  const auto write = [&](const char* name, pbd::View<const pbd::Vec4> from, Vec3* to) {
    device_.parallel_for(name, count, engine_kernels::ReadVector{from, p.slot, {to, count}});
  };
  write("arrays/positions", p.position, arrays.positions);
  write("arrays/velocities", p.velocity, arrays.velocities);
  if (def_.origin != Vec3{0, 0, 0})
    device_.parallel_for("arrays/origin", count,
                         engine_kernels::ShiftVectors{{arrays.positions, count}, def_.origin});
  device_.parallel_for("arrays/groups", count,
                       engine_kernels::ReadGroup{p.phase, p.slot, {arrays.groups, count}});
  device_.copy_in(arrays.ids, ids.data(), ids.size_bytes());
  device_.send_off();
}

template <class D>
std::shared_ptr<void> DeviceEngine<D>::allocate_lasting(size_t bytes) {
  std::shared_ptr<void> memory = pbd::DeviceAccess<D>::allocate(bytes);
  if (memory) return memory;
  throw Error(ErrorCode::out_of_memory,
              "the device has no memory for arrays for others (" + std::to_string(bytes) + " bytes)");
}

template <class D>
void DeviceEngine<D>::set_hooks(const HookCalls& calls) {
  uint32_t hooks = 0;
  for (uint32_t k = 0; k < hook_count; ++k) hooks |= calls[k] ? 1u << k : 0u;
  solver_.set_hooks(
      hooks, [this, calls](Hook hook, const pbd::ParticleView& p, const pbd::Substep<D>& s, int iteration) {
        const auto floats = [](auto view) { return view.data ? &view.data->x : nullptr; };
        SubstepView view{.hook = hook, .on_cuda = device_.kind() == pbd::DeviceKind::cuda};
        view.device = ordinal();
        view.stream = stream();
        view.dt = s.dt;
        view.iteration = iteration;
        view.is_last = s.is_last;
        view.particles = p.sorted;
        view.vertices = particles_.vertices();
        view.positions = floats(p.position);
        view.velocities = floats(p.velocity);
        if (hook != Hook::velocities_known) {
          view.previous = floats(p.previous);
          view.corrections = floats(p.accumulated_delta);
        }
        view.phases = p.phase.data;
        view.slots = p.slot.data;
        calls[static_cast<uint32_t>(hook)](view);
      });
}

}  // namespace meniscus
