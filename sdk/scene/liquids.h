// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Names of the liquids that pictures know.
#pragma once

#include <meniscus/scene.h>

#include <array>

#include "sdk/fields/names.h"

namespace meniscus {

constexpr auto names_of(Liquid) {
  return std::array{Named{"clear", Liquid::clear}, Named{"sea", Liquid::sea},     Named{"pool", Liquid::pool},
                    Named{"milk", Liquid::milk},   Named{"honey", Liquid::honey}, Named{"oil", Liquid::oil}};
}

}  // namespace meniscus
