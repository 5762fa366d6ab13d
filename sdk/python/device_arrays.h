// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Arrays in the memory of a world's device, and calls within a substep that see such arrays.
#pragma once

#include <meniscus/device_arrays.h>

#include "sdk/python/state/handle.h"

namespace meniscus::python {

/// The class DeviceArray of Python.
struct PyDeviceArray {
  DeviceArray array;
  bool read_only = false;
  std::shared_ptr<void> owner{};  ///< keeps the stream alive; none within a hook
};

/// Makes the class DeviceArray, and adds device_arrays() to World.
void bind_device_arrays(nb::module_& module, nb::class_<PyWorld>& world);
/// Makes the class SubstepView, and adds add_hook() and remove_hook() to World.
void bind_hooks(nb::module_& module, nb::class_<PyWorld>& world);

}  // namespace meniscus::python
