// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads plain values and arrays from Python objects.
#include "sdk/python/values/from_python.h"

#include <nanobind/ndarray.h>

#include <cstring>
#include <limits>

#include "sdk/scene/closest_name.h"

namespace meniscus::python {

void refuse(const Place& place, const std::string& allowed, nb::handle given) {
  const std::string type = nb::cast<std::string>(nb::handle(given.type()).attr("__name__"));
  throw nb::type_error((place.text() + " must be " + allowed + ", not " + type).c_str());
}

void refuse_key(const std::string& owner, const std::string& key, const std::vector<std::string>& known) {
  throw nb::type_error((owner + "() has no argument '" + key + "'; " + name_hint(key, known)).c_str());
}

namespace {

double number(nb::handle given, const Place& place) {
  const double x = PyFloat_AsDouble(given.ptr());
  if (x == -1 && PyErr_Occurred()) {
    PyErr_Clear();
    refuse(place, "a number", given);
  }
  return x;
}

long long whole_number(nb::handle given, const Place& place, long long low, long long high) {
  const nb::object index = nb::steal(PyNumber_Index(given.ptr()));
  if (!index.is_valid()) {
    PyErr_Clear();
    refuse(place, "a whole number", given);
  }
  int overflow = 0;
  const long long x = PyLong_AsLongLongAndOverflow(index.ptr(), &overflow);
  if (overflow || x < low || x > high)
    throw nb::value_error((place.text() + " is " + nb::cast<std::string>(nb::str(index)) +
                           "; must be at least " + std::to_string(low) + " and at most " +
                           std::to_string(high))
                              .c_str());
  return x;
}

template <std::size_t count>
void read_numbers(nb::handle given, const Place& place, float (&out)[count]) {
  const std::string allowed = std::to_string(count) + " numbers";
  const nb::object items = nb::steal(PySequence_Fast(given.ptr(), ""));
  if (!items.is_valid()) {
    PyErr_Clear();
    refuse(place, allowed, given);
  }
  const Py_ssize_t size = PySequence_Size(items.ptr());
  if (size != static_cast<Py_ssize_t>(count) || nb::isinstance<nb::str>(given))
    throw nb::type_error((place.text() + " must be " + allowed + ", not " + std::to_string(size)).c_str());
  for (std::size_t i = 0; i < count; ++i) out[i] = static_cast<float>(number(items[i], place));
}

nb::object as_numpy(nb::handle given, const Place& place) {
  try {
    const nb::module_ numpy = nb::module_::import_("numpy");
    // A library that offers nothing but DLPack.
    if (nb::hasattr(given, "__dlpack__") && !nb::hasattr(given, "__array__"))
      return numpy.attr("from_dlpack")(given);
    return numpy.attr("asarray")(given);
  } catch (const nb::python_error& error) {
    throw nb::type_error((place.text() + " is no array on the host: " + error.what()).c_str());
  }
}

/// The array as one of this type, converted if it has another.
template <class T>
nb::object converted(nb::handle given, const Place& place, const char* dtype) {
  const nb::object array = as_numpy(given, place);
  const auto kind = nb::cast<std::string>(array.attr("dtype").attr("kind"));
  const bool empty = nb::cast<std::size_t>(array.attr("size")) == 0;
  const bool real = std::is_floating_point_v<T>;
  if (!empty && kind != "i" && kind != "u" && !(real && kind == "f"))
    refuse(place, real ? "an array of numbers" : "an array of whole numbers", given);
  if (!real && !empty && kind == "i" && nb::cast<double>(array.attr("min")()) < 0)
    throw nb::value_error((place.text() + " must not hold negative numbers").c_str());
  if (!real && !empty && nb::cast<double>(array.attr("max")()) > double(std::numeric_limits<T>::max()))
    throw nb::value_error((place.text() + " holds a number that is too large").c_str());
  return nb::module_::import_("numpy").attr("ascontiguousarray")(array, dtype);
}

template <class T, std::size_t width, class Item>
void read_array(nb::handle given, const Place& place, const char* dtype, std::vector<Item>& out) {
  static_assert(sizeof(Item) == width * sizeof(T));
  using Array = nb::ndarray<const T, nb::c_contig, nb::device::cpu>;
  Array array;
  if (!nb::try_cast(given, array, false)) array = nb::cast<Array>(converted<T>(given, place, dtype));
  const bool fits = width == 1 ? array.ndim() == 1 : array.ndim() == 2 && array.shape(1) == width;
  if (!fits && array.size() > 0)
    throw nb::type_error((place.text() + " must be an array of shape (n" +
                          (width == 1 ? std::string(",)") : ", " + std::to_string(width) + ")"))
                             .c_str());
  out.resize(array.size() / width);
  if (!out.empty()) std::memcpy(out.data(), array.data(), out.size() * sizeof(Item));
}

}  // namespace

void read(nb::handle given, const Place& place, float& value) {
  value = static_cast<float>(number(given, place));
}
void read(nb::handle given, const Place& place, int& value) {
  value = static_cast<int>(
      whole_number(given, place, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()));
}
void read(nb::handle given, const Place& place, uint32_t& value) {
  value = static_cast<uint32_t>(whole_number(given, place, 0, std::numeric_limits<uint32_t>::max()));
}
void read(nb::handle given, const Place& place, bool& value) {
  if (!nb::try_cast(given, value)) refuse(place, "True or False", given);
}
void read(nb::handle given, const Place& place, std::string& value) {
  const nb::object path = nb::steal(PyOS_FSPath(given.ptr()));  // a str, or a path
  if (path.is_valid() && nb::try_cast(path, value)) return;
  PyErr_Clear();
  refuse(place, "a str", given);
}
void read(nb::handle given, const Place& place, Vec3& value) {
  float numbers[3];
  read_numbers(given, place, numbers);
  value = {numbers[0], numbers[1], numbers[2]};
}
void read(nb::handle given, const Place& place, Quat& value) {
  float numbers[4];
  read_numbers(given, place, numbers);
  value = {numbers[0], numbers[1], numbers[2], numbers[3]};
}
void read(nb::handle given, const Place& place, std::vector<Vec3>& values) {
  read_array<float, 3>(given, place, "float32", values);
}
void read(nb::handle given, const Place& place, std::vector<float>& values) {
  read_array<float, 1>(given, place, "float32", values);
}
void read(nb::handle given, const Place& place, std::vector<uint32_t>& values) {
  read_array<uint32_t, 1>(given, place, "uint32", values);
}
void read(nb::handle given, const Place& place, std::vector<ParticleId>& values) {
  read_array<ParticleId, 1>(given, place, "uint64", values);
}

}  // namespace meniscus::python
