// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Puts the figures of summary.json into words.
#include "sdk/cli/record/run_summary.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace meniscus::cli {
namespace {

using json = nlohmann::ordered_json;

std::string line(const char* label, const std::string& text) {
  return fmt::format("  {:<15}{}\n", label, text);
}

std::string text_of(const json& object, const char* key) {
  return object.at(key).get<std::string>();
}
double number(const json& object, const char* key) {
  return object.at(key).get<double>();
}
uint64_t count(const json& object, const char* key) {
  return object.at(key).get<uint64_t>();
}

std::string heading(const json& figures) {
  const json& device = figures.at("device");
  std::string text = fmt::format("{} on {}: {}\n", text_of(figures, "scene"), text_of(device, "kind"),
                                 text_of(device, "name"));
  if (const std::string reason = text_of(device, "reason"); !reason.empty()) text += line("", reason);
  if (figures.at("interrupted").get<bool>())
    text += "  INTERRUPTED: what follows is of the frames that were done\n";
  if (!figures.at("error").is_null()) text += "  FAILED: what follows is of the frames that were done\n";
  return text;
}

std::string run_line(const json& figures) {
  return fmt::format(
      "{} frames of {:.4g} ms, {:.4g} s in all; {} substeps of {} iterations, {:.3g} of the density ({})",
      count(figures, "frames"), 1000 * number(figures, "time_step_s"), number(figures, "simulated_s"),
      count(figures, "substeps"), count(figures, "iterations"), number(figures, "density_iterations"),
      text_of(figures, "density_solver"));
}

std::string time_line(const json& ms) {
  std::string text = fmt::format("{:.2f} ms median, {:.2f} ms at the 90th percentile", number(ms, "median"),
                                 number(ms, "p90"));
  for (const auto& [stage, value] : ms.at("stages").items()) {
    text += fmt::format("\n{:17}{:<12}{:9.2f} ms", "", stage, value.get<double>());
  }
  return text;
}

std::string density_line(const json& density) {
  return fmt::format("{:.3f} % mean, {:.3f} % at the 99th percentile, {:.3f} % at most",
                     number(density, "mean"), number(density, "p99"), number(density, "max"));
}

std::string energy_line(const json& energy) {
  std::string text = fmt::format("{:.4g} J at the start, {:.4g} J at the end", number(energy, "start_j"),
                                 number(energy, "end_j"));
  if (energy.at("max_ratio").is_null()) return text;
  return text + fmt::format("; at most {:.4f} of the start", number(energy, "max_ratio"));
}

std::string flow_line(const json& figures) {
  return fmt::format("{} particles from emitters, {} removed by sinks", count(figures, "emitted"),
                     count(figures, "removed"));
}

std::string diffuse_line(const json& diffuse) {
  std::string text =
      fmt::format("{} of spray, {} of foam, {} bubbles at the end; {} at most", count(diffuse, "spray"),
                  count(diffuse, "foam"), count(diffuse, "bubbles"), count(diffuse, "most"));
  if (const uint64_t refused = count(diffuse, "refused"); refused > 0)
    text += fmt::format("; {} found no room", refused);
  return text;
}

std::string trouble_line(const json& figures) {
  return fmt::format("{} outside, {} not finite", count(figures, "outside"), count(figures, "non_finite"));
}

/// What exceeded a fixed size (Overflows in outputs.h); empty if nothing did.
std::string overflow_line(const json& overflows) {
  std::string text;
  for (const auto& [name, value] : overflows.items()) {
    if (value != 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, value.get<uint64_t>());
  }
  return text;
}

std::string body_line(const json& bodies) {
  const auto awake = std::count_if(bodies.begin(), bodies.end(),
                                   [](const json& body) { return body.at("awake").get<bool>(); });
  return fmt::format("{}, of which {} awake at the end", bodies.size(), awake);
}

std::string cloth_line(const json& cloth) {
  return fmt::format(
             "{}: {} vertices, {} triangles, {:.4g} kg; stretched by {:.3g} % on average, {:.3g} % at most",
             text_of(cloth, "name"), count(cloth, "vertices"), count(cloth, "triangles"),
             number(cloth, "mass_kg"), 100 * number(cloth, "mean_stretch"),
             100 * (number(cloth, "max_stretch") - 1)) +
         (count(cloth, "welded_vertices") > 0
              ? fmt::format("; {} vertices welded", count(cloth, "welded_vertices"))
              : "") +
         (number(cloth, "bending_fraction") < 0.99
              ? fmt::format("; bends {:.3g} times as stiffly as asked, for substeps that are too long",
                            number(cloth, "bending_fraction"))
              : "") +
         (count(cloth, "tears") > 0 ? fmt::format("; {} tears", count(cloth, "tears")) : "");
}

std::string rope_line(const json& rope) {
  return fmt::format("{}: {:.4g} m long, {:.4g} m at the start", text_of(rope, "name"),
                     number(rope, "length_m"), number(rope, "start_m"));
}

/// "0.2 to 1.5 m", "at least 0.2", "0".
std::string range_text(const json& low, const json& high, const std::string& unit) {
  const auto text = [](const json& value) { return fmt::format("{:.4g}", value.get<double>()); };
  std::string range = low.is_null()    ? "at most " + text(high)
                      : high.is_null() ? "at least " + text(low)
                      : low == high    ? text(low)
                                       : text(low) + " to " + text(high);
  return unit.empty() ? range : range + " " + unit;
}

/// The files of one kind of object, if there are any.
std::string file_list(const std::vector<std::string>& formats, const json& figures,
                      const std::vector<std::string>& pictures, bool surfaces) {
  std::string text = "summary.json, frames.csv, preview.png";
  if (!figures.at("density_error").is_null()) text += ", density.svg";
  const auto add_for = [&](const char* kind, const char* file) {
    if (!figures.at(kind).empty()) text += std::string(", ") + file;
  };
  add_for("bodies", "bodies.csv");
  add_for("cloths", "cloths.csv");
  add_for("attachments", "attachments.csv");
  for (const std::string& picture : pictures) text += ", " + picture;
  for (const std::string& format : formats) {
    text += format == "usd" ? ", scene.usda" : format == "abc" ? ", scene.abc" : ", frames/*." + format;
    if (format != "vtp") continue;
    const bool cloth_alone = !figures.at("cloths").empty() || !figures.at("ropes").empty();
    if (count(figures, "particles") > 0 || !cloth_alone) text += ", particles.pvd";
    if (surfaces) text += ", surface.pvd";
    add_for("bodies", "bodies.pvd");
    add_for("cloths", "cloth.pvd");
    add_for("ropes", "ropes.pvd");
  }
  return text;
}

}  // namespace

std::string check_line(const json& check) {
  const std::string unit = text_of(check, "unit"), state = text_of(check, "state");
  std::string text = fmt::format("\"{}\" {}", text_of(check, "name"), state);
  if (state == "broken") text += fmt::format(" at {:.4g} s", number(check, "broken_at_s"));
  text += fmt::format(": {} ", text_of(check, "type"));
  if (state != "not reached") text += "was " + range_text(check.at("least"), check.at("most"), unit) + ", ";
  return text + "allowed is " + range_text(check.at("low"), check.at("high"), unit);
}

std::string run_summary(const json& figures, const std::filesystem::path& folder,
                        const std::vector<std::string>& formats, const std::vector<std::string>& pictures,
                        bool surfaces) {
  std::string text = heading(figures);
  text += line("run", run_line(figures));
  text += line("particles", fmt::format("{}, in {:.1f} MiB on the device", count(figures, "particles"),
                                        number(figures, "device_bytes") / (1 << 20)));
  text += line("time a step", time_line(figures.at("ms_per_step")));
  if (!figures.at("density_error").is_null())
    text += line("density error", density_line(figures.at("density_error")));
  if (!figures.at("energy").is_null()) text += line("energy", energy_line(figures.at("energy")));
  text += line("lost", trouble_line(figures));
  const std::string overflows = overflow_line(figures.at("overflows"));
  if (!overflows.empty()) text += line("overflows", overflows);
  if (!figures.at("emitters").empty() || !figures.at("sinks").empty())
    text += line("flow", flow_line(figures));
  if (!figures.at("diffuse").is_null()) text += line("diffuse", diffuse_line(figures.at("diffuse")));
  for (const auto& [name, value] : figures.at("probes").items()) {
    text += line("probe", fmt::format("{}: {:.6g}", name, value.get<double>()));
  }
  const json& bodies = figures.at("bodies");
  if (!bodies.empty()) text += line("bodies", body_line(bodies));
  text += line("state", text_of(figures, "state_hash"));
  for (const json& cloth : figures.at("cloths")) text += line("cloth", cloth_line(cloth));
  for (const json& rope : figures.at("ropes")) text += line("rope", rope_line(rope));
  for (const json& check : figures.at("checks")) text += line("check", check_line(check));
  text += line("files", folder.string() + ": " + file_list(formats, figures, pictures, surfaces));
  return text + fmt::format("The picture to open: {}\n", (folder / "preview.png").string());
}

}  // namespace meniscus::cli
