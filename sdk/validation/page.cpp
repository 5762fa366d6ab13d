// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The page on all cases that were run: Markdown, with a drawing for each plot, and JSON.
#include "sdk/validation/page.h"

#include <meniscus/error.h>
#include <meniscus/version.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "sdk/files/output_file.h"
#include "sdk/validation/chart.h"

namespace meniscus::validation {
namespace {

using json = nlohmann::ordered_json;
namespace fs = std::filesystem;

void write_file(const fs::path& path, const std::string& text) {
  io::OutputFile file(path);
  file.write(text);
  file.commit();
}

std::string picture_name(const Record& record, std::size_t plot) {
  return record.of.name + (plot > 0 ? "-" + std::to_string(plot + 1) : "") + ".svg";
}

json json_of(double value) {
  return std::isfinite(value) ? json(value) : json();
}

json json_of(const Curve& curve) {
  return {{"name", curve.name}, {"points", curve.points}, {"x", curve.x}, {"y", curve.y}};
}

json json_of(const Gate& gate) {
  return {{"name", gate.name},    {"unit", gate.unit}, {"value", json_of(gate.value)},
          {"low", gate.low},      {"high", gate.high}, {"hard", gate.bar == Bar::hard},
          {"holds", gate.holds()}};
}

json json_of(const Record& record) {
  json all{{"name", record.of.name}, {"seconds", record.seconds}, {"passes", record.passes()}};
  if (!record.failure.empty()) all["failure"] = record.failure;
  all["gates"] = all["figures"] = all["plots"] = json::array();
  for (const Gate& gate : record.result.gates) all["gates"].push_back(json_of(gate));
  for (const Figure& f : record.result.figures)
    all["figures"].push_back({{"name", f.name}, {"unit", f.unit}, {"value", json_of(f.value)}});
  for (const Plot& plot : record.result.plots) {
    json curves = json::array();
    for (const Curve& curve : plot.curves) curves.push_back(json_of(curve));
    all["plots"].push_back(
        {{"title", plot.title}, {"x", plot.x_label}, {"y", plot.y_label}, {"curves", curves}});
  }
  return all;
}

std::string row(const Gate& gate) {
  return fmt::format("| {} | {} | {} | {} | {} |\n", gate.name, printed(gate.value, gate.unit),
                     interval_of(gate), gate.bar == Bar::hard ? "gate" : "target", verdict_of(gate));
}

/// What is missed, each with its reason; empty if nothing is.
std::string misses_of(const Record& record) {
  std::string text;
  if (!record.failure.empty())
    text += fmt::format("- {}: the run failed. {}\n", record.of.title, record.failure);
  std::string last;  // a figure may have a gate and a closer target: the wider one is told
  for (const Gate& gate : record.result.gates) {
    if (gate.holds() || gate.name == last) continue;
    last = gate.name;
    text += fmt::format("- {}: {} is {}, not {}. {}\n", record.of.title, gate.name,
                        printed(gate.value, gate.unit), interval_of(gate),
                        gate.reason.empty() ? "The reason is not known." : gate.reason);
  }
  return text;
}

std::string summary_of(const std::vector<Record>& records) {
  std::string good, bad;
  for (const Record& record : records) {
    const std::string misses = misses_of(record);
    bad += misses;
    if (misses.empty()) good += fmt::format("- [{}](#{})\n", record.of.title, record.of.name);
  }
  return "## Where it is accurate\n\nThese cases are within all their gates and targets:\n\n" +
         (good.empty() ? "- none\n" : good) + "\n## Where it is not\n\n" +
         (bad.empty() ? "- Nothing is missed.\n" : bad) + "\n";
}

std::string section_of(const Record& record, const std::string& folder) {
  std::string text = fmt::format("## {}\n\n<a id=\"{}\"></a>{}\n\nReference: {}\n\n", record.of.title,
                                 record.of.name, record.of.set_up, record.of.reference);
  for (std::size_t k = 0; k < record.result.plots.size(); ++k)
    text += fmt::format("![{}]({}/{})\n\n", record.result.plots[k].title, folder, picture_name(record, k));
  if (!record.failure.empty()) return text + fmt::format("The run failed: {}\n\n", record.failure);
  text += "| figure | value | interval | kind | verdict |\n|---|---|---|---|---|\n";
  for (const Gate& gate : record.result.gates) text += row(gate);
  for (const Figure& f : record.result.figures)
    text += fmt::format("| {} | {} | | | |\n", f.name, printed(f.value, f.unit));
  return text + fmt::format("\n`meniscus validate {}` took {:.0f} s.\n\n", record.of.name, record.seconds);
}

std::string markdown_of(const PageHead& head, const std::vector<Record>& records, const std::string& folder) {
  std::string text = fmt::format(
      "# Accuracy\n\n"
      "`meniscus validate --resolution {} --page FILE` wrote this page, with Meniscus {}{}, on {}.\n"
      "It compares scenes with theory and experiment. Each figure has an interval. A *gate* is held by the\n"
      "present code, and missing it is a failure. A *target* is what a case aims at.\n"
      "Parameters are the defaults unless a set-up says otherwise. No parameter is fitted to a "
      "reference.\n\n",
      head.resolution, MENISCUS_VERSION_STRING, head.commit.empty() ? "" : " at `" + head.commit + "`",
      head.device);
  text += summary_of(records);
  if (!head.missing.empty()) text += "## What is missing\n\n";
  for (const std::string& what : head.missing) text += "- " + what + "\n";
  if (!head.missing.empty()) text += "\n";
  for (const Record& record : records) text += section_of(record, folder);
  text.pop_back();  // one of two ends of lines
  return text;
}

}  // namespace

bool Record::passes() const {
  return failure.empty() && std::none_of(result.gates.begin(), result.gates.end(), [](const Gate& gate) {
           return gate.bar == Bar::hard && !gate.holds();
         });
}

const char* verdict_of(const Gate& gate) {
  if (gate.holds()) return "held";
  return gate.bar == Bar::hard ? "MISSED" : "missed";
}

std::string printed(double value, const std::string& unit) {
  return fmt::format("{:.4g}{}{}", value, unit.empty() ? "" : " ", unit);
}

std::string interval_of(const Gate& gate) {
  if (gate.low == 0) return "≤ " + printed(gate.high, gate.unit);
  if (gate.low == -gate.high) return "± " + printed(gate.high, gate.unit);
  return fmt::format("{:.4g} to {}", gate.low, printed(gate.high, gate.unit));
}

void write_page(const fs::path& page, const PageHead& head, const std::vector<Record>& records) {
  const fs::path folder = page.parent_path() / page.stem();
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw Error(ErrorCode::io, "cannot make the folder " + folder.string() + ": " + error.message());
  json figures{{"version", MENISCUS_VERSION_STRING},
               {"commit", head.commit},
               {"device", head.device},
               {"resolution", head.resolution},
               {"cases", json::array()}};
  for (const Record& record : records) {
    figures["cases"].push_back(json_of(record));
    for (std::size_t k = 0; k < record.result.plots.size(); ++k)
      write_file(folder / picture_name(record, k), drawing_of(record.result.plots[k]));
  }
  write_file(folder / "figures.json", figures.dump(1) + "\n");
  write_file(page, markdown_of(head, records, page.stem().string()));
}

}  // namespace meniscus::validation
