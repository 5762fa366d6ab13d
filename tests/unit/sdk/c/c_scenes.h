// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Three scenes that are built in C. c_scenes_test.cpp builds the same in C++.
#pragma once

#include <meniscus/meniscus_c.h>

#ifdef __cplusplus
extern "C" {
#endif

/// `device` is "cpu" or "cuda". The world is null after a failure.
MeniscusStatus c_tank_with_body(const char* device, MeniscusWorld** world, MeniscusId* body);
MeniscusStatus c_cloth_over_ball(const char* device, MeniscusWorld** world, MeniscusId* cloth);
MeniscusStatus c_emitter_and_sink(const char* device, MeniscusWorld** world, MeniscusId* emitter,
                                  MeniscusId* sink);

#ifdef __cplusplus
}
#endif
