// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Small scenes that between them run nearly every kernel: each object, each solver, each coupling.
#pragma once
#include <meniscus/meniscus.h>

#include <functional>
#include <vector>

namespace meniscus::bench {

struct SmallScene {
  const char* name;
  int frames;
  std::function<void(WorldDef&)> define;
  std::function<void(World&)> build;
};

std::vector<SmallScene> small_scenes();

}  // namespace meniscus::bench
