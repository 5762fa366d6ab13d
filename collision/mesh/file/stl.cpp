// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads STL files, binary and ASCII.
#include "collision/mesh/file/stl.h"

#include <algorithm>
#include <cctype>
#include <cstring>

#include "collision/mesh/file/defect.h"

namespace meniscus::collision {

namespace {

constexpr size_t title_size = 80, count_size = 4, triangle_size = 50;

void add_triangle(Polygons& all) {
  const auto first = static_cast<uint32_t>(all.vertices.size()) - 3;
  for (uint32_t i = 0; i < 3; ++i) all.corners.push_back(first + i);
  all.ends.push_back(first + 3);
}

uint64_t promised_triangles(std::string_view bytes) {
  uint32_t count = 0;
  if (bytes.size() >= title_size + count_size) std::memcpy(&count, bytes.data() + title_size, count_size);
  return count;
}

bool is_binary(std::string_view bytes) {
  return bytes.size() >= title_size + count_size &&
         bytes.size() == title_size + count_size + triangle_size * promised_triangles(bytes);
}

Polygons read_binary(std::string_view bytes) {
  Polygons all;
  const uint64_t count = promised_triangles(bytes);
  for (uint64_t t = 0; t < count; ++t) {
    const char* triangle = bytes.data() + title_size + count_size + t * triangle_size;
    float numbers[12];  // a normal, and three corners
    std::memcpy(numbers, triangle, sizeof numbers);
    for (int corner = 1; corner < 4; ++corner)
      all.vertices.push_back({numbers[3 * corner], numbers[3 * corner + 1], numbers[3 * corner + 2]});
    add_triangle(all);
  }
  return all;
}

bool is_word(std::string_view word, std::string_view expected) {
  return std::equal(word.begin(), word.end(), expected.begin(), expected.end(),
                    [](unsigned char a, char b) { return std::tolower(a) == b; });
}

/// Reads ASCII files: solids of facets, each with one loop of three vertices.
class AsciiReader {
 public:
  explicit AsciiReader(std::string_view text) : words_(text) {}

  Polygons read() {
    for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) {
      if (!is_word(word, "solid")) throw FileDefect("has " + in_quotes(word) + " where a solid should begin");
      read_solid();
    }
    return std::move(all_);
  }

 private:
  void read_solid() {
    words_.line();  // its name
    for (;;) {
      const std::string_view word = words_.next();
      if (is_word(word, "endsolid")) break;
      if (!is_word(word, "facet")) refuse(word, "'facet' or 'endsolid'");
      read_facet();
    }
    words_.line();
  }

  void read_facet() {
    expect("normal");
    read_vector();
    expect("outer");
    expect("loop");
    for (int i = 0; i < 3; ++i) {
      expect("vertex");
      all_.vertices.push_back(read_vector());
    }
    add_triangle(all_);
    expect("endloop");
    expect("endfacet");
  }

  Vec3 read_vector() {
    float numbers[3];
    for (float& number : numbers) {
      const std::string_view word = words_.next();
      const auto value = number_of<float>(word);
      if (!value) refuse(word, "a number");
      number = *value;
    }
    return {numbers[0], numbers[1], numbers[2]};
  }

  void expect(std::string_view expected) {
    const std::string_view word = words_.next();
    if (!is_word(word, expected)) refuse(word, in_quotes(expected));
  }

  [[noreturn]] void refuse(std::string_view word, const std::string& expected) const {
    const std::string facet = " in facet " + std::to_string(all_.ends.size());
    if (word.empty()) throw FileDefect("ends" + facet + ", where " + expected + " should come");
    throw FileDefect("has " + in_quotes(word) + facet + ", where " + expected + " should come");
  }

  Words words_;
  Polygons all_;
};

}  // namespace

Polygons read_stl(std::string_view bytes) {
  if (is_binary(bytes)) return read_binary(bytes);
  Words words(bytes);
  if (is_word(words.next(), "solid")) return AsciiReader(bytes).read();
  throw FileDefect("is neither ASCII STL nor binary STL: it promises " +
                   std::to_string(promised_triangles(bytes)) + " triangles, which need " +
                   std::to_string(title_size + count_size + triangle_size * promised_triangles(bytes)) +
                   " bytes, and has " + std::to_string(bytes.size()));
}

}  // namespace meniscus::collision
