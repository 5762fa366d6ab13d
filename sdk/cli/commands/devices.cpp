// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/cli/commands/devices.h"

#include <spdlog/fmt/fmt.h>

#include <meniscus/outputs.h>
#include <algorithm>

#include "sdk/cli/program.h"

namespace meniscus::cli {
namespace {

std::string memory_text(std::size_t bytes) {
  return bytes == 0 ? "" : fmt::format("{:.1f} GiB", static_cast<double>(bytes) / (1u << 30));
}

std::string choice_text(const std::vector<DeviceInfo>& devices) {
  const auto cuda =
      std::find_if(devices.begin(), devices.end(), [](const auto& d) { return d.kind == "cuda"; });
  if (cuda == devices.end()) return "auto takes cpu: there is no other device";
  if (cuda->usable) return "auto takes cuda: a kernel was run there and gave the right answer";
  return "auto takes cpu: cuda cannot be used, " + cuda->reason;
}

}  // namespace

int show_devices() {
  const std::vector<DeviceInfo> devices = list_devices();
  std::size_t width = 4;
  for (const DeviceInfo& device : devices) width = std::max(width, device.name.size());
  const auto row = [&](const std::string& kind, const std::string& name, const std::string& usable,
                       const std::string& memory) {
    fmt::print("{:<6}{:<{}}  {:<8}{}\n", kind, name, width, usable, memory);
  };
  row("kind", "name", "usable", "memory");
  for (const DeviceInfo& device : devices) {
    row(device.kind, device.name.empty() ? "-" : device.name, device.usable ? "yes" : "no",
        device.usable ? memory_text(device.memory_bytes) : device.reason);
  }
  fmt::print("{}\n", choice_text(devices));
  return success;
}

}  // namespace meniscus::cli
