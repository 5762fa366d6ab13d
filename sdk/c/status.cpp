// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The last error of each thread, in buffers that need no memory.
#include "sdk/c/status.h"

#include <meniscus/c/scene.h>
#include <meniscus/scene.h>
#include <meniscus/version.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <iterator>
#include <new>
#include <stdexcept>

namespace meniscus::c {
namespace {

using Text = std::array<char, 4096>;

struct LastError {
  Text message{}, file{}, path{}, fix{};
};

thread_local LastError last_error;

void set(Text& text, const char* value) noexcept {
  const std::size_t length = std::min(std::strlen(value), text.size() - 1);
  std::copy_n(value, length, text.begin());
  text[length] = 0;
}

MeniscusStatus keep(MeniscusStatus status, const char* message, const char* file = "", const char* path = "",
                    const char* fix = "") noexcept {
  set(last_error.message, message);
  set(last_error.file, file);
  set(last_error.path, path);
  set(last_error.fix, fix);
  return status;
}

MeniscusStatus status_of(ErrorCode code) noexcept {
  return static_cast<MeniscusStatus>(static_cast<int>(code) + 1);
}
static_assert(static_cast<int>(ErrorCode::lost) + 1 == MENISCUS_LOST);
static_assert(static_cast<int>(ErrorCode::non_finite) + 1 == MENISCUS_NON_FINITE);

/// In the order of MeniscusStatus.
constexpr const char* status_names[] = {
    "ok",         "invalid_argument", "not_found",     "io",        "parse", "mesh",    "capacity",
    "non_finite", "device",           "out_of_memory", "cancelled", "lost",  "internal"};
static_assert(std::size(status_names) == MENISCUS_INTERNAL + 1);

}  // namespace

MeniscusStatus status_of_exception() noexcept {
  try {
    throw;
  } catch (const SceneError& e) {
    return keep(status_of(e.code()), e.what(), e.file().c_str(), e.path().c_str(), e.fix().c_str());
  } catch (const Error& e) {
    return keep(status_of(e.code()), e.what());
  } catch (const std::length_error&) {  // a list longer than any memory
    return keep(MENISCUS_OUT_OF_MEMORY, "a list is too long; nothing has changed");
  } catch (const std::bad_alloc&) {
    return keep(MENISCUS_OUT_OF_MEMORY, "no memory on the host for the call; nothing has changed");
  } catch (const std::exception& e) {
    return keep(MENISCUS_INTERNAL, e.what());
  } catch (...) {
    return keep(MENISCUS_INTERNAL, "an exception of an unknown type");
  }
}

}  // namespace meniscus::c

using namespace meniscus::c;

const char* meniscus_last_error() {
  return last_error.message.data();
}

void meniscus_scene_error(const char** file, const char** path, const char** fix) {
  if (file) *file = last_error.file.data();
  if (path) *path = last_error.path.data();
  if (fix) *fix = last_error.fix.data();
}

const char* meniscus_status_name(MeniscusStatus status) {
  const auto number = static_cast<std::size_t>(status);
  return number < std::size(status_names) ? status_names[number] : "unknown";
}

const char* meniscus_version() {
  return MENISCUS_VERSION_STRING;
}
