// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The structs of dlpack.h, version 0.8, as its binary interface has them.
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

namespace meniscus {

/// DlDevice::type.
inline constexpr int32_t dl_cpu = 1, dl_cuda = 2;

}  // namespace meniscus
