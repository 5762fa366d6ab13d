// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Shows the garbage collector what a World calls. Handles share its state, but only the World itself makes
// calls that call back. So the functions belong to it alone.
#include "sdk/python/collected.h"

#include "sdk/python/handle.h"

namespace meniscus::python {

namespace {

WorldState* state_of(PyObject* self) {
  return nb::inst_ready(self) ? nb::inst_ptr<PyWorld>(self)->state.get() : nullptr;
}

int traverse(PyObject* self, visitproc visit, void* arg) {
  Py_VISIT(Py_TYPE(self));
  WorldState* const state = state_of(self);
  if (!state) return 0;
  Py_VISIT(state->on_progress.ptr());
  Py_VISIT(state->log.get());
  for (const auto& [id, hook] : state->hooks) Py_VISIT(hook.get());
  return 0;
}

int clear(PyObject* self) {
  WorldState* const state = state_of(self);
  if (!state) return 0;
  state->on_progress.reset();
  state->log.clear();
  for (auto& [id, hook] : state->hooks) hook.clear();
  return 0;
}

}  // namespace

PyType_Slot* world_slots() {
  static PyType_Slot slots[] = {{Py_tp_traverse, reinterpret_cast<void*>(traverse)},
                                {Py_tp_clear, reinterpret_cast<void*>(clear)},
                                {0, nullptr}};
  return slots;
}

}  // namespace meniscus::python
