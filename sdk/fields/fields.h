// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The only description of the definition structs. fields() lists the members of a struct: key, member, rule,
// unit, meaning. The key is the name of the member. choices() lists the alternatives of a variant. In a file
// the word for an alternative is the "type" of the object. names_of() lists the words for enumerators. The
// check() of a visitor takes conditions on several members: whether it holds, a message, and the name and the
// value of the member at fault.
//
// These visitors use it: the checks of World (world/check/member_check.h), the setters and the list of
// members for C (c/member.cpp, c/member_list.cpp), and through scene/scene_fields.h the reader and the schema
// of scene files. Rules of text, such as not_empty, apply to files only. Where a file refers to another thing
// by name, C++ has an id, which these checks do not look at.
#pragma once

#include "sdk/fields/bodies.h"
#include "sdk/fields/cloth.h"
#include "sdk/fields/flow.h"
#include "sdk/fields/fluid.h"
#include "sdk/fields/force_fields.h"
#include "sdk/fields/probes.h"
#include "sdk/fields/ropes.h"
#include "sdk/fields/shapes.h"
#include "sdk/fields/world.h"
