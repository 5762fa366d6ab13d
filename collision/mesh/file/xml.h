// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Walks through the tags of an XML file.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meniscus::collision {

struct XmlTag {
  std::string_view name;
  std::map<std::string_view, std::string_view> attributes;
  bool opens = true, closes = false;  ///< both for <a/>
  std::string_view text;              ///< between this tag and the next one
};

/// The tags of a text, one after the other. Throws FileDefect where tags do not match, or are nested too
/// deeply. Comments, declarations and CDATA are passed over. Entities stay as they are.
class XmlTags {
 public:
  explicit XmlTags(std::string_view text) : rest_(text) {}

  /// The next tag; none at the end of the text.
  std::optional<XmlTag> next();

 private:
  bool skip_special();
  XmlTag tag(std::string_view inside);
  void read_attributes(XmlTag& tag, std::string_view inside) const;
  void nest(const XmlTag& tag);

  std::string_view rest_;
  std::vector<std::string_view> open_;  ///< names of the elements around
};

}  // namespace meniscus::collision
