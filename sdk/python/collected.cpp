// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Shows the garbage collector the functions that a World calls, which belong to it alone.
#include "sdk/python/collected.h"

#include "sdk/python/state/handle.h"

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
  Py_VISIT(state->read_file.get());
  return 0;
}

int clear(PyObject* self) {
  if (WorldState* const state = state_of(self)) state->forget_functions();
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
