// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Functions of Python that C++ keeps and calls.
#pragma once

#include <nanobind/nanobind.h>

#include <memory>
#include <utility>

namespace meniscus::python {

namespace nb = nanobind;

/// A function of Python, or none. Any thread may copy it, drop it and call it, with the GIL or without.
/// Copies share one reference. What it raises passes through C++ as nb::python_error.
class Callable {
 public:
  Callable() = default;
  explicit Callable(nb::object function)
      : function_(new PyObject*(function.release().ptr()), [](PyObject** at) { drop(at); }) {}

  /// Another of the same function, with a reference of its own.
  Callable again() const { return get() ? Callable(nb::borrow(get())) : Callable(); }

  /// Calls use(function) under the GIL. The function is not valid once it was cleared.
  template <class Use>
  auto operator()(const Use& use) const {
    const nb::gil_scoped_acquire acquired;
    return use(nb::borrow(get()));
  }
  /// For the garbage collector. nullptr if there is none.
  PyObject* get() const { return function_ ? *function_ : nullptr; }
  /// Of all copies.
  void clear() {
    if (function_) Py_CLEAR(*function_);
  }

 private:
  static void drop(PyObject** at) noexcept {
    if (nb::is_alive()) {  // else the interpreter has gone, and the object with it
      const nb::gil_scoped_acquire acquired;
      Py_XDECREF(*at);
    }
    delete at;
  }

  std::shared_ptr<PyObject*> function_;
};

}  // namespace meniscus::python
