// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Evaluates the operations of prims (UsdGeomXformOp) at their samples.
#include "sdk/motion/usda_transform.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "collision/mesh/file/defect.h"
#include "sdk/motion/tuning.h"

namespace meniscus::motion {

namespace {

using collision::FileDefect;
using Placed = Eigen::Isometry3d;
using Numbers = std::vector<double>;

constexpr double radian = std::numbers::pi / 180;
constexpr std::string_view inverted = "!invert!", reset = "!resetXformStack!";

/// `rotateXYZ` of `xformOp:rotateXYZ:pivot`.
std::string kind_of(const std::string& name) {
  const size_t begin = std::string_view("xformOp:").size();
  return name.substr(begin, name.find(':', begin) - begin);
}

/// The samples around a time code, and how far it is from the first to the second.
struct Samples {
  const Numbers &before, &after;
  double fraction;
};

Samples samples_at(const UsdaOp& op, double code) {
  if (op.samples.empty()) return {*op.fixed, *op.fixed, 0};
  const auto next = op.samples.lower_bound(code);
  if (next == op.samples.end()) return {op.samples.rbegin()->second, op.samples.rbegin()->second, 0};
  if (next == op.samples.begin() || next->first == code) return {next->second, next->second, 0};
  const auto before = std::prev(next);
  return {before->second, next->second, (code - before->first) / (next->first - before->first)};
}

Numbers linear(const Samples& samples) {
  if (samples.before.size() != samples.after.size())
    throw FileDefect("has samples of different sizes in one operation");
  Numbers value = samples.before;
  for (size_t k = 0; k < value.size(); ++k) value[k] += samples.fraction * (samples.after[k] - value[k]);
  return value;
}

[[noreturn]] void refuse(const std::string& path, const std::string& name, const std::string& why) {
  throw FileDefect("cannot be followed: " + name + " of " + path + " " + why);
}

/// USD writes a matrix in rows, for vectors from the left.
Placed placed_by(const std::string& path, const std::string& name, const Numbers& m) {
  Placed placed = Placed::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      placed.linear()(row, column) = m[static_cast<size_t>(4 * column + row)];
    placed.translation()(row) = m[static_cast<size_t>(12 + row)];
  }
  const Eigen::Matrix3d off = placed.linear().transpose() * placed.linear() - Eigen::Matrix3d::Identity();
  if (!(off.cwiseAbs().maxCoeff() < tuning::scale_tolerance) || placed.linear().determinant() < 0)
    refuse(path, name, "scales, shears or mirrors; a body is rigid");
  return placed;
}

Eigen::Quaterniond turn_about(char axis, double degrees) {
  const Eigen::Vector3d along = Eigen::Vector3d::Unit(axis - 'X');
  return Eigen::Quaterniond(Eigen::AngleAxisd(radian * degrees, along));
}

Placed operation(const std::string& path, const std::string& name, const Numbers& value) {
  const std::string kind = kind_of(name);
  const auto needs = [&](size_t count) {
    if (value.size() != count) refuse(path, name, "does not have " + std::to_string(count) + " numbers");
    for (const double x : value)
      if (!std::isfinite(x)) refuse(path, name, "is not finite");
  };
  Placed placed = Placed::Identity();
  if (kind == "translate") {
    needs(3);
    placed.translation() = Eigen::Vector3d(value[0], value[1], value[2]);
  } else if (kind == "scale") {
    needs(3);
    for (const double x : value)
      if (!(std::fabs(x - 1) < tuning::scale_tolerance)) refuse(path, name, "scales; a body is rigid");
  } else if (kind == "orient") {
    needs(4);
    const Eigen::Quaterniond turn(value[0], value[1], value[2], value[3]);  // w first
    if (!(turn.norm() > 0.1)) refuse(path, name, "is no rotation");
    placed.linear() = turn.normalized().toRotationMatrix();
  } else if (kind == "transform") {
    needs(16);
    placed = placed_by(path, name, value);
  } else if (kind.starts_with("rotate") && (kind.size() == 7 || kind.size() == 9) &&
             kind.find_first_not_of("XYZ", 6) == std::string::npos) {
    needs(kind.size() - 6);
    // rotateXYZ turns about x first.
    for (size_t k = 0; k < value.size(); ++k) {
      const char axis = kind[6 + k];
      const double degrees = value[value.size() == 1 ? 0 : static_cast<size_t>(axis - 'X')];
      placed.linear() = turn_about(axis, degrees).toRotationMatrix() * placed.linear();
    }
  } else {
    refuse(path, name, "is not known");
  }
  return placed;
}

/// An operation at a time code. Numbers are linear between samples, and rotations turn about one axis.
/// OpenUSD is linear in the elements of matrices, which then scale.
Placed operation_at(const std::string& path, const std::string& name, const UsdaOp& op, double code) {
  const Samples samples = samples_at(op, code);
  const std::string kind = kind_of(name);
  if (kind != "orient" && kind != "transform") return operation(path, name, linear(samples));
  const Placed before = operation(path, name, samples.before), after = operation(path, name, samples.after);
  Placed between = Placed::Identity();
  between.linear() = Eigen::Quaterniond(before.linear())
                         .slerp(samples.fraction, Eigen::Quaterniond(after.linear()))
                         .toRotationMatrix();
  between.translation() =
      before.translation() + samples.fraction * (after.translation() - before.translation());
  return between;
}

/// A prim and all above it, the outermost first.
class Chain {
 public:
  Chain(const UsdaLayer& layer, size_t prim) {
    for (int n = static_cast<int>(prim); n >= 0; n = layer.prims[static_cast<size_t>(n)].parent) {
      const UsdaPrim& link = layer.prims[static_cast<size_t>(n)];
      links_.insert(links_.begin(), &link);
      if (std::ranges::find(link.order, reset) != link.order.end()) break;
    }
    for_each_op([](const UsdaPrim& link, const std::string& name, const UsdaOp& op, bool) {
      if (!op.fixed && op.samples.empty()) refuse(link.path, name, "has no value");
    });
  }

  Placed at(double code) const {
    Placed all = Placed::Identity();
    for_each_op([&](const UsdaPrim& link, const std::string& name, const UsdaOp& op, bool inverts) {
      const Placed one = operation_at(link.path, name, op, code);
      all = all * (inverts ? one.inverse() : one);
    });
    return all;
  }

  /// All time codes with a sample, and more where an operation turns far.
  std::vector<double> codes() const {
    std::set<double> sampled;
    for_each_op([&](const UsdaPrim&, const std::string&, const UsdaOp& op, bool) {
      for (const auto& [code, value] : op.samples) sampled.insert(code);
    });
    std::vector<double> codes(sampled.begin(), sampled.end());
    for (auto next = sampled.begin(); next != sampled.end();) {
      const double from = *next++;
      if (next == sampled.end()) break;
      const double parts = std::ceil(turn(from, *next) / tuning::most_turn);
      for (double k = 1; k < parts; ++k) codes.push_back(from + k / parts * (*next - from));
    }
    std::ranges::sort(codes);
    return codes;
  }

 private:
  template <class Use>
  void for_each_op(const Use& use) const {
    for (const UsdaPrim* link : links_) {
      for (const std::string& entry : link->order) {
        if (entry == reset) continue;
        const bool inverts = entry.starts_with(inverted);
        const std::string name = inverts ? entry.substr(inverted.size()) : entry;
        const auto op = link->ops.find(name);
        if (op == link->ops.end()) refuse(link->path, name, "has no value");
        use(*link, name, op->second, inverts);
      }
    }
  }

  /// Degrees, the most by which an operation of angles turns.
  double turn(double from, double to) const {
    double most = 0;
    for_each_op([&](const UsdaPrim&, const std::string& name, const UsdaOp& op, bool) {
      if (!kind_of(name).starts_with("rotate")) return;
      const Numbers before = linear(samples_at(op, from)), after = linear(samples_at(op, to));
      for (size_t k = 0; k < std::min(before.size(), after.size()); ++k)
        most = std::max(most, std::fabs(after[k] - before[k]));
    });
    constexpr double most_known = 1e6;  // of what is not finite the operation tells
    return most < most_known ? most : 0;
  }

  std::vector<const UsdaPrim*> links_;
};

size_t find_prim(const UsdaLayer& layer, const std::string& path) {
  std::vector<size_t> moving;
  std::string names;
  for (size_t n = 0; n < layer.prims.size(); ++n) {
    if (layer.prims[n].path == path) return n;
    if (!layer.prims[n].moves()) continue;
    moving.push_back(n);
    names += (names.empty() ? "" : ", ") + layer.prims[n].path;
  }
  if (path.empty() && moving.size() == 1) return moving.front();
  const std::string those = names.empty() ? "none has time samples" : "with time samples: " + names;
  throw FileDefect(path.empty() ? "has more than one prim that moves, or none: " + those
                                : "has no prim '" + path + "': " + those);
}

}  // namespace

std::vector<Keyframe> poses_of(const UsdaLayer& layer, const std::string& path) {
  const size_t prim = find_prim(layer, path);
  const Chain chain(layer, prim);
  std::vector<Keyframe> keyframes;
  for (const double code : chain.codes()) {
    const Placed at = chain.at(code);
    const Eigen::Vector3f x = (layer.metres_per_unit * at.translation()).cast<float>();
    const Eigen::Quaternionf q = Eigen::Quaterniond(at.linear()).normalized().cast<float>();
    keyframes.push_back({static_cast<float>(code / layer.time_codes_per_second),
                         {{x.x(), x.y(), x.z()}, {q.x(), q.y(), q.z(), q.w()}}});
  }
  if (keyframes.empty()) throw FileDefect("has no time samples of '" + layer.prims[prim].path + "'");
  return keyframes;
}

}  // namespace meniscus::motion
