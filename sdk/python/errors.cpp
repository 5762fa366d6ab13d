// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Chooses the exception of Python for an Error.
#include "sdk/python/errors.h"

namespace meniscus::python {

namespace nb = nanobind;

namespace {

const char* name_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::invalid_argument:
      return "InvalidArgumentError";
    case ErrorCode::not_found:
      return "NotFoundError";
    case ErrorCode::io:
      return "FileError";
    case ErrorCode::parse:
      return "SceneError";
    case ErrorCode::mesh:
      return "MeshError";
    case ErrorCode::capacity:
      return "CapacityError";
    case ErrorCode::non_finite:
      return "NonFiniteError";
    case ErrorCode::device:
      return "DeviceError";
    case ErrorCode::out_of_memory:
      return "OutOfMemoryError";
    case ErrorCode::cancelled:
      return "CancelledError";
    case ErrorCode::lost:
      return "LostError";
  }
  return "Error";
}

}  // namespace

nb::object error_class(ErrorCode code) {
  return nb::module_::import_("meniscus.errors").attr(name_of(code));
}

namespace {

void translate(const std::exception_ptr& thrown, void*) {
  try {
    std::rethrow_exception(thrown);
  } catch (const Error& error) {
    PyErr_SetString(error_class(error.code()).ptr(), error.what());
  }
}

}  // namespace

void translate_errors() {
  nb::register_exception_translator(translate);
}

}  // namespace meniscus::python
