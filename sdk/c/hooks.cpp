// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Hooks of C.
#include <meniscus/c/hooks.h>

#include "sdk/c/handles.h"

namespace meniscus::c {
namespace {

MeniscusSubstep in_c(const SubstepView& v) {
  return {sizeof(MeniscusSubstep),
          static_cast<uint32_t>(v.hook),
          v.on_cuda ? 1 : 0,
          v.device,
          v.stream,
          v.dt,
          v.iteration,
          v.is_last ? 1 : 0,
          v.particles,
          v.vertices,
          v.positions,
          v.previous,
          v.corrections,
          v.velocities,
          v.phases,
          v.slots};
}

}  // namespace
}  // namespace meniscus::c

using namespace meniscus::c;
using namespace meniscus;

MeniscusStatus meniscus_add_hook(MeniscusWorld* world, MeniscusHook hook, MeniscusSubstepCall call,
                                 void* user, uint64_t* id) {
  return guarded([&] {
    uint64_t& out = required(id, "id");
    if (!call) throw Error(ErrorCode::invalid_argument, "call is null");
    const auto made = [call, user](const SubstepView& view) {
      const MeniscusSubstep substep = in_c(view);
      if (const int ended = call(&substep, user))
        throw Error(ErrorCode::cancelled, "a hook ended the step with " + std::to_string(ended));
    };
    out = static_cast<uint64_t>(world_of(world).add_hook(static_cast<Hook>(hook), made));
  });
}

MeniscusStatus meniscus_remove_hook(MeniscusWorld* world, uint64_t id) {
  return guarded([&] { world_of(world).remove_hook(static_cast<HookId>(id)); });
}
