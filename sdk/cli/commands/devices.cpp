// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Implements `meniscus devices`: the table of devices, and the device memory that a scene takes.
#include "sdk/cli/commands/devices.h"

#include <spdlog/fmt/fmt.h>

#include <meniscus/outputs.h>
#include <algorithm>

#include "sdk/cli/commands/exit_code.h"
#include "sdk/cli/record/json_text.h"
#include "sdk/io/plain_text.h"

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

std::size_t vertices_of(const BuiltScene& built) {
  std::size_t vertices = 0;
  for (const ClothId id : built.cloths) vertices += built.world.cloth_positions(id).size();
  for (const RopeId id : built.ropes) vertices += built.world.rope_positions(id).size();
  return vertices;
}

/// Prints the largest, one per line, and the sum of those below a thousandth of the whole.
void print_shares(const std::vector<MemoryShare>& shares, std::size_t elements) {
  std::size_t all = 0, small = 0, width = 0;
  for (const MemoryShare& share : shares) {
    all += share.bytes;
    width = std::max(width, share.what.size());
  }
  const auto row = [&](const std::string& what, std::size_t bytes) {
    fmt::print("{:<{}}  {:>10.2f} MiB", what, width, static_cast<double>(bytes) / (1u << 20));
    if (elements > 0)
      fmt::print("  {:>8.1f} B each", static_cast<double>(bytes) / static_cast<double>(elements));
    fmt::print("\n");
  };
  for (const MemoryShare& share : shares) {
    if (share.bytes < all / 1000)
      small += share.bytes;
    else
      row(share.what, share.bytes);
  }
  row("smaller ones", small);
  row("all", all);
}

nlohmann::ordered_json json_of(const std::vector<DeviceInfo>& devices) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const DeviceInfo& device : devices) {
    list.push_back({{"kind", device.kind},
                    {"name", device.name},
                    {"usable", device.usable},
                    {"reason", device.reason},
                    {"memory_bytes", device.memory_bytes}});
  }
  const bool cuda =
      std::any_of(devices.begin(), devices.end(), [](const auto& d) { return d.kind == "cuda" && d.usable; });
  return {{"devices", list}, {"auto", cuda ? "cuda" : "cpu"}, {"reason", choice_text(devices)}};
}

nlohmann::ordered_json json_of(const std::vector<MemoryShare>& shares) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const MemoryShare& share : shares) list.push_back({{"what", share.what}, {"bytes", share.bytes}});
  return list;
}

}  // namespace

int show_devices(bool json) {
  const std::vector<DeviceInfo> devices = list_devices();
  if (json) {
    print_json(json_of(devices));
    return success;
  }
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

int show_memory(const SceneChoice& choice, bool json) {
  Scene scene = chosen_scene(choice);
  scene.relax_iterations = 0;
  const BuiltScene built = build_scene(scene);
  const DeviceInfo device = built.world.device();
  const std::size_t particles = built.world.particle_count(), vertices = vertices_of(built);
  if (json) {
    print_json({{"scene", scene.name},
                {"device", {{"kind", device.kind}, {"name", device.name}}},
                {"particles", particles},
                {"vertices", vertices},
                {"bytes", built.world.device_bytes()},
                {"shares", json_of(built.world.memory_shares())}});
    return success;
  }
  fmt::print("{} on {} ({}): {} particles, {} vertices of cloth and ropes\n", io::plain_text(scene.name),
             device.kind, device.name, particles, vertices);
  print_shares(built.world.memory_shares(), particles + vertices);
  fmt::print("as the first step starts; lists of neighbours and contacts grow where there are more{}\n",
             scene.emitters.empty() ? "" : ", and all with what is emitted");
  return success;
}

}  // namespace meniscus::cli
