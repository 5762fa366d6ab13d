// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Evaluates the operations of prims (UsdGeomXformOp) at their samples.
#include "sdk/motion/usda_transform.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <string_view>

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

/// An operation in the order of a prim.
struct Link {
  const UsdaLayer& layer;
  int prim;
  std::string name, kind;
  const UsdaOp* op;
  bool inverts;
};

/// What a message shows of a name or a path, which may be as long as the file.
std::string shown(std::string text) {
  constexpr size_t most = 200;
  if (text.size() > most) text.replace(most, std::string::npos, "...");
  return text;
}

[[noreturn]] void refuse(const Link& link, const std::string& why) {
  throw FileDefect("cannot be followed: " + shown(link.name) + " of " + shown(link.layer.path_of(link.prim)) +
                   " " + why);
}

/// USD writes a matrix in rows, for vectors from the left.
Placed placed_by(const Link& link, const Numbers& m) {
  Placed placed = Placed::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      placed.linear()(row, column) = m[static_cast<size_t>(4 * column + row)];
    placed.translation()(row) = m[static_cast<size_t>(12 + row)];
  }
  const Eigen::Matrix3d off = placed.linear().transpose() * placed.linear() - Eigen::Matrix3d::Identity();
  if (!(off.cwiseAbs().maxCoeff() < tuning::scale_tolerance) || placed.linear().determinant() < 0)
    refuse(link, "scales, shears or mirrors; a body is rigid");
  return placed;
}

Eigen::Quaterniond turn_about(char axis, double degrees) {
  const Eigen::Vector3d along = Eigen::Vector3d::Unit(axis - 'X');
  return Eigen::Quaterniond(Eigen::AngleAxisd(radian * degrees, along));
}

Placed operation(const Link& link, const Numbers& value) {
  const std::string& kind = link.kind;
  const auto needs = [&](size_t count) {
    if (value.size() != count) refuse(link, "does not have " + std::to_string(count) + " numbers");
    for (const double x : value)
      if (!std::isfinite(x)) refuse(link, "is not finite");
  };
  Placed placed = Placed::Identity();
  if (kind == "translate") {
    needs(3);
    placed.translation() = Eigen::Vector3d(value[0], value[1], value[2]);
  } else if (kind == "scale") {
    needs(3);
    for (const double x : value)
      if (!(std::fabs(x - 1) < tuning::scale_tolerance)) refuse(link, "scales; a body is rigid");
  } else if (kind == "orient") {
    needs(4);
    const Eigen::Quaterniond turn(value[0], value[1], value[2], value[3]);  // w first
    if (!(turn.norm() > 0.1)) refuse(link, "is no rotation");
    placed.linear() = turn.normalized().toRotationMatrix();
  } else if (kind == "transform") {
    needs(16);
    placed = placed_by(link, value);
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
    refuse(link, "is not known");
  }
  return placed;
}

/// An operation at a time code. Numbers are linear between samples, and rotations turn about one axis.
/// OpenUSD is linear in the elements of matrices, which then scale.
Placed operation_at(const Link& link, double code) {
  const Samples samples = samples_at(*link.op, code);
  if (link.kind != "orient" && link.kind != "transform") return operation(link, linear(samples));
  const Placed before = operation(link, samples.before), after = operation(link, samples.after);
  Placed between = Placed::Identity();
  between.linear() = Eigen::Quaterniond(before.linear())
                         .slerp(samples.fraction, Eigen::Quaterniond(after.linear()))
                         .toRotationMatrix();
  between.translation() =
      before.translation() + samples.fraction * (after.translation() - before.translation());
  return between;
}

/// The operations of a prim and of all above it, the outermost first.
class Chain {
 public:
  Chain(const UsdaLayer& layer, int prim) {
    std::vector<int> prims;
    for (int n = prim; n >= 0; n = layer.prims[static_cast<size_t>(n)].parent) {
      prims.push_back(n);
      if (std::ranges::count(layer.prims[static_cast<size_t>(n)].order, reset) > 0) break;
    }
    for (auto n = prims.rbegin(); n != prims.rend(); ++n) add(layer, *n);
  }

  Placed at(double code) const {
    Placed all = Placed::Identity();
    for (const Link& link : links_) {
      const Placed one = operation_at(link, code);
      all = all * (link.inverts ? one.inverse() : one);
    }
    return all;
  }

  /// All time codes with a sample, and more where an operation turns far.
  std::vector<double> codes() const {
    std::set<double> sampled;
    for (const Link& link : links_)
      for (const auto& [code, value] : link.op->samples) sampled.insert(code);
    std::vector<double> codes(sampled.begin(), sampled.end());
    expect_few(static_cast<double>(codes.size()));
    for (auto next = sampled.begin(); next != sampled.end();) {
      const double from = *next++;
      if (next == sampled.end()) break;
      const double parts = std::ceil(turn(from, *next) / tuning::most_turn);
      expect_few(static_cast<double>(codes.size()) + parts);
      for (double k = 1; k < parts; ++k) codes.push_back(from + k / parts * (*next - from));
    }
    std::ranges::sort(codes);
    return codes;
  }

 private:
  void add(const UsdaLayer& layer, int prim) {
    const UsdaPrim& owner = layer.prims[static_cast<size_t>(prim)];
    for (const std::string& entry : owner.order) {
      if (entry == reset) continue;
      const bool inverts = entry.starts_with(inverted);
      const std::string name = inverts ? entry.substr(inverted.size()) : entry;
      const auto op = owner.ops.find(name);
      const bool is_there = op != owner.ops.end() && (op->second.fixed || !op->second.samples.empty());
      // A name that is too short for a kind has no value.
      links_.push_back(
          {layer, prim, name, is_there ? kind_of(name) : "", is_there ? &op->second : nullptr, inverts});
      if (!is_there) refuse(links_.back(), "has no value");
      if (links_.size() > most_operations)
        refuse(links_.back(), "is one too many: the prim and those above it have more than " +
                                  std::to_string(most_operations) + " operations");
    }
  }

  /// Degrees, the most by which an operation of angles turns. Of what is not finite the operation tells.
  double turn(double from, double to) const {
    double most = 0;
    for (const Link& link : links_) {
      if (!link.kind.starts_with("rotate")) continue;
      const Numbers before = linear(samples_at(*link.op, from)), after = linear(samples_at(*link.op, to));
      for (size_t k = 0; k < std::min(before.size(), after.size()); ++k) {
        const double turned = std::fabs(after[k] - before[k]);
        if (std::isfinite(turned)) most = std::max(most, turned);
      }
    }
    return most;
  }

  static void expect_few(double keyframes) {
    if (keyframes > most_keyframes)
      throw FileDefect("takes more than " + std::to_string(most_keyframes) +
                       " keyframes: one a time code with samples, and one each " +
                       std::to_string(static_cast<int>(tuning::most_turn)) +
                       " degrees that an operation turns");
  }

  static constexpr size_t most_operations = 1024;
  static constexpr int most_keyframes = 1'000'000;

  std::vector<Link> links_;
};

/// The first prim with this path; none without one.
std::optional<int> with_path(const UsdaLayer& layer, std::string_view path) {
  std::vector<size_t> ends;  // of each prim's path in `path`, if that begins with it
  for (const UsdaPrim& prim : layer.prims) {
    const size_t at = prim.parent < 0 ? 0 : ends[static_cast<size_t>(prim.parent)];
    const bool fits = at < path.size() && path[at] == '/' && path.substr(at + 1).starts_with(prim.name);
    ends.push_back(fits ? at + 1 + prim.name.size() : std::string_view::npos);
    if (ends.back() == path.size()) return static_cast<int>(ends.size()) - 1;
  }
  return std::nullopt;
}

int find_prim(const UsdaLayer& layer, const std::string& path) {
  if (const std::optional<int> found = with_path(layer, path)) return *found;
  std::vector<int> moving;
  for (size_t n = 0; n < layer.prims.size(); ++n)
    if (layer.prims[n].moves()) moving.push_back(static_cast<int>(n));
  if (path.empty() && moving.size() == 1) return moving.front();
  constexpr size_t most_names = 8;
  std::string names;
  for (size_t k = 0; k < std::min(moving.size(), most_names); ++k)
    names += (k == 0 ? "" : ", ") + shown(layer.path_of(moving[k]));
  if (moving.size() > most_names) names += " and " + std::to_string(moving.size() - most_names) + " more";
  const std::string those = names.empty() ? "none has time samples" : "with time samples: " + names;
  throw FileDefect(path.empty() ? "has more than one prim that moves, or none: " + those
                                : "has no prim '" + shown(path) + "': " + those);
}

}  // namespace

std::vector<Keyframe> poses_of(const UsdaLayer& layer, const std::string& path) {
  const int prim = find_prim(layer, path);
  const Chain chain(layer, prim);
  std::vector<Keyframe> keyframes;
  for (const double code : chain.codes()) {
    const Placed at = chain.at(code);
    const Eigen::Vector3f x = (layer.metres_per_unit * at.translation()).cast<float>();
    const Eigen::Quaternionf q = Eigen::Quaterniond(at.linear()).normalized().cast<float>();
    keyframes.push_back({static_cast<float>(code / layer.time_codes_per_second),
                         {{x.x(), x.y(), x.z()}, {q.x(), q.y(), q.z(), q.w()}}});
  }
  if (keyframes.empty()) throw FileDefect("has no time samples of '" + shown(layer.path_of(prim)) + "'");
  return keyframes;
}

}  // namespace meniscus::motion
