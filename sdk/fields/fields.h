// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The one description of all definitions. fields() lists what a struct holds: key, member, what is allowed,
// unit, meaning; the key is the member's name. choices() lists what a variant may be; in a file the word is
// the object's "type". names_of() lists the words for enumerators. The check() of a visitor holds what one
// field alone cannot say: that something holds, the words for it, and where a member is at fault its name and
// value.
//
// Who visits: World's checks (world/check/), and by way of scene/scene_fields.h the reader and the schema of
// scene files. In a file a rule of text, such as not_empty, holds for names; in C++ names are free, and ids
// stand in the place of those that refer to other things.
#pragma once

#include "sdk/fields/bodies.h"
#include "sdk/fields/cloth.h"
#include "sdk/fields/flow.h"
#include "sdk/fields/fluid.h"
#include "sdk/fields/probes.h"
#include "sdk/fields/ropes.h"
#include "sdk/fields/shapes.h"
#include "sdk/fields/world.h"
