// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Expects that a call throws an Error with a given code and message.
#pragma once

#include <gtest/gtest.h>
#include <meniscus/error.h>

#include <string>

namespace meniscus::tests {

/// The call must throw Error with this code and a message in which `named` occurs.
template <class Call>
void expect_error(ErrorCode code, const std::string& named, const Call& call) {
  try {
    call();
    ADD_FAILURE() << "no error, where one that names " << named << " was due";
  } catch (const Error& error) {
    EXPECT_EQ(static_cast<int>(error.code()), static_cast<int>(code)) << error.what();
    EXPECT_NE(std::string(error.what()).find(named), std::string::npos)
        << '"' << error.what() << "\" does not name " << named;
  }
}

}  // namespace meniscus::tests
