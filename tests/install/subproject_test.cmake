# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# Builds Meniscus as a part of a user's project, with FetchContent.
include(${CMAKE_CURRENT_LIST_DIR}/consumer.cmake)

build_and_run_consumer(${FOLDER}/subproject -DMENISCUS_SOURCE=${SOURCE} -DMENISCUS_CUDA=OFF)
