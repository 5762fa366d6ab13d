// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Arrays in the memory of a world's device, in the forms of DLPack and of __cuda_array_interface__.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

/// A tensor of DLPack 0.x, as dlpack.h declares it.
struct DLManagedTensor;

namespace meniscus {

/// The type of the elements of a DeviceArray.
enum class ElementType { float32, uint32, uint64 };

/// An array in the memory of a device.
///
/// The memory lives as long as a copy of this struct, or a tensor that was made of it, also if the world is
/// gone. While one exists, the world writes later values elsewhere. The values are those at the time of the
/// call. On a GPU they are complete for all work that `stream` gets later. Other streams must wait for it
/// first, by an event. On the CPU they are complete when the call returns.
struct DeviceArray {
  void* data = nullptr;                     ///< on the device; null if there are no elements
  ElementType type = ElementType::float32;  ///< of an element
  int dimensions = 1;                       ///< 1 to 3
  std::array<int64_t, 3> shape{0, 1, 1};    ///< 1 beyond the dimensions
  std::array<int64_t, 3> strides{1, 1, 1};  ///< elements; NumPy and Numba want bytes
  bool on_cuda = false;                     ///< whether the memory is that of a GPU
  int device = 0;                           ///< CUDA ordinal; 0 on the CPU
  void* stream = nullptr;                   ///< cudaStream_t; null on the CPU
  std::shared_ptr<void> memory{};           ///< keeps the memory alive
};

/// The particles of fluids and grains, one element each, in the order of the ids: see World::device_arrays.
struct DeviceArrays {
  DeviceArray ids;         ///< uint64: ParticleId
  DeviceArray positions;   ///< float32, count × 3, m
  DeviceArray velocities;  ///< float32, count × 3, m/s
  DeviceArray phases;      ///< uint32: FluidId::index, of a granular material as well
};

/// The "typestr" of __cuda_array_interface__, as in "<f4".
const char* type_string(ElementType type);

/// A tensor of DLPack on the same memory, kDLCUDA or kDLCPU. Whoever gets it calls its deleter when done.
/// Wrap it in a PyCapsule named "dltensor" for Python. Throws Error(out_of_memory).
DLManagedTensor* to_dlpack(const DeviceArray& array);

}  // namespace meniscus
