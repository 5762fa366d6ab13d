// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads the transforms of prims from OpenUSD files in text form.
#include "sdk/motion/usda.h"

#include <algorithm>
#include <limits>

#include "collision/mesh/file/defect.h"
#include "sdk/motion/usda_tokens.h"

namespace meniscus::motion {

namespace {

using collision::FileDefect;
using Kind = UsdaToken::Kind;

/// A value with all its numbers in one row, and all its texts in another.
struct Value {
  std::vector<double> numbers;
  std::vector<std::string> texts;
};

class Parser {
 public:
  explicit Parser(std::string_view text) : tokens_(text) {}

  UsdaLayer layer() {
    if (next().is('(')) read_metadata();
    while (next().kind != Kind::end) read_item(-1);
    return std::move(layer_);
  }

 private:
  const UsdaToken& next() const { return tokens_.next(); }
  UsdaToken take() { return tokens_.take(); }
  [[noreturn]] static void refuse(const UsdaToken& token) {
    throw FileDefect("is not understood at line " + std::to_string(token.line) + ": " +
                     (token.kind == Kind::end ? "it ends too early" : collision::in_quotes(token.text)));
  }
  UsdaToken expect(Kind kind) {
    if (next().kind != kind) refuse(next());
    return take();
  }
  void expect(char mark) {
    if (!next().is(mark)) refuse(next());
    take();
  }
  bool take_if(char mark) {
    if (!next().is(mark)) return false;
    take();
    return true;
  }
  static bool opens(const UsdaToken& t) { return t.is('(') || t.is('[') || t.is('{'); }
  static bool closes(const UsdaToken& t) { return t.is(')') || t.is(']') || t.is('}'); }

  /// Skips what is in brackets. Calls see(token, depth) for each token inside.
  template <class See>
  void in_brackets(const See& see) {
    int depth = 0;
    do {
      const UsdaToken token = take();
      if (token.kind == Kind::end) refuse(token);
      if (closes(token)) --depth;
      if (depth > 0) see(token, depth);
      if (opens(token)) ++depth;
    } while (depth > 0);
  }
  void skip_brackets() {
    in_brackets([](const UsdaToken&, int) {});
  }

  void read_metadata() {
    bool has_time_codes = false;
    std::string_view word;
    in_brackets([&](const UsdaToken& token, int depth) {
      if (depth > 1) return;
      if (token.kind == Kind::word) word = token.text;
      if (token.kind != Kind::number) return;
      if (word == "metersPerUnit") layer_.metres_per_unit = token.number;
      if (word == "timeCodesPerSecond") has_time_codes = true;
      if (word == "timeCodesPerSecond" || (word == "framesPerSecond" && !has_time_codes))
        layer_.time_codes_per_second = token.number;
    });
    if (!(layer_.time_codes_per_second > 0) || !(layer_.metres_per_unit > 0))
      throw FileDefect("has a timeCodesPerSecond or metersPerUnit that is not positive");
  }

  /// A prim, an attribute, or something to skip. Depth is that of the file's brackets.
  void read_item(int parent) {
    if (take_if(';')) return;
    const UsdaToken word = next();
    if (word.kind != Kind::word) refuse(word);
    if (word.text == "def" || word.text == "over" || word.text == "class") return read_prim(parent);
    if (word.text == "variantSet") {
      take(), expect(Kind::text), expect('=');
      return skip_brackets();
    }
    read_attribute(parent);
  }

  void read_prim(int parent) {
    constexpr int deepest = 256;
    take();
    if (next().kind == Kind::word) take();  // its type
    const UsdaToken name = expect(Kind::text);
    if (next().is('(')) skip_brackets();
    expect('{');
    if (++depth_ > deepest) throw FileDefect("has prims more than 256 deep");
    const auto number = static_cast<int>(layer_.prims.size());
    layer_.prims.push_back({std::string(name.text), parent});
    while (!next().is('}')) read_item(number);
    take();
    --depth_;
  }

  void read_attribute(int prim) {
    constexpr std::string_view modifiers[] = {"custom", "uniform", "varying", "config", "add",
                                              "append", "prepend", "delete",  "reorder"};
    UsdaToken type = expect(Kind::word);
    while (std::ranges::find(modifiers, type.text) != std::end(modifiers)) type = expect(Kind::word);
    if (take_if('[')) expect(']');
    std::string_view name = expect(Kind::word).text;
    const bool is_sampled = name.ends_with(".timeSamples");
    if (is_sampled) name.remove_suffix(std::string_view(".timeSamples").size());
    if (take_if('=')) read_assigned(prim, std::string(type.text), std::string(name), is_sampled);
    if (next().is('(')) skip_brackets();
  }

  void read_assigned(int prim, const std::string& type, const std::string& name, bool is_sampled) {
    const bool is_op = name.starts_with("xformOp:") && !name.ends_with(".connect");
    if (prim < 0 || !(is_op || name == "xformOpOrder")) return skip_value();
    UsdaPrim& owner = layer_.prims[static_cast<size_t>(prim)];
    if (!is_op) {
      owner.order = read_value().texts;
      return;
    }
    UsdaOp& op = owner.ops[name];
    op.type = type;
    if (!is_sampled) {
      op.fixed = read_value().numbers;
      return;
    }
    expect('{');
    while (!take_if('}')) {
      const double code = expect(Kind::number).number;
      expect(':');
      op.samples[code] = read_value().numbers;
      if (!next().is('}')) expect(',');
    }
  }

  void skip_value() {
    if (opens(next()))
      skip_brackets();
    else
      take();
  }

  Value read_value() {
    Value value;
    const auto add = [&](const UsdaToken& token) {
      if (token.kind == Kind::number) value.numbers.push_back(token.number);
      if (token.kind == Kind::text) value.texts.emplace_back(token.text);
      // nan, inf, None: no pose
      if (token.kind == Kind::word) value.numbers.push_back(std::numeric_limits<double>::quiet_NaN());
    };
    if (opens(next()))
      in_brackets([&](const UsdaToken& token, int) { add(token); });
    else
      add(take());
    return value;
  }

  UsdaTokens tokens_;
  int depth_ = 0;
  UsdaLayer layer_;
};

}  // namespace

bool UsdaPrim::moves() const {
  return std::ranges::any_of(order, [&](const std::string& entry) {
    const auto op = ops.find(entry);
    return op != ops.end() && !op->second.samples.empty();
  });
}

std::string UsdaLayer::path_of(int prim) const {
  std::vector<const std::string*> names;
  for (; prim >= 0; prim = prims[static_cast<size_t>(prim)].parent)
    names.push_back(&prims[static_cast<size_t>(prim)].name);
  std::string path;
  for (auto name = names.rbegin(); name != names.rend(); ++name) path.append("/").append(**name);
  return path;
}

UsdaLayer read_usda(std::string_view text) {
  if (!text.starts_with("#usda "))
    throw FileDefect("does not begin with '#usda', as OpenUSD in text form does");
  return Parser(text).layer();
}

}  // namespace meniscus::motion
