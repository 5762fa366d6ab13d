// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A thing in a world, as Python holds it.
#pragma once

#include <memory>

#include "sdk/python/world_state.h"

namespace meniscus::python {

/// It keeps its world alive.
template <class Id>
struct Handle {
  std::shared_ptr<WorldState> state;
  Id id;

  friend bool operator==(const Handle& a, const Handle& b) { return a.state == b.state && a.id == b.id; }
};

/// The class World of Python.
struct PyWorld {
  std::shared_ptr<WorldState> state;
};

}  // namespace meniscus::python
