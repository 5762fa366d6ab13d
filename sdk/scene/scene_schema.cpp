// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Writes the JSON Schema of scene files by the fields of scene_fields.h. Defaults are those of the structs.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "sdk/fields/visitor.h"
#include "sdk/scene/scene_fields.h"
#include "sdk/scene/scene_file.h"

namespace meniscus {
namespace {

using OrderedJson = nlohmann::ordered_json;

template <class T>
OrderedJson schema_of(T& value, const FieldRule& rule);

/// A number as a person would write it: 4 for 4.0, and 0.05 for the float nearest to it.
OrderedJson plain_number(double x) {
  if (x == std::floor(x) && std::fabs(x) < 1e15) return int64_t(x);
  return x;
}
OrderedJson plain_number(float x) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, x).ptr;
  return plain_number(std::strtod(std::string(text, end).c_str(), nullptr));
}

OrderedJson number_schema(const char* type, const FieldRule& rule) {
  OrderedJson schema{{"type", type}};
  if (std::isfinite(rule.low))
    schema[rule.above_low ? "exclusiveMinimum" : "minimum"] = plain_number(rule.low);
  if (std::isfinite(rule.high))
    schema[rule.below_high ? "exclusiveMaximum" : "maximum"] = plain_number(rule.high);
  return schema;
}

OrderedJson array_schema(const FieldRule& rule, int count) {
  return {
      {"type", "array"}, {"items", number_schema("number", rule)}, {"minItems", count}, {"maxItems", count}};
}

/// Whole numbers have bounds where the rule has none: those of their type.
template <class T>
OrderedJson whole_schema(FieldRule rule) {
  rule.low = std::max<double>(rule.low, std::numeric_limits<T>::min());
  rule.high = std::min<double>(rule.high, std::numeric_limits<T>::max());
  return number_schema("integer", rule);
}

OrderedJson plain_schema(float, const FieldRule& rule) {
  return number_schema("number", rule);
}
OrderedJson plain_schema(int, const FieldRule& rule) {
  return whole_schema<int>(rule);
}
OrderedJson plain_schema(uint32_t, const FieldRule& rule) {
  return whole_schema<uint32_t>(rule);
}
OrderedJson plain_schema(bool, const FieldRule&) {
  return {{"type", "boolean"}};
}
OrderedJson plain_schema(Vec3, const FieldRule& rule) {
  return array_schema(rule, 3);
}
OrderedJson plain_schema(const std::string&, const FieldRule& rule) {
  OrderedJson schema{{"type", "string"}};
  if (rule.min_items > 0) schema["minLength"] = rule.min_items;
  return schema;
}
OrderedJson plain_schema(Quat, const FieldRule& rule) {
  AxisAngle turn;
  OrderedJson ways = OrderedJson::array();
  ways.push_back(schema_of(turn, any_value));
  ways.push_back(array_schema(rule, 4));
  return {{"oneOf", ways}};
}

/// JSON has no infinity, and null says that there is no default.
OrderedJson default_of(float x) {
  return std::isfinite(x) ? plain_number(x) : OrderedJson(nullptr);
}
OrderedJson default_of(int x) {
  return x;
}
OrderedJson default_of(uint32_t x) {
  return x;
}
OrderedJson default_of(bool x) {
  return x;
}
OrderedJson default_of(const std::string& x) {
  return x;
}
OrderedJson default_of(Vec3 x) {
  return OrderedJson::array({plain_number(x.x), plain_number(x.y), plain_number(x.z)});
}
OrderedJson default_of(Quat x) {
  return OrderedJson::array({plain_number(x.x), plain_number(x.y), plain_number(x.z), plain_number(x.w)});
}
template <HasNames E>
OrderedJson default_of(E x) {
  for (const Named<E>& named : names_of(x)) {
    if (named.value == x) return named.name;
  }
  return nullptr;
}

class SchemaWriter {
 public:
  template <class T>
  void operator()(const char* key, T& value, const FieldRule& rule, const char* unit, const char* text) {
    OrderedJson schema{{"description", *unit ? std::string(text) + " (" + unit + ")" : text}};
    if (*unit) schema["unit"] = unit;
    schema.update(schema_of(value, rule));
    if constexpr (requires { default_of(value); }) {
      if (const OrderedJson usual = default_of(value); !rule.needed && !usual.is_null())
        schema["default"] = usual;
    }
    if (rule.needed) required_.push_back(key);
    properties_[key] = std::move(schema);
  }
  template <class... Subject>
  void check(bool, const std::string&, const Subject&...) const {}

  /// The key that tells the alternatives apart.
  void add_type(const char* name) {
    properties_["type"] = {{"const", name}};
    required_.push_back("type");
  }

  OrderedJson result() const {
    OrderedJson schema{{"type", "object"}, {"properties", properties_}};
    if (!required_.empty()) schema["required"] = required_;
    schema["additionalProperties"] = false;
    return schema;
  }

 private:
  OrderedJson properties_ = OrderedJson::object();
  OrderedJson required_ = OrderedJson::array();
};

struct ChoiceSchemaWriter {
  OrderedJson alternatives = OrderedJson::array();

  template <class T, class Whole>
  void choice(const char* name, T value, Whole&, const char* text) {
    SchemaWriter writer;
    writer.add_type(name);
    fields(writer, value);
    OrderedJson schema{{"description", text}};
    schema.update(writer.result());
    alternatives.push_back(std::move(schema));
  }
};

template <class E>
OrderedJson names_schema(E value) {
  OrderedJson names = OrderedJson::array();
  for (const Named<E>& named : names_of(value)) names.push_back(named.name);
  return {{"enum", names}};
}

template <class T>
OrderedJson list_schema(const std::vector<T>&, const FieldRule& rule) {
  OrderedJson schema{{"type", "array"}};
  if (rule.min_items > 0) schema["minItems"] = rule.min_items;
  if (rule.max_items < any_value.max_items) schema["maxItems"] = rule.max_items;
  T item{};
  schema["items"] = schema_of(item, of_item(rule));
  return schema;
}

template <class T>
OrderedJson optional_schema(const std::optional<T>&, const FieldRule& rule) {
  T inner{};
  return schema_of(inner, rule);
}

template <class T>
OrderedJson schema_of(T& value, const FieldRule& rule) {
  if constexpr (IsOptional<T>::value) {
    return optional_schema(value, rule);
  } else if constexpr (IsList<T>::value) {
    return list_schema(value, rule);
  } else if constexpr (HasNames<T>) {
    return names_schema(value);
  } else if constexpr (HasChoices<T>) {
    ChoiceSchemaWriter writer;
    choices(writer, value);
    return {{"oneOf", writer.alternatives}};
  } else if constexpr (HasFields<T>) {
    SchemaWriter writer;
    fields(writer, value);
    return writer.result();
  } else {
    return plain_schema(value, rule);
  }
}

}  // namespace

std::string scene_schema() {
  Scene scene;
  OrderedJson schema{
      {"$schema", "https://json-schema.org/draft/2020-12/schema"},
      {"title", "Meniscus scene"},
      {"description",
       "A scene file of Meniscus; quantities are in SI units. `meniscus schema` writes this."}};
  schema.update(schema_of(scene, any_value));
  return schema.dump(2) + "\n";
}

}  // namespace meniscus
