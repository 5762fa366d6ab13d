// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The class DeviceArray: DLPack 1.0 (the array API standard 2023.12), __cuda_array_interface__ (version 3),
// and NumPy's __array_interface__ on the CPU.
#include "sdk/python/device_arrays.h"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include "pbd/device/stream_order.h"
#include "sdk/python/values/results.h"
#include "sdk/world/host/dlpack.h"

namespace meniscus::python {

namespace {

template <class Tensor>
constexpr const char* tensor_name = "dltensor";
template <>
constexpr const char* tensor_name<DLManagedTensorVersioned> = "dltensor_versioned";
constexpr int legacy_stream = 1;  // of CUDA; 2 is the per-thread one, and others are handles
constexpr int no_order = -1;

void* stream_at(int64_t handle) {
  return reinterpret_cast<void*>(static_cast<intptr_t>(handle));
}

/// Lets the stream of a consumer wait until the array is complete.
void order(const DeviceArray& array, int64_t consumer) {
  if (stream_at(consumer) != array.stream) pbd::put_after(array.stream, stream_at(consumer), array.device);
}

int64_t checked_stream(const DeviceArray& array, std::optional<int64_t> stream) {
  if (!array.on_cuda) {
    if (stream && *stream != no_order)
      throw nb::value_error("__dlpack__(): stream must be None, since the array is on the CPU");
    return no_order;
  }
  const int64_t handle = stream.value_or(legacy_stream);
  if (handle == 0)
    throw nb::value_error(
        "__dlpack__(): stream 0 is ambiguous; 1 is the legacy default stream, 2 the per-thread one");
  if (handle < no_order)
    throw nb::value_error("__dlpack__(): stream must be -1, 1, 2 or a handle of a stream");
  return handle;
}

std::tuple<int, int> dlpack_device(const PyDeviceArray& self) {
  return {self.array.on_cuda ? dl_cuda : dl_cpu, self.array.device};
}

/// A capsule that nobody took has its name still.
template <class Tensor>
void drop_tensor(PyObject* capsule) {
  if (!PyCapsule_IsValid(capsule, tensor_name<Tensor>)) return;
  auto* const tensor = static_cast<Tensor*>(PyCapsule_GetPointer(capsule, tensor_name<Tensor>));
  tensor->deleter(tensor);
}

template <class Tensor>
nb::object capsule_of(Tensor* tensor) {
  PyObject* const capsule = PyCapsule_New(tensor, tensor_name<Tensor>, drop_tensor<Tensor>);
  if (!capsule) tensor->deleter(tensor);
  if (!capsule) throw nb::python_error();
  return nb::steal(capsule);
}

[[noreturn]] void refuse_buffer(const char* why) {
  PyErr_SetString(PyExc_BufferError, why);
  throw nb::python_error();
}

nb::object dlpack(const PyDeviceArray& self, std::optional<int64_t> stream,
                  std::optional<std::tuple<int, int>> max_version,
                  std::optional<std::tuple<int, int>> dl_device, std::optional<bool> copy) {
  if (copy.value_or(false))
    refuse_buffer("__dlpack__(): copy=True is not possible; copy the array that takes it");
  if (dl_device && *dl_device != dlpack_device(self))
    refuse_buffer("__dlpack__(): dl_device must be the device of the array");
  const bool is_versioned = max_version && std::get<0>(*max_version) >= 1;
  if (self.read_only && !is_versioned)
    refuse_buffer(
        "__dlpack__(): the array is read-only, which DLPack tells from version 1.0 on; max_version must be "
        "(1, 0) or later");
  const int64_t consumer = checked_stream(self.array, stream);
  if (consumer != no_order) order(self.array, consumer);
  return is_versioned ? capsule_of(to_dlpack_versioned(self.array, self.read_only))
                      : capsule_of(to_dlpack(self.array));
}

nb::tuple shape_of(const DeviceArray& array) {
  const auto& [a, b, c] = array.shape;
  return array.dimensions == 1   ? nb::make_tuple(a)
         : array.dimensions == 2 ? nb::make_tuple(a, b)
                                 : nb::make_tuple(a, b, c);
}

/// What both interfaces have.
nb::dict interface_of(const PyDeviceArray& self) {
  nb::dict members;
  members["shape"] = shape_of(self.array);
  members["typestr"] = type_string(self.array.type);
  members["data"] = nb::make_tuple(reinterpret_cast<uintptr_t>(self.array.data), self.read_only);
  members["strides"] = nb::none();
  members["version"] = 3;
  return members;
}

nb::dict cuda_interface(const PyDeviceArray& self) {
  if (!self.array.on_cuda) throw nb::attribute_error("the array is on the CPU; take numpy.asarray of it");
  // Some consumers, such as PyTorch, work on the default stream and look at no "stream".
  order(self.array, legacy_stream);
  nb::dict members = interface_of(self);
  members["stream"] = reinterpret_cast<uintptr_t>(self.array.stream);
  return members;
}

nb::dict array_interface(const PyDeviceArray& self) {
  if (self.array.on_cuda) throw nb::attribute_error("the array is on a GPU; take it by DLPack");
  nb::dict members = interface_of(self);
  // NumPy before 2 refuses a null pointer, of an empty array as well.
  static const uint64_t nothing = 0;
  if (!self.array.data)
    members["data"] = nb::make_tuple(reinterpret_cast<uintptr_t>(&nothing), self.read_only);
  return members;
}

std::string repr(const PyDeviceArray& self) {
  const DeviceArray& a = self.array;
  std::string size = std::to_string(a.shape[0]);
  for (int k = 1; k < a.dimensions; ++k) size += " x " + std::to_string(a.shape[size_t(k)]);
  return "<DeviceArray " + size + ", " + type_string(a.type) +
         (a.on_cuda ? ", cuda:" + std::to_string(a.device) : ", cpu") + ">";
}

const char* dtype_of(ElementType type) {
  return type == ElementType::float32 ? "float32" : type == ElementType::uint64 ? "uint64" : "uint32";
}

void bind_members(nb::class_<PyDeviceArray>& type) {
  type.def_prop_ro(
      "shape", [](const PyDeviceArray& a) { return shape_of(a.array); },
      nb::for_getter(nb::sig("def shape(self) -> tuple[int, ...]")), "Elements along each axis.");
  type.def_prop_ro(
      "dtype", [](const PyDeviceArray& a) { return dtype_of(a.array.type); }, "Of its elements.");
  type.def_prop_ro(
      "device", [](const PyDeviceArray& a) { return a.array.on_cuda ? "cuda" : "cpu"; },
      "\"cpu\" or \"cuda\".");
  type.def_prop_ro(
      "ordinal", [](const PyDeviceArray& a) { return a.array.device; }, "Of the GPU; 0 on the CPU.");
  type.def_prop_ro(
      "pointer", [](const PyDeviceArray& a) { return reinterpret_cast<uintptr_t>(a.array.data); },
      "The address of the first element.");
  type.def_prop_ro(
      "stream", [](const PyDeviceArray& a) { return reinterpret_cast<uintptr_t>(a.array.stream); },
      "The cudaStream_t that fills the array; 0 on the CPU.");
  type.def_prop_ro(
      "read_only", [](const PyDeviceArray& a) { return a.read_only; }, "Whether it must not be written.");
  type.def("__len__", [](const PyDeviceArray& a) { return a.array.shape[0]; });
  type.def("__repr__", repr);
}

}  // namespace

void bind_device_arrays(nb::module_& module, nb::class_<PyWorld>& world) {
  nb::class_<PyDeviceArray> type(
      module, "DeviceArray",
      "An array in the memory of a world's device. PyTorch, CuPy and JAX take it by from_dlpack, Numba by "
      "__cuda_array_interface__, and NumPy by asarray on the CPU: all the same memory.");
  bind_members(type);
  type.def("__dlpack_device__", dlpack_device);
  type.def(
      "__dlpack__", dlpack, nb::kw_only(), nb::arg("stream") = nb::none(),
      nb::arg("max_version") = nb::none(), nb::arg("dl_device") = nb::none(), nb::arg("copy") = nb::none(),
      nb::sig(
          "def __dlpack__(self, *, stream: int | None = None, max_version: tuple[int, int] | None = None, "
          "dl_device: tuple[int, int] | None = None, copy: bool | None = None) -> typing.Any"),
      "A capsule of DLPack. Work that the stream gets later sees the complete array: None and 1 are the "
      "legacy default stream, 2 the per-thread one, -1 asks for no order. A read-only array raises "
      "BufferError where max_version is below 1.0.");
  type.def_prop_ro("__cuda_array_interface__", cuda_interface,
                   nb::for_getter(nb::sig("def __cuda_array_interface__(self) -> dict[str, typing.Any]")),
                   "Of an array on a GPU. The legacy default stream sees the complete array as well.");
  type.def_prop_ro("__array_interface__", array_interface,
                   nb::for_getter(nb::sig("def __array_interface__(self) -> dict[str, typing.Any]")),
                   "Of an array on the CPU.");
  world.def(
      "device_arrays",
      [](const PyWorld& self) {
        const DeviceArrays all = self.state->measure([](World& w) { return w.device_arrays(); });
        const auto wrap = [&](const DeviceArray& array) { return PyDeviceArray{array, false, self.state}; };
        return make_result("DeviceArrays", wrap(all.ids), wrap(all.positions), wrap(all.velocities),
                           wrap(all.phases));
      },
      nb::sig("def device_arrays(self) -> meniscus.results.DeviceArrays"),
      "The particles in the memory of the world's device, without a copy to the host. Later steps do not "
      "change "
      "them while they are held.");
}

}  // namespace meniscus::python
