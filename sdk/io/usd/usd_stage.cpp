// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Writes the layers of a USD stage as text.
#include "sdk/io/usd/usd_stage.h"

#include <spdlog/fmt/fmt.h>

#include <utility>

namespace meniscus::io {
namespace {

class Writer {
 public:
  Writer(const UsdSink& out, const UsdStage& stage, const UsdSamples& samples, bool defines)
      : out_(out), stage_(stage), samples_(samples), defines_(defines) {}

  void write(const UsdPrim& prim, int depth) const {
    if (!defines_ && !has_varying(prim)) return;
    const std::string indent(4 * static_cast<std::size_t>(depth), ' ');
    out_(indent + (defines_ ? "def " + prim.type : "over") + " \"" + prim.name + '"');
    if (defines_ && !prim.metadata.empty()) {
      out_(" (\n");
      for (const std::string& line : prim.metadata) out_(indent + "    " + line + '\n');
      out_(indent + ')');
    }
    out_("\n" + indent + "{\n");
    for (std::size_t i = 0; defines_ && i < prim.attributes.size(); ++i)
      out_(indent + "    " + prim.attributes[i] + '\n');
    for (const std::size_t number : prim.varying) write_attribute(number, indent + "    ");
    for (const UsdPrim& child : prim.children) write(child, depth + 1);
    out_(indent + "}\n");
  }

 private:
  static bool has_varying(const UsdPrim& prim) {
    if (!prim.varying.empty()) return true;
    for (const UsdPrim& child : prim.children) {
      if (has_varying(child)) return true;
    }
    return false;
  }

  void write_attribute(std::size_t number, const std::string& indent) const {
    const UsdVarying& attribute = stage_.varying[number];
    const std::string metadata = attribute.metadata.empty() ? "" : " (" + attribute.metadata + ")";
    if (defines_ || !samples_) out_(indent + attribute.declaration + metadata + '\n');
    if (!samples_) return;
    out_(indent + attribute.declaration + ".timeSamples = { ");
    samples_(out_, number);
    out_("}\n");
  }

  const UsdSink& out_;
  const UsdStage& stage_;
  const UsdSamples& samples_;
  bool defines_;
};

}  // namespace

std::size_t UsdStage::vary(UsdPrim& prim, UsdVarying attribute) {
  varying.push_back(std::move(attribute));
  prim.varying.push_back(varying.size() - 1);
  return varying.size() - 1;
}

std::string usd_head(const UsdStage& stage, int first_frame, int last_frame, const std::string& more) {
  return fmt::format(
      "#usda 1.0\n(\n    defaultPrim = \"{}\"\n    metersPerUnit = 1\n    upAxis = \"{}\"\n"
      "    startTimeCode = {}\n    endTimeCode = {}\n    timeCodesPerSecond = {}\n    framesPerSecond = {}\n"
      "{})\n\n",
      stage.root.name, stage.up_axis, first_frame, last_frame, stage.frames_a_second, stage.frames_a_second,
      more);
}

void write_prims(const UsdSink& out, const UsdStage& stage, const UsdSamples& samples) {
  Writer(out, stage, samples, true).write(stage.root, 0);
}

void write_overs(const UsdSink& out, const UsdStage& stage, const UsdSamples& samples) {
  Writer(out, stage, samples, false).write(stage.root, 0);
}

}  // namespace meniscus::io
