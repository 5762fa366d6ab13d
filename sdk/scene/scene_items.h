// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Goes over the items of a list of a scene. Errors name the item.
#pragma once

#include <meniscus/scene.h>

#include <new>
#include <string>
#include <vector>

namespace meniscus {

const std::string& name_of(const auto& item) {
  if constexpr (requires { item.name; })
    return item.name;
  else
    return item.def.name;
}
inline const std::string& name_of(const SceneVolume& volume) {
  return volume.fluid;
}

/// Calls use(item) for each item. What it throws becomes a SceneError that names the item, as in
/// cloths[0] ("flag").
template <class Item, class Use>
void for_each_item(const char* key, const std::vector<Item>& items, const Use& use) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    const auto fail = [&](ErrorCode code, const char* why) {
      const std::string path = std::string(key) + "[" + std::to_string(i) + "]";
      throw SceneError(code, path + " (\"" + name_of(items[i]) + "\"): " + why, "", path);
    };
    try {
      use(items[i]);
    } catch (const Error& error) {
      fail(error.code(), error.what());
    } catch (const std::bad_alloc&) {
      fail(ErrorCode::out_of_memory, "there is not enough memory for it");
    }
  }
}

}  // namespace meniscus
