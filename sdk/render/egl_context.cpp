// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds an EGL display that offers OpenGL 4.5, and makes a context current.
#include "sdk/render/egl_context.h"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <meniscus/error.h>

#include <string_view>
#include <vector>

namespace meniscus::render {

struct EglContext::Names {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
};

namespace {

constexpr const char* remedy =
    "; a GPU's driver brings it, and so do Debian's packages libegl1 and libgl1-mesa-dri, on the CPU";

bool has_extension(const char* all, std::string_view wanted) {
  const std::string_view list = all ? all : "";
  for (std::size_t at = list.find(wanted); at != std::string_view::npos; at = list.find(wanted, at + 1)) {
    const std::size_t end = at + wanted.size();
    if ((at == 0 || list[at - 1] == ' ') && (end == list.size() || list[end] == ' ')) return true;
  }
  return false;
}

/// Looks for the libraries first, because libepoxy ends the program if one is missing.
void need_libraries() {
  if (!dlopen("libEGL.so.1", RTLD_LAZY | RTLD_GLOBAL))
    throw Error(ErrorCode::device, std::string("cannot render: there is no libEGL.so.1") + remedy);
  if (!dlopen("libOpenGL.so.0", RTLD_LAZY | RTLD_GLOBAL) && !dlopen("libGL.so.1", RTLD_LAZY | RTLD_GLOBAL))
    throw Error(ErrorCode::device,
                std::string("cannot render: there is neither libOpenGL.so.0 nor libGL.so.1") + remedy);
}

/// All displays that need no screen: those of devices, hardware first, and Mesa's own.
std::vector<EGLDisplay> displays(EglDevices wanted) {
  std::vector<EGLDisplay> hardware, software;
  const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (has_extension(client, "EGL_EXT_device_enumeration") &&
      has_extension(client, "EGL_EXT_platform_device")) {
    EGLDeviceEXT devices[32];
    EGLint count = 0;
    if (!eglQueryDevicesEXT(32, devices, &count)) count = 0;
    for (EGLint i = 0; i < count; ++i) {
      const bool is_software =
          has_extension(eglQueryDeviceStringEXT(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software");
      (is_software ? software : hardware)
          .push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
    }
  }
  if (wanted == EglDevices::software) return software;
  hardware.insert(hardware.end(), software.begin(), software.end());
  if (has_extension(client, "EGL_MESA_platform_surfaceless"))
    hardware.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  return hardware;
}

/// Whether this display supports OpenGL 4.5; its context is then current.
bool make_current(EGLDisplay display, EGLContext& context) {
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return false;
  constexpr EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                   4,
                                   EGL_CONTEXT_MINOR_VERSION,
                                   5,
                                   EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                   EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                   EGL_NONE};
  if (eglBindAPI(EGL_OPENGL_API)) {
    context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
      return true;
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
  }
  eglTerminate(display);
  return false;
}

}  // namespace

EglContext::EglContext(EglDevices devices) : names_(std::make_unique<Names>()) {
  need_libraries();
  const std::vector<EGLDisplay> all = displays(devices);
  if (all.empty())
    throw Error(ErrorCode::device,
                std::string("cannot render: EGL finds no device that draws without a screen") + remedy);
  for (EGLDisplay display : all) {
    if (!make_current(display, names_->context)) continue;
    names_->display = display;
    return;
  }
  throw Error(ErrorCode::device, "cannot render: none of EGL's " + std::to_string(all.size()) +
                                     " devices gives OpenGL 4.5 without a screen" + remedy);
}

EglContext::~EglContext() {
  eglMakeCurrent(names_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(names_->display, names_->context);
  eglTerminate(names_->display);
}

std::string EglContext::renderer() const {
  return reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

}  // namespace meniscus::render
