// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Makes the materials of USD stages.
#include "sdk/io/usd/usd_materials.h"

#include <spdlog/fmt/fmt.h>

namespace meniscus::io {

std::string UsdMaterials::add(const std::string& name, const UsdLook& look) {
  const std::string prim = names_.add(name, "material");
  const std::string path = "/scene/materials/" + prim;
  UsdPrim shader{"Shader", "surface", {}, {}, {}, {}};
  shader.attributes = {"uniform token info:id = \"UsdPreviewSurface\"",
                       "color3f inputs:diffuseColor = " + usd_value(look.color),
                       fmt::format("float inputs:roughness = {}", look.roughness),
                       "float inputs:metallic = 0"};
  if (look.is_liquid) {
    shader.attributes.push_back("float inputs:ior = 1.333");
    shader.attributes.push_back("float inputs:opacity = 0.3");
  }
  shader.attributes.push_back("token outputs:surface");
  UsdPrim material{"Material", prim, {}, {}, {}, {shader}};
  material.attributes = {"token outputs:surface.connect = <" + path + "/surface.outputs:surface>"};
  materials_.push_back(std::move(material));
  return "rel material:binding = <" + path + ">";
}

}  // namespace meniscus::io
