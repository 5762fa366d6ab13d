// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The whole public interface.
#pragma once

#include <meniscus/batch.h>
#include <meniscus/bodies.h>
#include <meniscus/cloth.h>
#include <meniscus/defs.h>
#include <meniscus/device_arrays.h>
#include <meniscus/error.h>
#include <meniscus/flow.h>
#include <meniscus/force_fields.h>
#include <meniscus/graphics.h>
#include <meniscus/hooks.h>
#include <meniscus/host.h>
#include <meniscus/ids.h>
#include <meniscus/motion.h>
#include <meniscus/outputs.h>
#include <meniscus/queries.h>
#include <meniscus/recording.h>
#include <meniscus/snapshot.h>
#include <meniscus/types.h>
#include <meniscus/version.h>
#include <meniscus/world.h>
