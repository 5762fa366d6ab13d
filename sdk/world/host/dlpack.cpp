// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Arrays on the device as tensors of DLPack.
#include <meniscus/device_arrays.h>
#include <meniscus/error.h>

#include <new>

#include "sdk/world/host/dlpack.h"

namespace meniscus {

namespace {

constexpr uint8_t dl_unsigned = 1, dl_float = 2;

/// A tensor with what it points to.
template <class Tensor>
struct Held {
  Tensor tensor{};
  DeviceArray array;
};

DlType type_of(ElementType type) {
  if (type == ElementType::float32) return {dl_float, 32, 1};
  return {dl_unsigned, static_cast<uint8_t>(type == ElementType::uint64 ? 64 : 32), 1};
}

template <class Tensor>
Tensor* tensor_of(const DeviceArray& array) {
  auto* const held = new (std::nothrow) Held<Tensor>{{}, array};
  if (!held) throw Error(ErrorCode::out_of_memory, "there is no memory for a tensor of DLPack");
  Tensor& tensor = held->tensor;
  tensor.tensor = {array.data,
                   {array.on_cuda ? dl_cuda : dl_cpu, array.device},
                   array.dimensions,
                   type_of(array.type),
                   held->array.shape.data(),
                   held->array.strides.data(),
                   0};
  tensor.manager = held;
  tensor.deleter = [](Tensor* self) { delete static_cast<Held<Tensor>*>(self->manager); };
  return &tensor;
}

}  // namespace

const char* type_string(ElementType type) {
  return type == ElementType::float32 ? "<f4" : type == ElementType::uint64 ? "<u8" : "<u4";
}

DLManagedTensor* to_dlpack(const DeviceArray& array) {
  return tensor_of<DLManagedTensor>(array);
}

DLManagedTensorVersioned* to_dlpack_versioned(const DeviceArray& array, bool read_only) {
  auto* const tensor = tensor_of<DLManagedTensorVersioned>(array);
  tensor->version = {1, 0};
  tensor->flags = read_only ? dl_read_only : 0;
  return tensor;
}

}  // namespace meniscus
