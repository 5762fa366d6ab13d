// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Errors of C++ as exceptions of Python.
#pragma once

#include <meniscus/error.h>
#include <nanobind/nanobind.h>

namespace meniscus::python {

/// The class in meniscus/errors.py that stands for a code.
nanobind::object error_class(ErrorCode code);

/// From now on Error is raised as the class of its code.
void translate_errors();

}  // namespace meniscus::python
