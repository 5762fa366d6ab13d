// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Errors of C++ as exceptions of Python.
#pragma once

namespace meniscus::python {

/// From now on Error is raised as the class in meniscus/errors.py that stands for its code.
void translate_errors();

}  // namespace meniscus::python
