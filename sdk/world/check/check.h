// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of arguments. Each throws Error(invalid_argument) that names the argument, its value and what is
// allowed.
#pragma once

#include <meniscus/types.h>

#include <string>

#include "sdk/fields/rule.h"

namespace meniscus::check {

/// Checks a definition and its members by fields() (sdk/fields/fields.h). Ids are not checked.
template <class Def>
void def(const Def& def);

// These check an argument that is not a definition.
void value(const char* name, float value, const FieldRule& rule = any_value, const char* unit = "");
void value(const char* name, int value, const FieldRule& rule, const char* unit = "");
void value(const char* name, Vec3 value, const FieldRule& rule = any_value, const char* unit = "");
void value(const char* name, const Pose& value);
void impulse(const char* name, Vec3 value, float mass);  ///< finite, and no more than gives `mass` 1e9 m/s

[[noreturn]] void refuse(const std::string& name, const std::string& value, const std::string& allowed);
std::string text_of(Vec3 v);

}  // namespace meniscus::check
