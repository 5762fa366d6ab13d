# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# Sets MENISCUS_VERSION to the version that the public header states.

set(meniscus_version_header ${CMAKE_CURRENT_LIST_DIR}/../sdk/include/meniscus/version.h)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${meniscus_version_header})
file(READ ${meniscus_version_header} MENISCUS_VERSION)
string(REGEX MATCHALL "VERSION_(MAJOR|MINOR|PATCH) [0-9]+" MENISCUS_VERSION "${MENISCUS_VERSION}")
list(TRANSFORM MENISCUS_VERSION REPLACE "VERSION_[A-Z]+ " "")
list(JOIN MENISCUS_VERSION "." MENISCUS_VERSION)
