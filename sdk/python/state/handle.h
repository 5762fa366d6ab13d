// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A thing in a world, as Python holds it.
#pragma once

#include <memory>

#include "sdk/python/state/world_state.h"

namespace meniscus::python {

/// It keeps its world alive.
template <class Id>
struct Handle {
  std::shared_ptr<WorldState> state;
  Id id;

  friend bool operator==(const Handle& a, const Handle& b) { return a.state == b.state && a.id == b.id; }
};

/// The class World of Python. Handles share its state, but it alone makes the calls that call functions of
/// Python. So these functions go with it, or else one that refers to a handle would keep the state for ever.
struct PyWorld {
  PyWorld(std::shared_ptr<WorldState> its_state) : state(std::move(its_state)) {}
  PyWorld(PyWorld&&) noexcept = default;
  PyWorld& operator=(PyWorld&&) = delete;
  ~PyWorld() {
    if (state) state->forget_functions();
  }

  std::shared_ptr<WorldState> state;
};

}  // namespace meniscus::python
