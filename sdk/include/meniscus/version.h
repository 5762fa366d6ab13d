// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The version of Meniscus. CMake reads the project's version from here.
#pragma once

#define MENISCUS_VERSION_MAJOR 0
#define MENISCUS_VERSION_MINOR 2
#define MENISCUS_VERSION_PATCH 0

#define MENISCUS_VERSION_TEXT_(x) #x
#define MENISCUS_VERSION_JOIN_(major, minor, patch) \
  MENISCUS_VERSION_TEXT_(major) "." MENISCUS_VERSION_TEXT_(minor) "." MENISCUS_VERSION_TEXT_(patch)

/// "MAJOR.MINOR.PATCH"
#define MENISCUS_VERSION_STRING \
  MENISCUS_VERSION_JOIN_(MENISCUS_VERSION_MAJOR, MENISCUS_VERSION_MINOR, MENISCUS_VERSION_PATCH)
