// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The structs of dlpack.h, version 1.0, as its binary interface has them.
#pragma once

#include <cstdint>

struct DlDevice {
  int32_t type;
  int32_t ordinal;
};
struct DlType {
  uint8_t code, bits;
  uint16_t lanes;
};
struct DlTensor {
  void* data;
  DlDevice device;
  int32_t dimensions;
  DlType type;
  int64_t* shape;
  int64_t* strides;
  uint64_t byte_offset;
};
struct DLManagedTensor {
  DlTensor tensor;
  void* manager;
  void (*deleter)(DLManagedTensor*);
};
struct DlVersion {
  uint32_t of_layout, of_features;  ///< its major and its minor
};
/// From version 1.0 on.
struct DLManagedTensorVersioned {
  DlVersion version;
  void* manager;
  void (*deleter)(DLManagedTensorVersioned*);
  uint64_t flags;
  DlTensor tensor;
};

namespace meniscus {

struct DeviceArray;

/// DlDevice::type.
inline constexpr int32_t dl_cpu = 1, dl_cuda = 2;
/// DLManagedTensorVersioned::flags.
inline constexpr uint64_t dl_read_only = 1;

/// As to_dlpack(). Wrap it in a PyCapsule named "dltensor_versioned" for Python.
DLManagedTensorVersioned* to_dlpack_versioned(const DeviceArray& array, bool read_only);

}  // namespace meniscus
