// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Definition structs: set the members that differ from the defaults, and pass the struct to World's
// constructor or to a create call. Quantities are in SI units or have none. They keep their meaning when the
// spacing or the time step changes. This header includes those of the world itself, of materials, fixed
// solids, volumes and probes. bodies.h, cloth.h, flow.h and force_fields.h have the others.
#pragma once

#include <meniscus/materials.h>
#include <meniscus/probes.h>
#include <meniscus/solids.h>
#include <meniscus/volumes.h>
#include <meniscus/world_def.h>
