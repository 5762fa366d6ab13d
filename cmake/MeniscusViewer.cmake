# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# Decides whether the window is built: MENISCUS_VIEWER is AUTO (where the renderer is built, and GLFW and Dear ImGui are
# found), ON or OFF in the cache, and true or false after this file. Where it is not built, MENISCUS_NO_VIEWER_REASON
# says why.

set(MENISCUS_VIEWER AUTO CACHE STRING "Build the window, `meniscus view`: AUTO, ON or OFF")
set_property(CACHE MENISCUS_VIEWER PROPERTY STRINGS AUTO ON OFF)
set(MENISCUS_NO_VIEWER_REASON "it was switched off")
if(MENISCUS_VIEWER)
  set(missing "")
  if(NOT MENISCUS_RENDER)
    list(APPEND missing "the renderer")
  endif()
  find_package(PkgConfig QUIET)
  if(PkgConfig_FOUND)
    pkg_check_modules(MENISCUS_GLFW IMPORTED_TARGET QUIET glfw3)
    pkg_check_modules(MENISCUS_IMGUI QUIET imgui)
  endif()
  if(NOT MENISCUS_GLFW_FOUND)
    list(APPEND missing "GLFW")
  endif()
  find_path(MENISCUS_IMGUI_BACKENDS backends/imgui_impl_opengl3.h HINTS ${MENISCUS_IMGUI_INCLUDE_DIRS})
  if(NOT MENISCUS_IMGUI_FOUND OR NOT MENISCUS_IMGUI_BACKENDS)
    list(APPEND missing "Dear ImGui")
  endif()
  list(JOIN missing " and " missing)
  if(missing)
    set(MENISCUS_NO_VIEWER_REASON "${missing} was not found when it was built")
    if(NOT MENISCUS_VIEWER STREQUAL AUTO)
      message(FATAL_ERROR
        "MENISCUS_VIEWER is ON, but ${missing} is not here (Debian: libglfw3-dev libimgui-dev)")
    endif()
    set(MENISCUS_VIEWER OFF)
  else()
    set(MENISCUS_VIEWER ON)
  endif()
endif()
if(MENISCUS_VIEWER)
  message(STATUS "Meniscus: with the window")
else()
  message(STATUS "Meniscus: without the window (${MENISCUS_NO_VIEWER_REASON})")
endif()
