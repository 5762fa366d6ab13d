// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Arrays on the device as tensors of DLPack.
#include <meniscus/device_arrays.h>
#include <meniscus/error.h>

#include <new>

// The structs of dlpack.h, version 0.8, as its binary interface has them.

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

namespace {

constexpr int32_t dl_cpu = 1, dl_cuda = 2;
constexpr uint8_t dl_unsigned = 1, dl_float = 2;

/// A tensor with what it points to.
struct Held {
  DLManagedTensor tensor{};
  DeviceArray array;
};

DlType type_of(ElementType type) {
  if (type == ElementType::float32) return {dl_float, 32, 1};
  return {dl_unsigned, static_cast<uint8_t>(type == ElementType::uint64 ? 64 : 32), 1};
}

}  // namespace

const char* type_string(ElementType type) {
  return type == ElementType::float32 ? "<f4" : type == ElementType::uint64 ? "<u8" : "<u4";
}

DLManagedTensor* to_dlpack(const DeviceArray& array) {
  Held* const held = new (std::nothrow) Held{{}, array};
  if (!held) throw Error(ErrorCode::out_of_memory, "there is no memory for a tensor of DLPack");
  held->tensor = {{array.data,
                   {array.on_cuda ? dl_cuda : dl_cpu, array.device},
                   array.dimensions,
                   type_of(array.type),
                   held->array.shape.data(),
                   held->array.strides.data(),
                   0},
                  held,
                  [](DLManagedTensor* self) { delete static_cast<Held*>(self->manager); }};
  return &held->tensor;
}

}  // namespace meniscus
