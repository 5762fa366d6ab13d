// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A case of validation: a set-up, a reference with its source, and what a run of it gives.
#pragma once

#include <meniscus/defs.h>

#include <functional>
#include <string>
#include <vector>

namespace meniscus::validation {

/// How many particles a case takes.
enum class Resolution {
  quick,   ///< seconds on a CPU
  medium,  ///< minutes on a CPU
  full,    ///< for a GPU
};

struct Settings {
  DeviceChoice device = DeviceChoice::automatic;
  int threads = 0;  ///< of the CPU device; 0: one for each core
  Resolution resolution = Resolution::quick;

  WorldDef world(float spacing) const;
  /// The value for the resolution.
  template <class T>
  T choose(const T& quick, const T& medium, const T& full) const {
    return resolution == Resolution::quick ? quick : resolution == Resolution::medium ? medium : full;
  }
};

struct Curve {
  std::string name;
  std::vector<double> x{}, y{};  ///< x ascends
  bool points = false;           ///< single readings, as those of an experiment

  void add(double at, double value) {
    x.push_back(at);
    y.push_back(value);
  }
};

struct Plot {
  std::string title, x_label, y_label;
  std::vector<Curve> curves;
};

enum class Bar {
  hard,    ///< the present code is within it: outside of it is a failure
  target,  ///< what the case aims at
};

/// A figure, with the interval that it is to be in.
struct Gate {
  std::string name, unit;
  double value = 0, low = 0, high = 0;
  Bar bar = Bar::target;
  /// Why the figure is outside, as far as that is known. Only then it is told.
  std::string reason{};

  bool holds() const { return value >= low && value <= high; }  // false for NaN
};

/// A figure that is told, but not judged.
struct Figure {
  std::string name, unit;
  double value = 0;
};

struct Result {
  std::vector<Plot> plots{};
  std::vector<Gate> gates{};
  std::vector<Figure> figures{};

  /// Appends the gate 0 ≤ value ≤ most.
  void at_most(std::string name, std::string unit, double value, double most, Bar bar,
               std::string reason = {});
  /// Appends the gate |deviation| ≤ most.
  void about_zero(std::string name, std::string unit, double deviation, double most, Bar bar,
                  std::string reason = {});
  void within(std::string name, std::string unit, double value, double low, double high, Bar bar,
              std::string reason = {});
  void tell(std::string name, std::string unit, double value);
};

struct Case {
  std::string name, title;
  std::string set_up, reference;  ///< whole sentences; the reference with its source
  std::function<Result(const Settings&)> run;
};

}  // namespace meniscus::validation
