// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Writes value clips, and joins those of short runs.
#include "sdk/io/usd/usd_recording.h"

#include <spdlog/fmt/fmt.h>

#include <utility>

#include "sdk/files/output_file.h"

namespace meniscus::io {
namespace {

constexpr const char* static_layer = "frames/usd_static.usda";
constexpr const char* manifest = "frames/usd_manifest.usda";

UsdSink sink_of(OutputFile& file) {
  return [&file](std::string_view text) { file.write(text); };
}

/// A layer of all prims, or of what varies, without samples.
template <class Write>
void write_layer(const std::filesystem::path& path, const UsdStage& stage, int frame, const Write& write) {
  OutputFile file(path);
  file.write(usd_head(stage, frame, frame));
  write(sink_of(file), stage, UsdSamples{});
  file.commit();
}

void write_sample(const UsdSink& out, int frame, const std::string& value) {
  out(std::to_string(frame));
  out(": ");
  out(value);
  out(", ");
}

}  // namespace

UsdRecording::UsdRecording(std::filesystem::path folder, UsdStage stage, std::size_t one_file)
    : folder_(std::move(folder)), stage_(std::move(stage)), one_file_(one_file) {}

void UsdRecording::add(int frame, std::vector<std::string> values) {
  if (frames_.empty()) begin(frame);
  for (const std::string& value : values) bytes_ += value.size();
  frames_.push_back({frame, std::move(values)});
  const std::size_t count = frames_.size();
  if (count > 1) {
    write_clip(frames_[count - 2], &frames_[count - 1]);
    write_master(frame - 1);
    written_ = frame - 1;
  }
  if (bytes_ > one_file_) frames_.erase(frames_.begin(), frames_.end() - 1);
}

void UsdRecording::finish() {
  if (frames_.empty() || written_ == frames_.back().number) return;
  if (bytes_ > one_file_) {
    write_clip(frames_.back(), nullptr);
    write_master(frames_.back().number);
  } else {
    write_one_file();
    remove_clips();
  }
  written_ = frames_.back().number;
}

std::filesystem::path UsdRecording::clip(int frame) const {
  return folder_ / fmt::format("frames/usd.{:05}.usda", frame);
}

void UsdRecording::begin(int frame) {
  first_ = frame;
  written_ = frame - 1;
  write_layer(folder_ / static_layer, stage_, frame, write_prims);
  write_layer(folder_ / manifest, stage_, frame, write_overs);
}

void UsdRecording::write_clip(const Frame& frame, const Frame* next) const {
  OutputFile file(clip(frame.number));
  file.write(usd_head(stage_, frame.number, frame.number));
  write_overs(sink_of(file), stage_, [&](const UsdSink& out, std::size_t number) {
    write_sample(out, frame.number, frame.values[number]);
    if (next && stage_.varying[number].interpolates) write_sample(out, next->number, next->values[number]);
  });
  file.commit();
}

void UsdRecording::write_master(int last) const {
  OutputFile file(folder_ / "scene.usda");
  file.write(usd_head(stage_, first_, last, fmt::format("    subLayers = [@./{}@]\n", static_layer)));
  file.write(
      fmt::format("over \"{}\" (\n"
                  "    clips = {{\n"
                  "        dictionary default = {{\n"
                  "            string primPath = \"/{}\"\n"
                  "            asset manifestAssetPath = @./{}@\n"
                  "            string templateAssetPath = \"./frames/usd.#####.usda\"\n"
                  "            double templateStartTime = {}\n"
                  "            double templateEndTime = {}\n"
                  "            double templateStride = 1\n"
                  "        }}\n"
                  "    }}\n"
                  ")\n{{\n}}\n",
                  stage_.root.name, stage_.root.name, manifest, first_, last));
  file.commit();
}

void UsdRecording::write_one_file() const {
  OutputFile file(folder_ / "scene.usda");
  file.write(usd_head(stage_, first_, frames_.back().number));
  write_prims(sink_of(file), stage_, [&](const UsdSink& out, std::size_t number) {
    for (const Frame& frame : frames_) write_sample(out, frame.number, frame.values[number]);
  });
  file.commit();
}

void UsdRecording::remove_clips() const {
  std::error_code ignored;
  for (int frame = first_; frame < frames_.back().number; ++frame)
    std::filesystem::remove(clip(frame), ignored);
  std::filesystem::remove(folder_ / static_layer, ignored);
  std::filesystem::remove(folder_ / manifest, ignored);
}

}  // namespace meniscus::io
