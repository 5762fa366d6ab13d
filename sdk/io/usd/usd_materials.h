// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Materials of USD stages.
#pragma once

#include <meniscus/types.h>

#include <string>

#include "sdk/io/usd/usd_stage.h"
#include "sdk/io/usd/usd_text.h"

namespace meniscus::io {

/// How a surface looks: UsdPreviewSurface.
struct UsdLook {
  Vec3 color;       ///< linear RGB
  float roughness;  ///< 0 to 1
  bool is_liquid = false;
};

/// The roughness of each kind of thing. Definitions have a colour alone. These are near the gloss of the
/// preview, and are meant to be changed by an artist.
namespace usd_roughness {
inline constexpr float liquid = 0.05f, grains = 0.9f, cloth = 0.8f, rope = 0.7f, body = 0.5f, shape = 0.6f;
}

/// The materials of a stage: the children of /scene/materials.
class UsdMaterials {
 public:
  /// Adds a material; returns what binds a prim to it.
  std::string add(const std::string& name, const UsdLook& look);
  /// The prim of all materials.
  UsdPrim prim() const { return {"Scope", "materials", {}, {}, {}, materials_}; }

 private:
  UsdNames names_;
  std::vector<UsdPrim> materials_;
};

/// What a prim that is bound to a material must say.
inline constexpr const char* usd_binding_schema = "prepend apiSchemas = [\"MaterialBindingAPI\"]";

}  // namespace meniscus::io
