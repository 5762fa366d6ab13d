// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Text that changes nothing but what it says, wherever it is shown.
#pragma once

#include <string>
#include <string_view>

namespace meniscus::io {

/// The text as valid UTF-8 without control characters. Each byte of others is written as \xHH. So a name
/// cannot move the cursor of a terminal, or end a line or a file. `kept` lists control characters that stay.
std::string plain_text(std::string_view text, std::string_view kept = "");

/// Plain text for an XML element or attribute.
std::string xml_escaped(std::string_view text);

}  // namespace meniscus::io
