// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Text that changes nothing but what it says, wherever it is shown.
#include "sdk/io/plain_text.h"

#include <algorithm>
#include <cstdint>

namespace meniscus::io {
namespace {

struct Character {
  uint32_t code;
  std::size_t bytes;  ///< 0 where the text is no valid UTF-8
};

bool is_control(uint32_t code) {
  // C0, DEL and C1, and the marks that turn the direction of a line or break it.
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || (code >= 0x202a && code <= 0x202e) ||
         (code >= 0x2066 && code <= 0x2069) || code == 0x2028 || code == 0x2029;
}

Character first_of(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) < 0x80) return {byte(0), 1};
  const std::size_t bytes = byte(0) >= 0xf0 ? 4 : byte(0) >= 0xe0 ? 3 : 2;
  constexpr uint32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
  if (byte(0) < 0xc2 || byte(0) > 0xf4 || text.size() < bytes) return {0, 0};
  uint32_t code = byte(0) & (0x7fu >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return {0, 0};
    code = code << 6 | (byte(i) & 0x3fu);
  }
  const bool is_surrogate = code >= 0xd800 && code < 0xe000;
  return code < smallest[bytes] || code > 0x10ffff || is_surrogate ? Character{0, 0} : Character{code, bytes};
}

}  // namespace

std::string plain_text(std::string_view text, std::string_view kept) {
  constexpr const char* digits = "0123456789abcdef";
  std::string plain;
  while (!text.empty()) {
    const auto [code, bytes] = first_of(text);
    const std::size_t taken = std::max<std::size_t>(bytes, 1);
    const bool stays = bytes > 0 && (!is_control(code) || (bytes == 1 && kept.find(text[0]) != kept.npos));
    for (const char c : text.substr(0, taken)) {
      const auto byte = static_cast<unsigned char>(c);
      if (stays)
        plain += c;
      else
        plain.append({'\\', 'x', digits[byte >> 4], digits[byte & 15]});
    }
    text.remove_prefix(taken);
  }
  return plain;
}

std::string xml_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : plain_text(text)) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

}  // namespace meniscus::io
