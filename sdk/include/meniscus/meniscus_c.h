// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The whole interface for C, version 99, and for languages that call C. Link the shared library meniscus_c.
//
// Every function that can fail returns a MeniscusStatus. After a failure, meniscus_last_error() has the
// message, the world is as before, and results are not written. No C++ exception leaves a function. Pointers
// must not be null, unless the comment of the function allows it. A null pointer gives
// MENISCUS_INVALID_ARGUMENT.
//
// Units, ranges and meanings are those of the C++ headers of the same names. Only one thread may use a world
// at a time, except for meniscus_cancel().
//
// Arrays belong to the world. An array is valid until the same function is called again, or a function that
// changes the world. Structs for results begin with `size`, which the caller sets to sizeof the struct.
#pragma once

#include <meniscus/c/base.h>
#include <meniscus/c/bodies.h>
#include <meniscus/c/cloth.h>
#include <meniscus/c/defs.h>
#include <meniscus/c/export.h>
#include <meniscus/c/hooks.h>
#include <meniscus/c/host.h>
#include <meniscus/c/particles.h>
#include <meniscus/c/queries.h>
#include <meniscus/c/recording.h>
#include <meniscus/c/scene.h>
#include <meniscus/c/setters.h>
#include <meniscus/c/state.h>
#include <meniscus/c/world.h>
