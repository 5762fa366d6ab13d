// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Which devices this machine has, for tests that run once on each of them.
#pragma once

#include <gtest/gtest.h>
#include <meniscus/defs.h>

#include <ostream>
#include <string>
#include <vector>

#include "pbd/device/choose.h"
#include "pbd/device/device.h"

namespace meniscus::pbd {

inline void PrintTo(DeviceKind kind, std::ostream* out) {
  *out << (kind == DeviceKind::cuda ? "cuda" : "cpu");
}

}  // namespace meniscus::pbd

namespace meniscus::tests {

inline std::vector<pbd::DeviceKind> usable_devices() {
  if (pbd::cuda_status().usable) return {pbd::DeviceKind::cpu, pbd::DeviceKind::cuda};
  return {pbd::DeviceKind::cpu};
}

inline DeviceChoice choice_of(pbd::DeviceKind kind) {
  return kind == pbd::DeviceKind::cuda ? DeviceChoice::cuda : DeviceChoice::cpu;
}

/// A suite that is declared as a class derived from this runs on each usable device.
class OnDevice : public testing::TestWithParam<pbd::DeviceKind> {};

inline std::string device_test_name(const testing::TestParamInfo<pbd::DeviceKind>& info) {
  return testing::PrintToString(info.param);
}

}  // namespace meniscus::tests

#define MENISCUS_ON_EACH_DEVICE(suite)                                                      \
  INSTANTIATE_TEST_SUITE_P(On, suite, testing::ValuesIn(meniscus::tests::usable_devices()), \
                           meniscus::tests::device_test_name)
