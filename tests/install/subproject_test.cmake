# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# Builds Meniscus as a part of a user's project, with FetchContent. It compiles all of Meniscus, so without optimising.
include(${CMAKE_CURRENT_LIST_DIR}/consumer.cmake)

set(BUILD_TYPE Debug)
build_and_run_consumer(${FOLDER}/subproject -DMENISCUS_MERGE_SOURCES=ON -DMENISCUS_SOURCE=${SOURCE} -DMENISCUS_CUDA=OFF)
